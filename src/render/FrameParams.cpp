#include "render/FrameParams.h"

#include <algorithm>
#include <cstdint>

#include "core/Vectors.h"
#include "scene/Presets.h"
#include "scene/Project.h"

namespace velum::render {

namespace {

glm::vec4 v4(glm::dvec3 v) { return glm::vec4(glm::vec3(v), 0.0f); }

/// Between the scene frame, in doubles, and the data's texture coordinates.
struct Spaces {
  glm::dmat4 sceneFromTex, texFromScene;
};

Spaces spacesOf(const FrameGrid& grid) {
  glm::dmat4 sceneFromTex = grid.worldFromTex;
  sceneFromTex[3] -= glm::dvec4(sceneOrigin(grid), 0.0);
  return {sceneFromTex, glm::inverse(sceneFromTex)};
}

void setSpaces(shared::FrameParams& params, const FrameGrid& grid, double unit) {
  Spaces spaces = spacesOf(grid);
  params.texFromScene = glm::mat4(spaces.texFromScene);
  params.sceneFromTex = glm::mat4(spaces.sceneFromTex);
  if (grid.labelDims.x == 0) return;
  glm::dmat4 toWorld = glm::dmat4(glm::dmat3(unit));
  toWorld[3] = glm::dvec4(sceneOrigin(grid) * unit, 1.0);
  params.labelSize = v4(glm::dvec3(grid.labelDims));
  params.labelFromScene = glm::mat4(glm::inverse(grid.worldFromLabel) * toWorld);
}

void setRays(shared::FrameParams& params, const Frame& frame, const FrameGrid& grid) {
  EyeRays rays = makeEyeRays(frame.scene.camera, double(frame.pictureSize.x) / std::max(1, frame.pictureSize.y),
                             sceneOrigin(grid), sceneRadius(grid));
  params.right = v4(rays.right);
  params.up = v4(rays.up);
  params.forward = v4(rays.forward);
  params.eye = v4(rays.eye);
  params.flags |= rays.isOrthographic ? shared::kFlagOrthographic : 0u;
}

void setGrid(shared::FrameParams& params, const Frame& frame, const FrameGrid& grid) {
  Spaces spaces = spacesOf(grid);
  glm::dmat3 edges(spaces.sceneFromTex);
  glm::dvec3 spacing(glm::length(edges[0]) / grid.dims.x, glm::length(edges[1]) / grid.dims.y,
                     glm::length(edges[2]) / grid.dims.z);
  double smallest = std::min(spacing.x, std::min(spacing.y, spacing.z));
  params.volumeSize = v4(glm::dvec3(grid.dims));
  params.cellGrid = v4(glm::dvec3(grid.cells.size));
  params.cellsPerTex = v4(glm::dvec3(grid.dims) / double(grid.cells.edge));
  params.voxelsPerLength = float(1.0 / smallest);
  // Lengths are in the data's diameter here. Voxels may be as flat as a file says.
  constexpr double kMostSteps = 65536.0;
  params.step = float(std::max(frame.scene.rayCast.stepVoxels * smallest * std::max(1.0, frame.stepFactor),
                               diameterOf(grid) / kMostSteps));
  params.opaqueAlpha = 0.998f;
  // A difference over two voxels along texture axis i is 2/dims[i] of that axis; gradients transform by the inverse
  // transpose.
  glm::dmat4 texFromScene = spaces.texFromScene;
  glm::dmat3 gradient = glm::transpose(glm::dmat3(texFromScene));
  glm::dvec3 perDifference = grid.valueScale * glm::dvec3(grid.dims) * 0.5;
  glm::vec4* rows[] = {&params.normalX, &params.normalY, &params.normalZ};
  for (int i = 0; i < 3; ++i) *rows[i] = v4(glm::dvec3(gradient[0][i], gradient[1][i], gradient[2][i]) * perDifference);
}

void setValues(shared::FrameParams& params, const scene::Scene& scene, const FrameGrid& grid,
               const TransferTable& table) {
  double width = table.domain.y - table.domain.x;
  params.tablePerTexel = float(grid.valueScale / width);
  params.tableOffset = float((grid.valueOffset - table.domain.x) / width);
  params.tablePerValue = float(1.0 / width);
  params.isoValue = float((scene.rayCast.isoValue - table.domain.x) / width);
  params.extinctionUnit = float(table.extinctionUnit);
  params.shownFrom = float(table.shownFrom);
  params.shownTo = float(table.shownTo);
  params.gradientUnit = float(grid.gradientScale);
  params.gradientTableScale = float(1.0 / table.gradientMax);
  glm::dvec2 grey = scene::mixesChannels(scene.volume) ? glm::dvec2(0.5, 1.0) * table.mixedWhite
                                                       : scene::effectiveWindow(scene.volume);
  params.greyScale = float(width / grey.y);
  params.greyOffset = float((table.domain.x - (grey.x - 0.5 * grey.y)) / grey.y);
  params.labelTint = float(scene.labels.tint);
  params.unlabelledOpacity = float(scene.labels.unlabelled);
}

void setLight(shared::FrameParams& params, const scene::Scene& scene) {
  const auto& light = scene.lighting;
  params.ambient = float(light.ambient);
  params.diffuse = float(light.diffuse);
  params.specular = float(light.specular);
  params.shininess = float(light.shininess);
  glm::dvec3 key = unitOr(light.keyDirection, {0, 0, 1});
  scene::CameraBasis basis = scene::cameraBasis(scene.camera);
  params.keyLight = v4(glm::normalize(key.x * basis.right + key.y * basis.up - key.z * basis.forward));
  params.pictureUp = v4(basis.up);
  params.shadowStrength = float(light.shadow);
  params.occlusionStrength = float(light.occlusion);
}

void setFlags(shared::FrameParams& params, const scene::Scene& scene) {
  auto flag = [&](bool on, std::uint32_t bit) { params.flags |= on ? bit : 0u; };
  const auto& light = scene.lighting;
  flag(light.shaded, shared::kFlagShaded);
  flag(scene.rayCast.skipEmpty, shared::kFlagSkipEmpty);
  flag(scene.rayCast.stopOpaque, shared::kFlagStopOpaque);
  flag(scene.rayCast.jitter, shared::kFlagJitter);
  bool mixes = scene::mixesChannels(scene.volume);
  flag(!mixes && !scene.volume.transfer.gradientOpacities.empty(), shared::kFlagGradientOpacity);
  flag(light.shaded && (light.shadow > 0 || light.occlusion > 0), shared::kFlagLightGrid);
  flag(!mixes && scene.rayCast.mode == scene::RenderMode::Mip && scene::isProjectionLook(scene.volume.transfer.preset),
       shared::kFlagValueColors);
}

}  // namespace

shared::FrameParams makeFrameParams(const Frame& frame, const FrameGrid& grid, const TransferTable& table,
                                    double unit) {
  shared::FrameParams params{};
  setSpaces(params, grid, unit);
  setRays(params, frame, grid);
  setGrid(params, frame, grid);
  setValues(params, frame.scene, grid, table);
  setLight(params, frame.scene);
  setFlags(params, frame.scene);
  setSample(params, frame, 0);
  return params;
}

}  // namespace velum::render
