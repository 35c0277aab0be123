#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/Task.h"
#include "render/SheetIndices.h"
#include "scene/SceneFwd.h"

namespace velum::render {

// What structureHits() says of a structure on whose ray no distance decides.
constexpr float kLeftAlways = -1.0f;
constexpr float kLeftNever = 1e30f;

/// A structure that the ray through a pixel's middle meets, whether or not it is seen there.
struct StructureHit {
  std::uint32_t pixel = 0;      ///< row by row, the top one first
  std::uint16_t structure = 0;  ///< label id, never 0
  bool isLeft = false;          ///< the cuts leave some part of it on the ray
  /// How deep some cuts must leave it in what they remove (scene::Spare::distance) for a part of it to be left on the
  /// ray, scene units; or kLeftAlways, or kLeftNever.
  float depth = kLeftNever;
};

/// All structures that the rays of a picture meet in a scene's label volume, pixel by pixel, then by id. Rays go voxel
/// by voxel; each is asked about its middle on the ray, of the function that draws: shaders/shared/cuts.h, solved for
/// the distance. What is seen, surfaces and looks have no say. Empty where no labels are shown. All cores, no GL. Any
/// thread.
/// @param cuts  ids of those that `depth` is about; all have one distance, others what they spare @throw Cancelled
std::vector<StructureHit> structureHits(const scene::Scene& scene, glm::ivec2 size, const std::vector<int>& cuts,
                                        Progress& progress, const SheetIndices& sheets = {});

}  // namespace velum::render
