#include "membrane/forces/Stakes.h"

#include <algorithm>

#include "core/Assert.h"
#include "core/Parallel.h"
#include "membrane/forces/FrameBox.h"

namespace velum::membrane {

namespace {

/// Voxels nearer than this to the middle of their node are where the corridor takes them to be; in steps of the
/// lattice.
constexpr double kInMiddle = 0.06;
/// Between two columns the sheet may be as far beyond the room of either; in layers.
constexpr double kBeyond = 1.5;

/// Where the sheet may be over a column and over those around it: lowest and highest z.
std::vector<glm::vec2> reachAround(const Corridor& corridor) {
  glm::ivec2 n = corridor.dims;
  std::vector<glm::vec2> reach(corridor.room.size());
  parallelFor(0, n.y, [&](int y) {
    for (int x = 0; x < n.x; ++x) {
      glm::vec2 all(1e30f, -1e30f);
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, n.y - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, n.x - 1); ++u) {
          glm::vec2 room = corridor.room[std::size_t(v * n.x + u)];
          all = {std::min(all.x, room.x), std::max(all.y, room.y)};
        }
      reach[std::size_t(y * n.x + x)] = all;
    }
  });
  return reach;
}

}  // namespace

std::vector<Stake> stakesOf(const ProtectedVoxels& voxels, const scene::Cut& cut, const CutLattice& lattice,
                            const LeastCut& least, const Corridor& corridor) {
  VELUM_ASSERT(holdsItsBox(voxels), "each voxel of the box is decided");
  VELUM_ASSERT(least.dims == corridor.dims, "the corridor is one around this sheet");
  FrameBox frame(cut, voxels.worldFromVoxel);
  glm::ivec3 size = voxels.box.end - voxels.box.min;
  std::vector<glm::vec2> reach = reachAround(corridor);
  auto beyond = float(kBeyond * lattice.step.z);
  std::vector<std::vector<Stake>> layers(std::size_t(std::max(size.z, 0)));
  parallelFor(0, size.z, [&](int z) {
    const std::uint8_t* mask = voxels.mask.data() + std::ptrdiff_t(z) * size.y * size.x;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x, ++mask) {
        if (!*mask) continue;
        glm::dvec3 local = frame.local(glm::dvec3(voxels.box.min + glm::ivec3(x, y, z)));
        glm::dvec3 place = (local - lattice.origin) / lattice.step, node = glm::floor(place + 0.5);
        if (glm::all(glm::lessThan(glm::abs(place - node), glm::dvec3(kInMiddle)))) continue;
        if (node.x < 0 || node.y < 0 || node.x >= lattice.dims.x || node.y >= lattice.dims.y) continue;
        std::size_t column = std::size_t(node.y) * std::size_t(lattice.dims.x) + std::size_t(node.x);
        bool isBelow = node.z < least.below[column];
        auto height = float(local.z);
        if (isBelow ? height + beyond < reach[column].x : height - beyond > reach[column].y) continue;
        layers[std::size_t(z)].push_back({glm::vec3(local), isBelow});
      }
  });
  std::vector<Stake> all;
  for (const auto& layer : layers) all.insert(all.end(), layer.begin(), layer.end());
  return all;
}

}  // namespace velum::membrane
