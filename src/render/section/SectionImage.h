#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/VoxelSource.h"
#include "render/SheetIndices.h"
#include "scene/SectionPlane.h"

namespace velum::render {

/// A section as it is shown: grey values by the window (or colours), structures over them, parts that are cut away
/// dimmed.
struct SectionImage {
  glm::ivec2 size{0};
  std::vector<std::uint32_t> pixels;  ///< 0xAARRGGBB, sRGB, straight alpha, top row first
  std::vector<std::uint16_t> structures;  ///< ids, of each pixel the structure that is shown there and that no shown
                                          ///< cut removes; 0: none; empty where no labels are shown
  std::vector<BrickAddress> missing;  ///< of a streamed volume: bricks without which parts of it are coarse
};

/// Whether a section of a streamed volume waits for its bricks, or is drawn of what is in memory.
enum class SectionDetail { Whole, AtOnce };

/// Draws a section on the processor, all cores, no GL. Any thread.
///
/// Beyond the data's end the lower colour of the scene's background shows. Voxels are interpolated or drawn as blocks,
/// as the scene says. Structures are drawn by the nearest label of their own grid, at its place in the world, with an
/// outline one pixel wide.
/// Of a volume that knows finer levels that one is drawn whose voxels are as large as the section's pixels.
/// @param plane  the part of the world that is drawn; its size is rounded up to whole pixels
/// @throw InputError when a brick of a streamed volume cannot be read
SectionImage drawSection(const scene::Scene& scene, const scene::SectionPlane& plane, const SheetIndices& sheets = {},
                         SectionDetail detail = SectionDetail::Whole);
/// Draws one of the scene's sections as its view shows it. @param size  pixels, positive
SectionImage drawSection(const scene::Scene& scene, scene::SectionKind kind, glm::ivec2 size);

/// The same rectangle of the world in pixels n times as large, for drawing while something moves.
scene::SectionPlane coarserPlane(scene::SectionPlane plane, int n);

/// What the scene's data hold at a point of the world.
struct Probe {
  bool inside = false;         ///< the point is in the box of the volume, or of the labels where there is no volume
  std::vector<double> values;  ///< of the nearest voxel: one value, or one for each channel of a colour or of a mixture
  int structure = 0;           ///< label id where labels are shown; 0 for none
};
Probe probe(const scene::Scene& scene, glm::dvec3 world);

}  // namespace velum::render
