#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/Image.h"
#include "render/kept/StructureHits.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// How much of a picture a structure takes, in pixels. Each pixel whose ray meets it is one of the three: the bars of
/// [VE] 3 for labels, of which a part can be clipped. Rays meet voxels as they are; labels without a volume are drawn
/// smoothed, so that of an edge half a voxel counts as hidden where nothing stands before it.
struct StructureArea {
  int structure = 0;  ///< label id
  std::string name;
  std::uint64_t visible = 0;  ///< shows it
  std::uint64_t hidden = 0;   ///< cuts leave some of it there, but something else is seen
  std::uint64_t clipped = 0;  ///< cuts remove all of it there, or it is not shown
  std::uint64_t left() const { return visible + hidden; }
  std::uint64_t total() const { return visible + hidden + clipped; }
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
