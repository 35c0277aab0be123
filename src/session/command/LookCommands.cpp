#include "session/command/LookCommands.h"

#include <cctype>

#include "scene/Finishes.h"
#include "scene/GreyWindows.h"
#include "scene/ModelLooks.h"
#include "scene/Presets.h"
#include "scene/SurfaceLook.h"
#include "session/command/CommandRow.h"
#include "session/look/Look.h"
#include "session/section/TypedWindow.h"

namespace velum::session::detail {

namespace {

using scene::Scene;

void chooseWindow(Scene& scene, const ChooseWindow& a) {
  if (!scene.volume.data) throw ArgumentError("look.window: there is no volume whose values it could show");
  if (auto window = typedWindow(a.window, scene.volume)) return scene::setWindow(scene.volume, window->x, window->y);
  bool isName = !a.window.empty() && std::isalpha(static_cast<unsigned char>(a.window[0]));
  if (isName) scene::applyGreyWindow(scene.volume, a.window);  // says why not
  throw ArgumentError(fmt::format("look.window {}: give {}", a.window, typedWindowForms(scene.volume)));
}

/// A first surface that shows something: where the material becomes visible in the volume picture.
double firstIsoValue(const scene::VolumeLayer& layer) {
  for (const auto& point : layer.transfer.opacities)
    if (point.opacity >= 0.2) return point.value;
  return layer.data ? 0.5 * (layer.data->range.x + layer.data->range.y) : 0.0;
}

void chooseMode(Scene& scene, const ChooseMode& a) {
  scene.rayCast.mode = a.mode;
  if (a.mode == scene::RenderMode::Iso && scene.rayCast.isoValue == 0.0)
    scene.rayCast.isoValue = firstIsoValue(scene.volume);
}

}  // namespace

std::vector<Command> lookCommands() {
  return {
      editRow<ChoosePreset>("Gives the volume colours, opacity and light made for a kind of data.",
                            "look.preset ct-bone", "Choose preset",
                            [](Scene& scene, const ChoosePreset& a) { scene::applyPreset(scene, a.name); }),
      editRow<ChooseFinish>("Gives the picture what an illustrator adds at the end.", "look.finish plate",
                            "Choose finish",
                            [](Scene& scene, const ChooseFinish& a) { scene::applyFinish(scene, a.name); }),
      editRow<ChooseModelLook>("Gives a model light, lines and colours that go together.", "look.model clay",
                               "Choose look",
                               [](Scene& scene, const ChooseModelLook& a) { scene::applyModelLook(scene, a.name); }),
      editRow<ChooseWindow>("Sets the grey window of sections.", "look.window bone", "Change window", chooseWindow),
      editRow<ChooseMode>("Chooses how rays are cast.", "look.mode mip", "Change rendering", chooseMode),
      editRow<MakeSurface>("Makes a look that lets one see through one of surfaces.", "look.surface",
                           "Make the look a surface",
                           [](Scene& scene, const MakeSurface&) { scene::makeSurface(scene); }),
      editRow<ImportLook>("Takes the transfer function of a file.", "look.import bone.vp.json", "Import look",
                          [](Scene& scene, const ImportLook& a, Progress&) { return importLook(scene, a.path); }),
      editRow<SetBackground>("Sets what is behind everything.", "look.background 1,1,1 0.8,0.8,0.8",
                             "Change background",
                             [](Scene& scene, const SetBackground& a) {
                               scene.background.top = a.top;
                               scene.background.bottom = a.bottom;
                             }),
      editRow<HideTable>(
          "Leaves out what is not part of the largest body: a scanner's table, head rests, cables.", "volume.hideTable",
          [](const Scene&, const HideTable& a) { return std::string(a.hidden ? "Hide the table" : "Show the table"); },
          [](Scene& scene, const HideTable& a) { scene.volume.bodyOnly = a.hidden; }),
  };
}

}  // namespace velum::session::detail
