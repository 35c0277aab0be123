#include "session/command/ViewCommands.h"

#include "scene/VisibleFrame.h"
#include "session/command/CommandRow.h"

namespace velum::session::detail {

namespace {

using scene::Scene;

Command view(Command row) {
  row.isView = true;
  return row;
}

}  // namespace

std::vector<Command> viewCommands() {
  return {
      view(editRow<LookFrom>(
          "Looks at all that is seen from one side.", "view.from left", "Move view",
          [](Scene& scene, const LookFrom& a) { scene.camera = scene::frameVisible(scene, a.side, a.aspect); })),
      view(editRow<LookFirst>(
          "Looks at all that is seen as when data is opened.", "view.first", "Move view",
          [](Scene& scene, const LookFirst& a) { scene.camera = scene::firstCamera(scene, a.aspect); })),
      view(editRow<PlaceCrosshair>("Puts the crosshair in a place.", "view.crosshair 12,-40,80", "Move view",
                                   [](Scene& scene, const PlaceCrosshair& a) {
                                     scene.sections.crosshair = a.place;
                                     scene.sections.isPlaced = true;
                                   })),
      view(editRow<ChooseLayout>("Chooses which views there are.", "view.layout section", "Move view",
                                 [](Scene& scene, const ChooseLayout& a) { scene.sections.layout = a.layout; })),
  };
}

}  // namespace velum::session::detail
