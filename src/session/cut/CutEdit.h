#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include <string_view>

#include "scene/Cut.h"
#include "scene/SceneFwd.h"
#include "scene/Spare.h"

namespace velum::session {

/// The rigid frame of a cut as three unit columns; the third is its axis.
glm::dmat3 cutFrame(const scene::Cut& cut);
/// The counterpart of cutFrame(): turns a cut so that `frame` is its frame. @param frame  orthonormal, right-handed
void setCutFrame(scene::Cut& cut, const glm::dmat3& frame);

/// A new cut where it is of use at once, a third of the data in size. A plane goes through the crosshair, across the
/// patient's axis that points to the eye most, and removes what lies before the plane; a cylinder is bored along the
/// view; a cone opens towards the eye; a box and a sphere lie about the crosshair, or, where the crosshair was not
/// moved out of the middle of the data, are brought towards the eye until they open the side of the data.
scene::Cut makeCut(const scene::Scene& scene, scene::CutShape shape);

/// True while the crosshair is where it was put when the data was opened.
bool isCrosshairAtRest(const scene::Scene& scene);

/// The name of a new cut: its shape with a number, namely how many cuts of this shape there are with the new one, or
/// the next number that is free.
std::string newCutName(const scene::Scene& scene, scene::CutShape shape);

/// A plane through the middle of the scene, across the line of sight, that removes the half before it.
scene::Cut cutFacingCamera(const scene::Scene& scene);

/// The plane through three points that removes the side on which the eye is; nothing when the points lie on a line.
std::optional<scene::Cut> cutThrough(const scene::Scene& scene, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c);

/// The one of the six directions of the patient's axes that is nearest to a direction. @param direction  any length; 0
/// gives +z
glm::dvec3 nearestAxis(glm::dvec3 direction);

/// The cut with its axis along a direction. A plane stays where it crosses the middle of what it showed, and removes
/// what lies on the side to which the direction points; the edges of a box come to lie along the patient's axes. The
/// frame of a membrane becomes as wide and high as the data is across the direction, and is centred on the data.
scene::Cut alignedCut(const scene::Scene& scene, scene::Cut cut, glm::dvec3 axis);

/// A direction as two angles, degrees: azimuth about the body's long axis from anterior (0) over left (90) to right
/// (-90), elevation towards superior (90).
struct AxisAngles {
  double azimuthDeg = 0;
  double elevationDeg = 0;
};
AxisAngles anglesFromAxis(glm::dvec3 axis);
/// The counterpart of anglesFromAxis(): a unit vector without the noise of the sines.
glm::dvec3 axisFromAngles(AxisAngles angles);

/// How far the plane of a cut stands from the middle of the scene along its normal (offset), and how far it can go
/// while it meets the scene's box (from -reach to +reach). Scene units.
struct CutPosition {
  double offset = 0;
  double reach = 0;
};
CutPosition cutPosition(const scene::Scene& scene, const scene::Cut& cut);
/// The counterpart of cutPosition(): the cut moved along its normal to an offset.
scene::Cut withOffset(const scene::Scene& scene, scene::Cut cut, double offset);

/// Puts a cut that hands have moved in the place of the scene's cut with the same id; does nothing when there is none
/// any more. The saved shape of a membrane's sheet is kept from the scene's cut: the sheet itself says where it rests.
void replaceCut(scene::Scene& scene, scene::Cut moved);

/// Makes the cut leave a structure whole (true) or spare nothing of it (false); the list of spares stays ascending.
void setSpared(scene::Cut& cut, int structure, bool spared);
/// The cut leaves all of the structure.
bool isSpared(const scene::Cut& cut, int structure);

// What a cut leaves of the types of a model, by the paths of types and compartments.

/// The cut's own row for a path; null where it has none.
const scene::TypeSpare* findTypeSpare(const scene::Cut& cut, std::string_view path);
/// What holds for a path: its own row, else the row of the nearest compartment above that has one, else that nothing is
/// left.
scene::TypeSpare typeSpareFor(const scene::Cut& cut, std::string_view path);
/// The cut's own row for a path; where there is none, it is made from what typeSpareFor() says.
scene::TypeSpare& ownTypeSpare(scene::Cut& cut, std::string_view path);
/// Sets the share of a path, and so of all paths below it that have no row of their own. @param share  0..1
void setTypeShare(scene::Cut& cut, std::string_view path, double share);
/// Removes the row of a path: what holds for the compartment above then holds for the path again.
void removeTypeSpare(scene::Cut& cut, std::string_view path);

}  // namespace velum::session
