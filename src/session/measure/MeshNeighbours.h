#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace velum::session {

/// For each triangle the triangles beyond its sides 0-1, 1-2 and 2-0; the triangle itself where a side has none. Where
/// more than two meet in an edge, pairs of them are neighbours. O(n log n)
/// @param indices  three a triangle
std::vector<std::array<std::uint32_t, 3>> neighboursOf(std::span<const std::uint32_t> indices);

}  // namespace velum::session
