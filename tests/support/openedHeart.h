#pragma once
#include "scene/Scene.h"
#include "session/membrane/MembraneEdit.h"

namespace velum::session {

/// A beating heart, opened by a membrane from the front: its contrast, and with it vessels on its wall, is to stay
/// whole.
/// @param volume  the phantom "heart"
inline scene::Scene openedHeart(const Shared<Volume>& volume, scene::Repositioning repositioning) {
  scene::Scene scene;
  scene.volume.data = volume;
  scene::Cut cut;
  cut.id = 1;
  cut.shape = scene::CutShape::Membrane;
  cut.membrane.emplace();
  cut.centre = {5, -30, -15};
  cut.axis = {0, -1, 0};
  cut.size = {165, 140, 80};
  cut.membrane->repositioning = repositioning;
  protectValues(*cut.membrane, 200, 600);
  scene.cuts = {cut};
  return scene;
}

}  // namespace velum::session
