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
/// The counterpart: turns a cut so that this is its frame. @param frame  orthonormal, right-handed
void setCutFrame(scene::Cut& cut, const glm::dmat3& frame);

/// A new cut where it is of use at once, a third of the data in size. A plane goes through the crosshair, across the
/// patient's axis that points to the eye most, and takes what lies before it; a cylinder is bored along the view; a
/// cone opens towards the eye; a box and a sphere lie about the crosshair, or, where that was not moved out of the
/// middle of the data, are brought towards the eye until they open its side.
scene::Cut makeCut(const scene::Scene& scene, scene::CutShape shape);

/// True while nobody has moved the crosshair from where data is opened with it.
bool isCrosshairAtRest(const scene::Scene& scene);

/// What a new cut is called: its shape with a number, that of its place at the end of the list or the next free one.
std::string newCutName(const scene::Scene& scene, scene::CutShape shape);

/// A plane through the middle of the scene that takes away the half before it, as the camera sees it.
scene::Cut cutFacingCamera(const scene::Scene& scene);

/// The plane through three points that takes away the side of the eye; nothing when they lie on a line.
std::optional<scene::Cut> cutThrough(const scene::Scene& scene, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c);

/// The one of the six directions of the patient's axes that is nearest. @param direction  any length; 0 gives +z
glm::dvec3 nearestAxis(glm::dvec3 direction);

/// The cut with its axis along a direction. A plane stays where it crosses the middle of what it showed, and what it
/// takes away lies on the side of the direction; the edges of a box come to lie along the patient's. The frame of a
/// membrane becomes as wide and high as the data is across the direction, about its middle.
scene::Cut alignedCut(const scene::Scene& scene, scene::Cut cut, glm::dvec3 axis);

/// A direction as two angles, degrees: azimuth about the body's long axis from anterior (0) over left (90) to right
/// (-90), elevation towards superior (90).
struct AxisAngles {
  double azimuthDeg = 0;
  double elevationDeg = 0;
};
AxisAngles anglesFromAxis(glm::dvec3 axis);
/// The counterpart, a unit vector without the noise of the sines.
glm::dvec3 axisFromAngles(AxisAngles angles);

/// How far the plane stands from the middle of the scene along its normal, and how far it can go while it meets the
/// scene's box (minus that to plus that).
struct CutPosition {
  double offset = 0;
  double reach = 0;
};
CutPosition cutPosition(const scene::Scene& scene, const scene::Cut& cut);
/// The counterpart: the cut moved along its normal to an offset.
scene::Cut withOffset(const scene::Scene& scene, scene::Cut cut, double offset);

/// Puts a cut that hands have moved in the place of the one with its id; nothing when that has gone. Where a sheet
/// rests is its own affair and stays as it is.
void replaceCut(scene::Scene& scene, scene::Cut moved);

/// Lets the cut leave a structure whole, or spare nothing of it; the list stays ascending.
void setSpared(scene::Cut& cut, int structure, bool spared);
/// The cut leaves all of the structure.
bool isSpared(const scene::Cut& cut, int structure);

// What a cut leaves of the types of a model, by the paths of types and compartments.

/// The row of a path; null where the cut has none of its own.
const scene::TypeSpare* findTypeSpare(const scene::Cut& cut, std::string_view path);
/// What holds for a path: its own row, else that of the nearest compartment above, else that nothing is left.
scene::TypeSpare typeSpareFor(const scene::Cut& cut, std::string_view path);
/// The row of a path, made from what holds for it where there is none.
scene::TypeSpare& ownTypeSpare(scene::Cut& cut, std::string_view path);
/// The share of a path, and of all below it that has none of its own. @param share  0..1
void setTypeShare(scene::Cut& cut, std::string_view path, double share);
/// What is above holds again.
void removeTypeSpare(scene::Cut& cut, std::string_view path);

}  // namespace velum::session
