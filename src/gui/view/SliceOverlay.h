#pragma once
#include <QPainter>

#include "velum/scene/SliceFrame.h"

namespace velum::gui {

/// What the pointer does to the lines over a slice.
struct SliceHints {
  bool showKnobs = false;  ///< The pointer is in the view.
  bool hotKnob = false;    ///< It is on a knob, or drags one.
  bool hasFocus = false;
};

/// Paints what lies over a slice: cuts, crosshair, letters, ruler, position, grey window, title.
/// @param frame  in the widget's (logical) pixels
void paintSliceOverlay(QPainter& painter, const scene::Scene& scene, scene::SliceKind kind,
                       const scene::SliceFrame& frame, const SliceHints& hints);

/// "Axial"
QString sliceName(scene::SliceKind kind);

}  // namespace velum::gui
