#include "session/command/LookCommands.h"

#include <algorithm>
#include <cctype>

#include "scene/Finishes.h"
#include "scene/GreyWindows.h"
#include "scene/LitSpheres.h"
#include "scene/ModelLooks.h"
#include "scene/Presets.h"
#include "scene/SurfaceLook.h"
#include "session/command/CommandRow.h"
#include "session/document/LitSphereFiles.h"
#include "session/look/Look.h"
#include "session/look/ShowThis.h"
#include "session/section/TypedWindow.h"

namespace velum::session::detail {

namespace {

using scene::Scene;

void chooseWindow(Scene& scene, const ChooseWindow& a) {
  if (!scene.volume.data) throw ArgumentError("look.window: there is no volume whose values it could show");
  if (a.window == "whole") return scene::setWindow(scene.volume, 0.0, 0.0);
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

void showTissue(Scene& scene, const ShowThis& a) {
  auto tissue = a.hidden ? hideThis(scene, a.place) : showThis(scene, a.place, a.added);
  if (!tissue) throw ArgumentError(fmt::format("look.showThis {}: that is outside the volume", textOf(a.place)));
}

scene::ChannelLook& channelOf(Scene& scene, int channel) {
  auto& looks = scene.volume.channels;
  if (channel < 0 || std::size_t(channel) >= looks.size())
    throw ArgumentError(fmt::format("channel {}: the volume mixes {}", channel, looks.size()));
  return looks[std::size_t(channel)];
}

void showAlone(Scene& scene, const ShowChannelAlone& a) {
  auto& looks = scene.volume.channels;
  bool isAlone = channelOf(scene, a.channel).visible &&
                 std::count_if(looks.begin(), looks.end(), [](const auto& look) { return look.visible; }) == 1;
  for (std::size_t i = 0; i < looks.size(); ++i) looks[i].visible = isAlone || int(i) == a.channel;
}

/// A user who chooses a lit sphere wants to see it.
void chooseLitSphere(Scene& scene, const ChooseLitSphere& a) {
  auto known = scene::litSpheres();
  bool isKnown = std::any_of(known.begin(), known.end(), [&](const auto& one) { return one.name == a.sphere; }) ||
                 std::any_of(scene.finish.spheres.begin(), scene.finish.spheres.end(),
                             [&](const auto& own) { return own.name == a.sphere; });
  scene.finish.sphere = isKnown ? a.sphere : addLitSphere(scene, a.sphere);
  if (scene.finish.litSphere == 0.0) scene.finish.litSphere = 0.5;
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
      editRow<ChooseModelLook>("Gives a model light, lines and colours that go together.", "look.model soft",
                               "Choose look",
                               [](Scene& scene, const ChooseModelLook& a) { scene::applyModelLook(scene, a.name); }),
      editRow<ChooseWindow>("Sets the grey window of sections.", "look.window bone", "Change window", chooseWindow),
      editRow<ShowThis>(
          "Makes the material at a place seen, and all else a veil.", "look.showThis 12,-40,80",
          [](const Scene&, const ShowThis& a) {
            return std::string(a.hidden ? "Hide this tissue" : "Show this tissue");
          },
          showTissue),
      editRow<ShowChannelAlone>("Shows one of the channels that are mixed alone, or all again.", "look.channelAlone 1",
                                "Show channel alone", showAlone),
      editRow<ColorChannel>(
          "Gives a channel that is mixed a colour.", "look.channelColor 1 0.2,0.9,0.4", "Change channel's colour",
          [](Scene& scene, const ColorChannel& a) { scene::colorChannel(channelOf(scene, a.channel), a.color); }),
      editRow<ChooseLitSphere>("Paints material as a picture of a lit sphere is painted.", "look.litSphere wax",
                               "Choose lit sphere", chooseLitSphere),
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
