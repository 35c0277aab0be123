#include "SkipPass.h"

namespace velum::render {

SkipPass::SkipPass() : mOccupancy({"render/occupancy.comp"}), mDistance({"render/skip_distance.comp"}) {}

void SkipPass::run(const SkipOptions& options, glm::ivec3 cells) {
  if (!mMap[0] || mMap[0].size() != cells)
    for (auto& map : mMap) map = gpu::Texture::make3d("skip map", gpu::Format::Rg8ui, cells, gpu::Filter::Nearest);
  glm::ivec3 groups = (cells + 3) / 4;
  mOccupancy.set(0, glm::ivec4(static_cast<int>(options.content), options.hasLabels ? 1 : 0, 0, 0));
  mOccupancy.set(1, glm::ivec4(glm::ivec2(options.visible), glm::ivec2(options.spared)));
  mMap[0].bindImage(0, gpu::Access::Write);
  gpu::dispatch(mOccupancy, groups);
  // x: 0 -> 1, y: 1 -> 0, z: 0 -> 1.
  for (int axis = 0; axis < 3; ++axis) {
    gpu::barrier();
    mMap[axis & 1].bindImage(0, gpu::Access::Read);
    mMap[1 - (axis & 1)].bindImage(1, gpu::Access::Write);
    mDistance.set(0, glm::ivec4(axis == 0, axis == 1, axis == 2, 0));
    gpu::dispatch(mDistance, groups);
  }
  gpu::barrier();
}

}  // namespace velum::render
