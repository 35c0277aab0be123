#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <unordered_map>
#include <vector>

namespace velum::io {

/// A set of spheres that can be asked whether another sphere touches any of them. The cells of the grid are hashed, so
/// that spheres may lie anywhere.
class SphereGrid {
 public:
  /// @param cell  edge of a cell, of the order of the spheres' diameter
  explicit SphereGrid(float cell) : mCell(cell) {}

  void add(glm::vec4 sphere);
  bool touches(glm::vec4 sphere) const;

 private:
  template <class Body>
  void forCells(glm::vec4 sphere, const Body& body) const;

  float mCell;
  std::vector<glm::vec4> mSpheres;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> mCells;
};

}  // namespace velum::io
