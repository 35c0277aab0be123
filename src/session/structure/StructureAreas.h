#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/Counts.h"
#include "core/Image.h"
#include "render/kept/StructureHits.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// How much of a picture a structure takes, in pixels. Each pixel whose ray meets it is of one kind: the bars of
/// [VE] 3 for labels, of which a part can be clipped. Rays meet voxels as they are; labels without a volume are drawn
/// smoothed, so that of an edge half a voxel counts as hidden where nothing stands before it.
struct StructureArea {
  int structure = 0;  ///< label id
  std::string name;
  Counts count;  ///< hidden: cuts leave some of it there, but something else is seen; clipped: they remove all of it
  bool operator==(const StructureArea&) const = default;
};

/// A structure is shown when it can be seen wherever nothing removes or hides it.
bool isStructureShown(const scene::Scene& scene, int structure);

/// The areas of all structures that the scene lists or the rays meet, ascending by id. Any thread.
/// @param hits  of the scene, see render::structureHits()
/// @param picture  of the scene, as large as the rays' picture, with the layers structure and instance
/// (render::Layers),
///   one sample a pixel
std::vector<StructureArea> structureAreas(const scene::Scene& scene, const std::vector<render::StructureHit>& hits,
                                          const Image& picture);

/// A line a structure: its number, name, visible, hidden, clipped, total; pixels.
std::string areasCsv(const std::vector<StructureArea>& areas);

}  // namespace velum::session
