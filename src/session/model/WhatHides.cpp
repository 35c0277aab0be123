#include "session/model/WhatHides.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/Error.h"
#include "core/ImageChannels.h"
#include "render/kept/KeptInstances.h"
#include "scene/Scene.h"
#include "scene/Shown.h"
#include "session/cut/CutEdit.h"
#include "session/model/TypesAt.h"

namespace velum::session {

namespace {

/// A layer of numbers, pixel by pixel; -1 where there is nothing.
std::vector<std::int64_t> layerOf(const Image& image, const char* name) {
  std::ptrdiff_t column = channelIndex(image, name);
  if (column < 0) throw ArgumentError(fmt::format("the picture has no layer {}", name));
  std::vector<std::int64_t> numbers;
  for (auto i = std::size_t(column); i < image.pixels.size(); i += image.channels.size())
    numbers.push_back(std::int64_t(image.pixels[i]));
  return numbers;
}

/// Whether a scene's cuts clear each instance for a view; empty: none.
std::vector<bool> clearedInstances(const scene::Scene& scene, double aspect) {
  bool hasFocus = std::ranges::any_of(scene::enabledOf(scene.cuts),
                                      [](const scene::Cut& cut) { return cut.model.focus.has_value(); });
  std::vector<bool> cleared;
  if (!hasFocus) return cleared;
  for (render::InstanceState state : render::instanceStates(scene, {}, aspect))
    cleared.push_back(state == render::InstanceState::Cleared);
  return cleared;
}

std::string percent(double share) { return fmt::format("{:.0f} %", 100.0 * share); }

std::string wordsOf(const scene::Scene& scene, const Hiding& hiding) {
  std::string name = nameAt(scene, hiding.path);
  if (hiding.pixels == 0) return fmt::format("{} is not drawn, or outside of the picture", name);
  if (hiding.seen == hiding.pixels) return fmt::format("nothing hides {}", name);
  std::string words =
      fmt::format("{} of {} is hidden", percent(1.0 - double(hiding.seen) / double(hiding.pixels)), name);
  for (std::size_t i = 0; i < std::min<std::size_t>(3, hiding.hiders.size()); ++i) {
    const Hider& hider = hiding.hiders[i];
    words += fmt::format("{} {} by {}", i == 0 ? ":" : ",", percent(hider.share),
                         hider.path.empty() ? "what is no model" : nameAt(scene, hider.path));
  }
  if (hiding.hiders.size() > 3) words += fmt::format(", the rest by {} more", hiding.hiders.size() - 3);
  return words;
}

const Model& modelOf(const scene::Scene& scene) {
  if (!scene.model.data) throw InputError("there is no model: open one first");
  return *scene.model.data;
}

}  // namespace

scene::Scene aloneScene(const scene::Scene& scene, std::string_view path) {
  const Model& model = modelOf(scene);
  TypesAt place = typesAt(model, path);
  scene::Scene alone = scene;
  alone.volume.visible = alone.labels.visible = false;
  for (scene::Surface& surface : alone.surfaces) surface.visible = false;
  for (scene::Cut& cut : alone.cuts) cut.model.focus.reset();
  TypeNumbers others;
  for (std::uint32_t type = 0; type < model.types.size(); ++type)
    if (!std::binary_search(place.types.begin(), place.types.end(), type)) others.push_back(type);
  setTypesVisible(alone, others, false);
  return alone;
}

Hiding whatHides(const scene::Scene& scene, std::string_view path, const Image& alone, const Image& whole) {
  const Model& model = modelOf(scene);
  TypesAt place = typesAt(model, path);
  if (alone.width != whole.width || alone.height != whole.height)
    throw ArgumentError("the two pictures differ in size");
  std::vector<std::int64_t> wanted = layerOf(alone, "type"), owners = layerOf(whole, "type");
  std::vector<std::int64_t> instances = layerOf(alone, "instance");
  std::vector<bool> cleared = clearedInstances(scene, double(whole.width) / whole.height);
  auto firstInstance = std::int64_t(scene.surfaces.size()) + 1;  // see render::Pick
  Hiding hiding;
  hiding.path = place.path;
  std::map<std::string, std::uint64_t> pixels;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i] < 0) continue;
    if (!cleared.empty() && cleared[std::size_t(instances[i] - firstInstance)]) continue;
    ++hiding.pixels;
    std::int64_t owner = owners[i];
    bool isSeen = owner >= 0 && std::binary_search(place.types.begin(), place.types.end(), std::uint32_t(owner));
    hiding.seen += isSeen;
    if (!isSeen) ++pixels[owner < 0 ? std::string() : pathOf(model, model.types[std::size_t(owner)])];
  }
  for (const auto& [hider, count] : pixels)
    hiding.hiders.push_back({hider, count, double(count) / double(hiding.pixels)});
  std::stable_sort(hiding.hiders.begin(), hiding.hiders.end(),
                   [](const Hider& a, const Hider& b) { return a.pixels > b.pixels; });
  hiding.words = wordsOf(scene, hiding);
  return hiding;
}

Hiding whatHides(const scene::Scene& scene, std::string_view path, const TypePicture& picture) {
  Image alone = picture(aloneScene(scene, path));
  return whatHides(scene, path, alone, picture(scene));
}

int clearTheWay(scene::Scene& scene, std::string_view path) {
  TypesAt place = typesAt(modelOf(scene), path);
  auto clears = [](const scene::Cut& cut) {
    return cut.enabled && cut.shape == scene::CutShape::Everywhere && !cut.invert && !cut.joined && cut.model.focus;
  };
  auto found = std::find_if(scene.cuts.begin(), scene.cuts.end(), clears);
  if (found == scene.cuts.end()) {
    scene::Cut cut = makeCut(scene, scene::CutShape::Everywhere);
    cut.name = fmt::format("Way to {}", nameAt(scene, place.path));
    cut.model.focus.emplace();
    int id = scene::addCut(scene, std::move(cut));
    found = scene.cuts.begin() + scene::cutPlace(scene, id);
  }
  std::vector<scene::FocusType>& types = found->model.focus->types;
  if (std::none_of(types.begin(), types.end(), [&](const auto& type) { return type.type == place.path; }))
    types.push_back({place.path});
  return found->id;
}

bool isKeptInView(const scene::Scene& scene, std::string_view path) {
  return std::ranges::any_of(scene::enabledOf(scene.cuts), [path](const scene::Cut& cut) {
    return cut.model.focus && std::any_of(cut.model.focus->types.begin(), cut.model.focus->types.end(),
                                          [path](const scene::FocusType& type) { return type.type == path; });
  });
}

void endKeepInView(scene::Scene& scene, std::string_view path) {
  auto isIdle = [path](scene::Cut& cut) {
    if (!cut.model.focus) return false;
    std::erase_if(cut.model.focus->types, [path](const scene::FocusType& type) { return type.type == path; });
    if (!cut.model.focus->types.empty()) return false;
    cut.model.focus.reset();
    return cut.shape == scene::CutShape::Everywhere &&
           std::all_of(cut.model.spares.begin(), cut.model.spares.end(),
                       [](const scene::TypeSpare& spare) { return spare.share == 1.0; });
  };
  std::erase_if(scene.cuts, isIdle);
}

std::string clearingWords(const scene::Scene& scene) {
  if (!scene.volume.data) return {};
  return "Only instances are cleared: what the volume shows before them stays; cut it, or choose a look that one sees "
         "through";
}

}  // namespace velum::session
