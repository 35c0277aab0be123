#pragma once
#include <QPainter>

#include "scene/SectionPlane.h"

namespace velum::gui {

/// What the pointer does to the lines over a section.
struct SectionHints {
  bool showKnobs = false;  ///< The pointer is in the view.
  bool hotKnob = false;    ///< The pointer is on a knob, or drags one.
  bool hasFocus = false;
};

/// Paints what lies over a section: cuts, crosshair, letters, ruler, position, grey window, title.
/// @param plane  in the widget's (logical) pixels
void paintSectionOverlay(QPainter& painter, const scene::Scene& scene, scene::SectionKind kind,
                         const scene::SectionPlane& plane, const SectionHints& hints);

/// The name of a section: "Axial".
QString sectionName(scene::SectionKind kind);

}  // namespace velum::gui
