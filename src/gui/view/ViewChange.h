#pragma once
#include "velum/session/document/Document.h"

namespace velum::gui {

/// The one way in which views change what they show (crosshair, zoom, turn, layout): no edit of the picture.
/// @param change  of the scene's slices; what it does to the rest is dropped
inline void changeSlices(session::Document& document, const session::Document::Change& change) {
  scene::Scene next = document.scene();
  change(next);
  document.view([slices = next.slices](scene::Scene& scene) { scene.slices = slices; });
}

}  // namespace velum::gui
