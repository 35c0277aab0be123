#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/Counts.h"
#include "core/Image.h"
#include "render/kept/StructureHits.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// How much of a picture a structure takes, in pixels. Each pixel whose ray meets the structure is of one kind: these
/// are the bars of [VE] 3 for labels, of which cuts can remove a part. Rays meet voxels as they are; labels without a
/// volume are drawn smoothed, so that half a voxel at an edge counts as hidden even where nothing stands before it.
struct StructureArea {
  int structure = 0;  ///< label id
  std::string name;
  Counts count;  ///< hidden: cuts leave a part of the structure there, but something else is seen; clipped: cuts remove
                 ///< all of it there
  bool operator==(const StructureArea&) const = default;
};

/// True when the structure would be seen wherever nothing removes or hides it: the labels and the structure are shown.
bool isStructureShown(const scene::Scene& scene, int structure);

/// The areas of all structures that the scene lists or the rays meet, ascending by id. Any thread.
/// @param hits  render::structureHits() of the scene
/// @param picture  of the scene, as large as the picture of the rays, with the layers structure and instance
/// (render::Layers), one sample a pixel
std::vector<StructureArea> structureAreas(const scene::Scene& scene, const std::vector<render::StructureHit>& hits,
                                          const Image& picture);

/// One line for each structure: its number, name, visible, hidden, clipped, total; in pixels.
std::string areasCsv(const std::vector<StructureArea>& areas);

}  // namespace velum::session
