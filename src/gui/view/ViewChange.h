#pragma once
#include "session/document/Document.h"

namespace velum::gui {

/// The one way in which views change what they show (crosshair, zoom, turn, layout): no edit of the picture.
/// @param change  changes the scene's sections; changes of the rest of the scene are dropped
inline void changeSections(session::Document& document, const session::Document::Change& change) {
  scene::Scene next = document.shown();
  change(next);
  document.view([sections = next.sections](scene::Scene& scene) { scene.sections = sections; });
}

}  // namespace velum::gui
