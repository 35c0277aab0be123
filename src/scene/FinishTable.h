#pragma once
#include <span>

#include "scene/Finishes.h"

namespace velum::scene {

/// A row of the table of finishes: what Finish holds, but for the user's own. Tuned by eye on CT of a head and an
/// abdomen, a labelled torso and a vessel tree, at 800 x 600 and twice that.
struct FinishRow {
  NamedFinish finish;
  double contours = 0.0, contourWidth = 2.4;
  glm::vec3 contourColor{0.05f};
  double creases = 0.6;
  double litSphere = 0.0;
  std::string_view sphere = "porcelain";
  bool structureSpheres = true;
  double hatching = 0.0, hatchWidth = 5.0;
  Paper paper = Paper::None;
  glm::vec3 paperColor{0.96f, 0.94f, 0.89f};
  double paperGrain = 0.5;
};

/// In the order of the window; the first adds nothing.
std::span<const FinishRow> finishTable();

}  // namespace velum::scene
