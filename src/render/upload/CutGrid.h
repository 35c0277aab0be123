#pragma once
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "shared/cuts.h"

namespace velum::shared {

inline bool operator==(const CutData& a, const CutData& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace velum::shared

namespace velum::render {

/// From so many cuts on a grid is made; fewer are quicker looked at one by one.
inline constexpr std::size_t kFewCuts = 8;

/// Which cuts matter where: for each of kCutGrid^3 cells of the data's box those that may remove something of it, in
/// their order. Of a cell that one cut removes whole, where nothing is spared, it is that cut alone.
/// The texels are those that shaders read (common/cuts.glsl): for each cell, x first, then one for all that lies
/// outside, where its list begins; the end of the last; then the lists.
struct CutGrid {
  std::vector<std::uint32_t> texels;  ///< Empty: every cut matters everywhere.

  /// @param cell  its place in the texels; kCutGrid^3: outside
  std::span<const std::uint32_t> cutsIn(std::size_t cell) const {
    return std::span(texels).subspan(texels[cell], texels[cell + 1] - texels[cell]);
  }
};

/// Cost: about the cuts' number times the cells that their faces meet; from the coarsest cells to the finest.
/// @param sceneFromTex  the box, as of FrameParams
/// @param hasSpares  some cut spares something: a cell that one cut removes may still show what it spares
CutGrid makeCutGrid(std::span<const shared::CutData> cuts, const glm::mat4& sceneFromTex, bool hasSpares);

}  // namespace velum::render
