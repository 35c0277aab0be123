#include "LightPass.h"

#include <algorithm>

#include "shared/frame.h"

namespace velum::render {

LightPass::LightPass(gpu::Defines defines) : mLightProgram({"render/light_grid.comp"}) {
  defines.push_back({"GRADIENTS", "0"});
  mExtinctionProgram = gpu::Program({"render/light_extinction.comp"}, defines);
}

void LightPass::resize(glm::dvec3 edges, int longest) {
  mCellMm = std::max(edges.x, std::max(edges.y, edges.z)) / longest;
  glm::ivec3 size = glm::clamp(glm::ivec3(edges / mCellMm + 0.5), glm::ivec3(1), glm::ivec3(longest));
  if (size == mSize) return;
  mSize = size;
  mExtinction = gpu::Texture::make3d("light extinction", gpu::Format::R32f, size);
  mLight = gpu::Texture::make3d("light grid", gpu::Format::Rg8, size);
}

void LightPass::extinction(int z0, int z1) {
  mExtinctionProgram.set(0, z0);
  mExtinction.bindImage(0, gpu::Access::Write);
  gpu::dispatch(mExtinctionProgram, (glm::ivec3(mSize.x, mSize.y, z1 - z0) + 3) / 4);
  gpu::barrier();
}

void LightPass::light(int z0, int z1, glm::vec3 keyTex, glm::vec3 cellTex, double reachCells, bool keepOpenness) {
  mLightProgram.set(0, z0);
  mLightProgram.set(1, keepOpenness ? 1 : 0);
  mLightProgram.set(2, glm::vec4(keyTex, 0.0f));
  mLightProgram.set(3, glm::vec4(cellTex, 0.0f));
  mLightProgram.set(4, float(reachCells));
  mExtinction.bindSampler(shared::kLightUnit);
  mLight.bindImage(0, gpu::Access::ReadWrite);
  gpu::dispatch(mLightProgram, (glm::ivec3(mSize.x, mSize.y, z1 - z0) + 3) / 4);
  gpu::barrier();
}

}  // namespace velum::render
