#pragma once
#include <QString>

#include "scene/Camera.h"
#include "scene/SceneFwd.h"
#include "scene/Sections.h"

namespace velum::gui {

/// What the sides of what is open are called: "anterior" and "superior" of a patient, "front" and "top" of all else,
/// such as a cell model, on which words of the clinic do not stand. Left and right are its own, as a patient's are.

/// @param axis  of the world, 0 to 2  @param isPlus  the side towards which the axis points
QString sideName(const scene::Scene& scene, int axis, bool isPlus);
/// The side from which a view looks; of an oblique one its name.
QString viewName(const scene::Scene& scene, scene::StandardView view);
/// A letter of the patient's for the side ("R", "S"), or the axis ("-x", "+z").
QString sideSign(const scene::Scene& scene, int axis, bool isPlus);
/// "Axial", or "XY".
QString planeName(const scene::Scene& scene, scene::SectionKind kind);

}  // namespace velum::gui
