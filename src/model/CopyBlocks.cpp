#include "model/CopyBlocks.h"

#include <algorithm>
#include <utility>

#include "shared/instance.h"

namespace velum::model {

namespace {

glm::ivec3 gridOf(const shared::InstanceView& view) { return {view.copiesX, view.copiesY, view.copiesZ}; }

/// Where a sphere lies as a view sees it.
struct Sight {
  const shared::InstanceView& view;
  glm::vec2 half = shared::halfPicture(view.right, view.up);

  /// The sphere around some copies, from the eye.
  glm::vec4 around(glm::ivec3 first, glm::ivec3 count) const {
    glm::vec3 step(view.copyStep), half_ = 0.5f * step * glm::vec3(count - 1);
    glm::vec3 middle = glm::vec3(view.copySphere) + step * glm::vec3(first) + half_ - glm::vec3(view.eye);
    return {middle, view.copySphere.w + glm::length(half_)};
  }
  float depthOf(glm::vec4 sphere) const { return glm::dot(glm::vec3(sphere), glm::vec3(view.forward)); }
  /// What stands before it hides it: nearness for an order.
  float distanceOf(glm::vec4 sphere) const {
    return view.isOrthographic != 0 ? depthOf(sphere) : glm::length(glm::vec3(sphere));
  }
  /// Whether all of it lies behind the eye, or beside the window by a pixel or more.
  bool isOut(glm::vec4 sphere) const {
    float depth = depthOf(sphere);
    if (depth + sphere.w <= 0.0f) return true;
    glm::vec2 at =
        glm::vec2(glm::dot(glm::vec3(sphere), glm::vec3(view.right)), glm::dot(glm::vec3(sphere), glm::vec3(view.up))) /
        half;
    glm::vec2 from = (2.0f * (view.shift - 1.0f) / view.pictureSize - 1.0f) * half;
    glm::vec2 to = (2.0f * (glm::vec2(view.size) + view.shift) / view.pictureSize - 1.0f) * half;
    glm::vec2 low(from.x, -to.y), high(to.x, -from.y);
    bool isFlat = view.isOrthographic != 0;
    glm::vec2 below = isFlat ? low - at : (low * depth - at) / glm::sqrt(1.0f + low * low);
    glm::vec2 above = isFlat ? at - high : (at - high * depth) / glm::sqrt(1.0f + high * high);
    return glm::any(glm::greaterThan(glm::max(below, above), glm::vec2(sphere.w)));
  }
  float pixelsPerLength(float depth) const {
    float perLength = 0.5f * view.pictureSize.y / half.y;
    return view.isOrthographic != 0 ? perLength : perLength / std::max(depth, 1e-6f);
  }
};

/// A cube of copies in the grid, whose edge is a power of kBlockEdge.
struct Cube {
  glm::ivec3 first;
  int edge;
};

/// Calls visit(cube of one block) for those in whose way, from the largest cube on, enters(sphere) never says no.
template <class Enters, class Visit>
void forBlocks(const Sight& sight, const Enters& enters, const Visit& visit) {
  glm::ivec3 grid = gridOf(sight.view);
  int edge = shared::kBlockEdge;
  while (edge < std::max({grid.x, grid.y, grid.z})) edge *= shared::kBlockEdge;
  std::vector<Cube> cubes{{glm::ivec3(0), edge}};
  while (!cubes.empty()) {
    Cube cube = cubes.back();
    cubes.pop_back();
    glm::vec4 sphere = sight.around(cube.first, glm::min(glm::ivec3(cube.edge), grid - cube.first));
    if (!enters(sphere)) continue;
    if (cube.edge == shared::kBlockEdge) {
      visit(cube, sphere);
      continue;
    }
    int part = cube.edge / shared::kBlockEdge;
    glm::ivec3 end = glm::min(cube.first + cube.edge, grid);
    for (int z = cube.first.z; z < end.z; z += part)
      for (int y = cube.first.y; y < end.y; y += part)
        for (int x = cube.first.x; x < end.x; x += part) cubes.push_back({{x, y, z}, part});
  }
}

/// Numbers, the nearest first; of those as near, the lower one.
std::vector<std::uint32_t> sorted(std::vector<std::pair<float, std::uint32_t>>& byDistance) {
  std::sort(byDistance.begin(), byDistance.end());
  std::vector<std::uint32_t> numbers;
  numbers.reserve(byDistance.size());
  for (const auto& [distance, number] : byDistance) numbers.push_back(number);
  return numbers;
}

}  // namespace

glm::vec3 copyShift(const shared::InstanceView& view, std::uint32_t copy) {
  int line = int(copy) / view.copiesX;
  return glm::vec3(int(copy) % view.copiesX, line % view.copiesY, line / view.copiesY) * glm::vec3(view.copyStep);
}

BlocksInView blocksInView(const shared::InstanceView& view) {
  Sight sight{view};
  BlocksInView found;
  glm::ivec3 blocks = (gridOf(view) + shared::kBlockEdge - 1) / shared::kBlockEdge;
  std::vector<std::pair<float, std::uint32_t>> byDistance;
  auto enters = [&](glm::vec4 sphere) {
    ++found.looks;
    return !sight.isOut(sphere);
  };
  forBlocks(sight, enters, [&](const Cube& cube, glm::vec4 sphere) {
    glm::ivec3 at = cube.first / shared::kBlockEdge;
    byDistance.emplace_back(sight.distanceOf(sphere), std::uint32_t((at.z * blocks.y + at.y) * blocks.x + at.x));
  });
  found.blocks = sorted(byDistance);
  return found;
}

std::vector<std::uint32_t> nearCopies(const shared::InstanceView& view, float error, std::size_t most) {
  Sight sight{view};
  auto isNear = [&](glm::vec4 sphere) {
    return error * sight.pixelsPerLength(sight.depthOf(sphere) - sphere.w) > view.detail && !sight.isOut(sphere);
  };
  std::vector<std::pair<float, std::uint32_t>> byDistance;
  glm::ivec3 grid = gridOf(view);
  forBlocks(sight, isNear, [&](const Cube& cube, glm::vec4) {
    glm::ivec3 end = glm::min(cube.first + cube.edge, grid);
    for (int z = cube.first.z; z < end.z; ++z)
      for (int y = cube.first.y; y < end.y; ++y)
        for (int x = cube.first.x; x < end.x; ++x) {
          int copy = (z * grid.y + y) * grid.x + x;
          glm::vec4 sphere = sight.around({x, y, z}, glm::ivec3(1));
          if (copy < view.allCopies && isNear(sphere))
            byDistance.emplace_back(sight.distanceOf(sphere), std::uint32_t(copy));
        }
  });
  std::vector<std::uint32_t> copies = sorted(byDistance);
  copies.resize(std::min(copies.size(), most));
  return copies;
}

}  // namespace velum::model
