#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "render/SheetIndices.h"
#include "scene/SectionPlane.h"

namespace velum::render {

/// A section as it is shown: grey values by the window (or colours), structures over them, what is cut away dimmed.
struct SectionImage {
  glm::ivec2 size{0};
  std::vector<std::uint32_t> pixels;  ///< 0xAARRGGBB, sRGB, straight alpha, top row first
};

/// Draws a section on the processor, all cores, no GL. Any thread.
///
/// Where the data ends the scene's background (its lower colour) shows. Voxels are interpolated or blocks, as the scene
/// says; structures lie where their own grid has them in the world, nearest label, with an outline one pixel wide.
/// @param plane  what part of the world; its size is rounded up to whole pixels
SectionImage drawSection(const scene::Scene& scene, const scene::SectionPlane& plane, const SheetIndices& sheets = {});
/// The same for a view of the scene. @param size  pixels, positive
SectionImage drawSection(const scene::Scene& scene, scene::SectionKind kind, glm::ivec2 size);

/// The same rectangle of the world in pixels n times as large, for while something moves.
scene::SectionPlane coarserPlane(scene::SectionPlane plane, int n);

/// What there is at a point of the world.
struct Probe {
  bool inside = false;         ///< in the box of the volume, or of the labels where there is no volume
  std::vector<double> values;  ///< of the nearest voxel: one, or one a channel of a colour or of a mixture
  int structure = 0;           ///< label id where labels are shown; 0 for none
};
Probe probe(const scene::Scene& scene, glm::dvec3 world);

}  // namespace velum::render
