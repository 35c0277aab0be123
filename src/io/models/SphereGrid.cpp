#include "io/models/SphereGrid.h"

namespace velum::io {

template <class Body>
void SphereGrid::forCells(glm::vec4 sphere, const Body& body) const {
  glm::ivec3 low(glm::floor((glm::vec3(sphere) - sphere.w) / mCell)),
      high(glm::floor((glm::vec3(sphere) + sphere.w) / mCell));
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) {
        // 21 bits an axis: collisions of far cells only cost time.
        auto bits = [](int v) { return std::uint64_t(std::uint32_t(v)) & 0x1fffffu; };
        if (!body((bits(z) << 42) | (bits(y) << 21) | bits(x))) return;
      }
}

void SphereGrid::add(glm::vec4 sphere) {
  auto index = std::uint32_t(mSpheres.size());
  mSpheres.push_back(sphere);
  forCells(sphere, [&](std::uint64_t cell) {
    mCells[cell].push_back(index);
    return true;
  });
}

bool SphereGrid::touches(glm::vec4 sphere) const {
  bool isTouched = false;
  forCells(sphere, [&](std::uint64_t cell) {
    auto at = mCells.find(cell);
    if (at == mCells.end()) return true;
    for (std::uint32_t index : at->second) {
      glm::vec4 other = mSpheres[index];
      glm::vec3 d = glm::vec3(other) - glm::vec3(sphere);
      float reach = other.w + sphere.w;
      if (glm::dot(d, d) < reach * reach) return !(isTouched = true);
    }
    return true;
  });
  return isTouched;
}

}  // namespace velum::io
