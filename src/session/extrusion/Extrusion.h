#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/Scene.h"
#include "session/ViewSpace.h"

namespace velum::session {

/// A structure that stands out of a cut up to a depth ([ACS] 3): a spare with an end.
struct Extrusion {
  int cut = 0;  ///< id of the cut out of which the structure is pulled: its supporting plane
  int structure = 0;
  double distance = 0.0;  ///< how far out of the face, scene units
  bool operator==(const Extrusion&) const = default;
};

/// All extrusions of a scene: in the order of the cuts, within a cut by structure.
std::vector<Extrusion> extrusionsOf(const scene::Scene& scene);
/// How far a structure stands out of a cut. 0: it does not; scene::Spare::kEndless: the cut leaves it whole.
double extrusionOf(const scene::Cut& cut, int structure);
/// Pulls a structure out of a cut up to a distance, scene units; 0 puts it back. The list of spares stays ascending.
void setExtrusion(scene::Cut& cut, int structure, double distance);
/// Puts back all structures that stand out of any cut. Structures that a cut leaves whole stay whole.
void resetExtrusions(scene::Scene& scene);

/// Whether structures can be pulled out of a cut: the cut is on, and no inlay.
bool canPullFrom(const scene::Cut& cut);

/// True for cuts whose face is a plane, at least at rest: planes, and the sheets of membranes.
bool isFlat(const scene::Cut& cut);
/// How deep a place lies in what a cut removes, scene units; negative outside. For a membrane: from its rest plane.
double depthInCut(const scene::Cut& cut, glm::dvec3 world);
/// The direction out of a cut's face at a place, into what the cut removes. Unit, world.
glm::dvec3 pullDirection(const scene::Cut& cut, glm::dvec3 world);

/// Ids of the cuts from which a click on a place can pull a structure, the most likely first: cuts on whose face the
/// place lies, and cuts out of which the structure stands there. Two of them where two extrusions overlap ([ACS] 4.3).
/// @param slack  how far off a face a place still counts as on it, scene units: the place is that of a sample
std::vector<int> cutsUnder(const scene::Scene& scene, glm::dvec3 world, int structure, double slack);

/// A drag that pulls a structure out: the distance follows the pointer, one unit of length for each unit along the
/// normal of the face as it is seen in the view. A value type: the drag keeps the view with which it began.
class ExtrusionDrag {
 public:
  /// @param pixel  where the pointer went down  @param world  the place that was seen there
  /// @param distance  how far the structure stood out then, scene units
  ExtrusionDrag(const ViewSpace& space, glm::dvec2 pixel, const scene::Cut& cut, glm::dvec3 world, double distance);
  /// How far the structure is pulled out when the pointer is at a pixel, scene units; never below 0.
  double distanceAt(glm::dvec2 pixel) const;
  /// The direction on the picture in which the pointer pulls the structure out: one of (1, 0), (-1, 0), (0, 1), which
  /// is downwards, and (0, -1).
  glm::dvec2 wayOut() const;

 private:
  ViewSpace mSpace;
  glm::dvec2 mFrom;
  glm::dvec3 mPlace, mDirection;
  double mDistance;
};

/// Adds a second plane through the crosshair, joined to a plane that is there and across it: together the planes open a
/// wedge towards the eye, out of whose two faces structures can be pulled ([ACS] fig. 6). The new cut comes right
/// behind the first.
/// @return the id of the new cut; nothing where the given cut is no plane or the scene has no room for another cut
std::optional<int> addJoinedPlane(scene::Scene& scene, int cut);

/// The other enabled cuts with which a cut is joined: it removes only what all of them remove, too.
std::vector<const scene::Cut*> joinedWith(const scene::Scene& scene, const scene::Cut& cut);

/// The twelve edges of the data's box, two ends each. World.
std::vector<std::vector<glm::dvec3>> boxEdges(const scene::Scene& scene);

/// The parts of a plane's outline where a cut that the plane is joined with removes nothing: they do not bound what the
/// joined cuts open together. Empty for a plane that stands alone.
/// @param outline  of the plane in the data's box: convex
std::vector<std::vector<glm::dvec3>> partsLeftByOthers(const scene::Scene& scene, const scene::Cut& plane,
                                                       const std::vector<glm::dvec3>& outline);

/// An id that no structure of the scene has; nothing when all 65535 are taken.
std::optional<int> freeStructureId(const scene::Scene& scene);

}  // namespace velum::session
