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
  int cut = 0;  ///< id of the cut out of which it is pulled: its supporting plane
  int structure = 0;
  double distance = 0.0;  ///< how far out of the face, scene units
  bool operator==(const Extrusion&) const = default;
};

/// All of a scene, by cut in their order, then by structure.
std::vector<Extrusion> extrusionsOf(const scene::Scene& scene);
/// How far a structure stands out of a cut: 0: not at all; scene::Spare::kEndless: it is left whole.
double extrusionOf(const scene::Cut& cut, int structure);
/// Pulls a structure out of a cut so far; 0 puts it back. The list of spares stays ascending.
void setExtrusion(scene::Cut& cut, int structure, double distance);
/// Puts all of them back that stand out of any cut. What is left whole stays so.
void resetExtrusions(scene::Scene& scene);

/// A moment of an animation in which all of them come out of their cuts one after the other, in the order of
/// extrusionsOf(), each slowly at first and towards its end. Nothing else changes.
/// @param at  0..1: at 0 none stands out, at 1 all do, and the scene is as it was
scene::Scene pulledOut(scene::Scene scene, double at);

/// Whether things can be pulled out of a cut: it is there, and no inlay.
bool canPullFrom(const scene::Cut& cut);

/// Cuts whose face is a plane, at rest at least: a membrane's sheet.
bool isFlat(const scene::Cut& cut);
/// How deep a place lies in what a cut removes, scene units; negative outside. Of a membrane: from its rest plane.
double depthInCut(const scene::Cut& cut, glm::dvec3 world);
/// Out of a cut's face at a place, into what it removes. Unit.
glm::dvec3 pullDirection(const scene::Cut& cut, glm::dvec3 world);

/// The cuts from which a click on a place can pull a structure, the most likely first: those on whose face it lies, and
/// those out of which the structure stands there. Two of them where two extrusions overlap ([ACS] 4.3).
/// @param slack  how far off a face still counts: the place is that of a sample
std::vector<int> cutsUnder(const scene::Scene& scene, glm::dvec3 world, int structure, double slack);

/// A structure that is being pulled: the distance follows the pointer, a unit of length on the projected normal for a
/// unit of length. A value: it keeps the view with which it began.
class ExtrusionDrag {
 public:
  /// @param pixel  where the pointer went down  @param world  what was there
  ExtrusionDrag(const ViewSpace& space, glm::dvec2 pixel, const scene::Cut& cut, glm::dvec3 world, double distance);
  /// How far it is pulled out with the pointer there; never below 0.
  double distanceAt(glm::dvec2 pixel) const;
  /// Where to on the picture the pointer pulls it out: one of (1, 0), (-1, 0), (0, 1), downwards, and (0, -1).
  glm::dvec2 wayOut() const;

 private:
  ViewSpace mSpace;
  glm::dvec2 mFrom;
  glm::dvec3 mPlace, mDirection;
  double mDistance;
};

/// A second plane through the crosshair, joined to one that is there and across it: together they open a wedge towards
/// the eye, out of whose both faces structures can be pulled ([ACS] fig. 6). It comes right behind the first.
/// @return its id; nothing where the cut is no plane or the scene has no room for another
std::optional<int> addJoinedPlane(scene::Scene& scene, int cut);

/// Those of the cuts that are on with which a cut is joined, without itself: it removes only what they remove, too.
std::vector<const scene::Cut*> joinedWith(const scene::Scene& scene, const scene::Cut& cut);

/// The twelve edges of the data's box, two ends each. World.
std::vector<std::vector<glm::dvec3>> boxEdges(const scene::Scene& scene);

/// The parts of a plane's outline that do not bound what it opens together with the planes that it is joined with:
/// there the others remove nothing. None of a plane that stands alone.
/// @param outline  convex, of the plane in the data's box
std::vector<std::vector<glm::dvec3>> partsLeftByOthers(const scene::Scene& scene, const scene::Cut& plane,
                                                       const std::vector<glm::dvec3>& outline);

/// An id that no structure of the scene has; nothing when all 65535 are taken.
std::optional<int> freeStructureId(const scene::Scene& scene);

}  // namespace velum::session
