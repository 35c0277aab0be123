#pragma once
#include <vector>

#include "core/Task.h"
#include "scene/SceneFwd.h"
#include "session/measure/Left.h"
#include "session/measure/Measure.h"

namespace velum::session {

/// What the cuts leave of a structure: "volume", "share" of it that is left, "surface" with the faces of cuts, and
/// where there is a volume the values in it. @param left  of the structure, by measureLeft()
/// @throw Cancelled; InputError when a brick cannot be read. Any thread.
Measured measureStructure(const scene::Scene& scene, int structure, const StructureLeft& left, Progress& progress);

/// The face that a cut leaves in a structure.
struct FaceArea {
  int cut = 0, structure = 0;  ///< ids
  double area = 0.0;           ///< squared scene units
};
/// The faces of a cut in all structures, ascending by structure; of all cuts, by cut, for 0. Faces in what has no label
/// are not counted. Costs as measureLeft(). @throw Cancelled. Any thread.
std::vector<FaceArea> faceAreas(const scene::Scene& scene, int cut, Progress& progress);
std::vector<FaceArea> faceAreas(const std::map<int, StructureLeft>& left, int cut);

}  // namespace velum::session
