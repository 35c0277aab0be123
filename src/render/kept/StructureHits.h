#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/Task.h"
#include "render/SheetIndices.h"
#include "scene/SceneFwd.h"

namespace velum::render {

// Values of StructureHit::depth where no distance makes a difference.
constexpr float kLeftAlways = -1.0f;
constexpr float kLeftNever = 1e30f;

/// A structure that the ray through a pixel's middle meets, whether or not it is seen there.
struct StructureHit {
  std::uint32_t pixel = 0;      ///< index of the pixel, row by row from the top
  std::uint16_t structure = 0;  ///< label id, never 0
  bool isLeft = false;          ///< the cuts leave some part of it on the ray
  /// How deep the asked cuts must spare the structure (scene::Spare::distance) for some part of it to be left on the
  /// ray, scene units; or kLeftAlways, or kLeftNever.
  float depth = kLeftNever;
};

/// All structures that the rays of a picture meet in a scene's label volume, pixel by pixel, then by id. Rays go voxel
/// by voxel; each voxel is tested in the middle of its stretch of the ray, by the function that is used in drawing
/// (shaders/shared/cuts.h), solved for the distance. Visibility, surfaces and looks are ignored. Empty where no labels
/// are shown. All cores, no GL. Any thread.
/// @param cuts  ids of the cuts that StructureHit::depth is about, which have a common distance; other cuts keep their
/// own spares @throw Cancelled
std::vector<StructureHit> structureHits(const scene::Scene& scene, glm::ivec2 size, const std::vector<int>& cuts,
                                        Progress& progress, const SheetIndices& sheets = {});

}  // namespace velum::render
