#include "session/model/ModelEdit.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "core/Units.h"
#include "scene/Crowd.h"
#include "scene/Scene.h"
#include "session/model/TypesAt.h"

namespace velum::session {

namespace {

/// The entries that a layer lists, by the path of their type; of several entries with one path the first counts.
std::unordered_map<std::string_view, const scene::TypeLook*> looksByPath(const scene::ModelLayer& layer) {
  std::unordered_map<std::string_view, const scene::TypeLook*> looks;
  for (const scene::TypeLook& look : layer.types) looks.try_emplace(look.type, &look);
  return looks;
}

template <class Question>
std::vector<bool> askTypes(const scene::ModelLayer& layer, bool unlisted, Question&& question) {
  if (!layer.data) return {};
  std::vector<bool> answers(layer.data->types.size(), unlisted);
  if (layer.types.empty()) return answers;
  auto looks = looksByPath(layer);
  for (std::size_t i = 0; i < answers.size(); ++i)
    if (auto found = looks.find(pathOf(*layer.data, layer.data->types[i])); found != looks.end())
      answers[i] = question(*found->second);
  return answers;
}

bool saysNothing(const scene::TypeLook& look) { return look == scene::TypeLook{.type = look.type}; }

/// Changes the entries of some types; the entries of other types stay, also entries for types that this model does not
/// have.
template <class Change>
void changeLooks(scene::Scene& scene, const TypeNumbers& types, Change&& change) {
  if (!scene.model.data) return;
  const Model& model = *scene.model.data;
  std::vector<scene::TypeLook>& looks = scene.model.types;
  std::unordered_map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < looks.size(); ++i) places.try_emplace(looks[i].type, i);
  for (std::uint32_t type : types) {
    if (type >= model.types.size()) continue;
    auto [found, isNew] = places.try_emplace(pathOf(model, model.types[type]), looks.size());
    if (isNew) looks.push_back({.type = found->first});
    change(looks[found->second]);
  }
  std::erase_if(looks, saysNothing);
}

}  // namespace

std::string compartmentPath(const Model& model, std::uint32_t compartment) {
  std::string path = model.compartments[compartment].name;
  for (std::int32_t at = model.compartments[compartment].parent; at >= 0;
       at = model.compartments[std::size_t(at)].parent)
    path = model.compartments[std::size_t(at)].name + "." + path;
  return path;
}

TypeNumbers typesBelow(const Model& model, std::uint32_t compartment) {
  std::vector<bool> isBelow(model.compartments.size());
  for (std::size_t i = 0; i < isBelow.size(); ++i) {
    std::int32_t parent = model.compartments[i].parent;  // stands before it
    isBelow[i] = i == compartment || (parent >= 0 && isBelow[std::size_t(parent)]);
  }
  TypeNumbers types;
  for (std::uint32_t i = 0; i < model.types.size(); ++i)
    if (isBelow[model.types[i].compartment]) types.push_back(i);
  return types;
}

std::vector<bool> visibleTypes(const scene::ModelLayer& layer) {
  return askTypes(layer, true, [](const scene::TypeLook& look) { return look.visible; });
}

std::vector<bool> ownColors(const scene::ModelLayer& layer) {
  return askTypes(layer, false, [](const scene::TypeLook& look) { return look.color.has_value(); });
}

std::string typesLabel(const scene::Scene& scene, std::string_view verb, const TypeNumbers& types) {
  bool isOne = types.size() == 1 && scene.model.data && types[0] < scene.model.data->types.size();
  if (isOne) {
    const MoleculeType& type = scene.model.data->types[types[0]];
    std::string own = scene::ownName(scene.model, pathOf(*scene.model.data, type));
    return fmt::format("{} {}", verb, own.empty() ? type.name : own);
  }
  return fmt::format("{} {} types", verb, types.size());
}

std::string nameAt(const scene::Scene& scene, std::string_view path) {
  std::string own = scene::ownName(scene.model, path);
  return own.empty() ? std::string(shortName(path)) : own;
}

void rename(scene::Scene& scene, std::string_view path, std::string_view name) {
  std::vector<scene::TypeLook>& looks = scene.model.types;
  auto found = std::find_if(looks.begin(), looks.end(), [&](const auto& look) { return look.type == path; });
  if (found == looks.end()) found = looks.insert(looks.end(), {.type = std::string(path)});
  found->name = name;
  std::erase_if(looks, saysNothing);
}

void listInLegend(scene::Scene& scene, const std::vector<std::string>& paths, bool listed) {
  std::vector<std::string>& entries = scene.lettering.entries;
  for (const std::string& path : paths) {
    std::erase(entries, path);
    if (listed) entries.push_back(path);
  }
  if (listed) scene.lettering.legend = true;  // who lists something wants to see it
}

void setTypesVisible(scene::Scene& scene, const TypeNumbers& types, bool visible) {
  changeLooks(scene, types, [visible](scene::TypeLook& look) { look.visible = visible; });
}

void setTypesGhosts(scene::Scene& scene, const TypeNumbers& types, std::optional<scene::Ghosts> ghosts) {
  changeLooks(scene, types, [&](scene::TypeLook& look) { look.ghosts = ghosts; });
}

void setTypesColor(scene::Scene& scene, const TypeNumbers& types, std::optional<glm::vec3> color) {
  changeLooks(scene, types, [&](scene::TypeLook& look) { look.color = color; });
}

bool isWithin(std::string_view path, std::string_view compartment) {
  return path.size() > compartment.size() && path.starts_with(compartment) && path[compartment.size()] == '.';
}

namespace {

/// The numbers of drawn instances of what a path is in are no longer true.
void dropDrawnAbove(std::vector<scene::TypeTarget>& targets, std::string_view path) {
  for (scene::TypeTarget& target : targets)
    if (isWithin(path, target.type)) target.rendered.reset();
  std::erase_if(targets, [](const scene::TypeTarget& target) { return !target.rendered && !target.visible; });
}

void setTarget(scene::Scene& scene, const scene::TypeTarget& target) {
  std::vector<scene::TypeTarget>& targets = scene.model.targets;
  auto found = std::find_if(targets.begin(), targets.end(), [&](const auto& one) { return one.type == target.type; });
  if (found == targets.end())
    targets.push_back(target);
  else
    *found = target;
  dropDrawnAbove(targets, target.type);
}

}  // namespace

void setVisibleTarget(scene::Scene& scene, std::string_view path, std::optional<double> visible) {
  if (visible) return setTarget(scene, {std::string(path), std::nullopt, visible});
  std::erase_if(scene.model.targets, [path](const scene::TypeTarget& target) { return target.type == path; });
}

const scene::TypeTarget* targetOf(const scene::ModelLayer& layer, std::string_view path) {
  for (const scene::TypeTarget& target : layer.targets)
    if (target.type == path) return &target;
  return nullptr;
}

void holdDrawn(scene::Scene& scene, std::string_view path, double drawn) {
  setTarget(scene, {std::string(path), drawn, std::nullopt});
}

void dropTargets(scene::Scene& scene, std::string_view path) {
  std::vector<scene::TypeTarget>& targets = scene.model.targets;
  std::erase_if(targets, [path](const auto& target) { return target.type == path || isWithin(target.type, path); });
  dropDrawnAbove(targets, path);
}

std::vector<std::string> heldWithin(const scene::Scene& scene, std::string_view path) {
  std::vector<std::string> within;
  for (const scene::TypeTarget& target : scene.model.targets)
    if (isWithin(target.type, path)) within.push_back(target.type);
  auto isInner = [&](const std::string& one) {
    return std::any_of(within.begin(), within.end(), [&](const std::string& other) { return isWithin(one, other); });
  };
  std::vector<std::string> outer;
  for (const std::string& one : within)
    if (!isInner(one)) outer.push_back(one);
  return outer;
}

std::optional<double> visibleTarget(const scene::Scene& scene, std::string_view path) {
  const scene::TypeTarget* target = targetOf(scene.model, path);
  return target ? target->visible : std::nullopt;
}

void resetTypes(scene::Scene& scene, const TypeNumbers& types) {
  changeLooks(scene, types, [](scene::TypeLook& look) { look = {.type = look.type, .name = look.name}; });
}

bool isSolo(const scene::Scene& scene, const TypeNumbers& types) {
  std::vector<bool> shown = visibleTypes(scene.model);
  auto count = std::size_t(std::count(shown.begin(), shown.end(), true));
  bool areShown = std::all_of(types.begin(), types.end(), [&](auto i) { return i < shown.size() && shown[i]; });
  return !types.empty() && areShown && count == types.size() && count < shown.size();
}

TypeSoloMemory toggleSoloTypes(scene::Scene& scene, const TypeSoloMemory& memory, TypeNumbers types) {
  if (!scene.model.data) return {};
  std::sort(types.begin(), types.end());
  bool ends = isSolo(scene, types);
  std::vector<bool> shown = visibleTypes(scene.model);
  bool isRemembered = memory.shown.size() == shown.size() && isSolo(scene, memory.alone);
  TypeSoloMemory next;
  if (!ends) next = {types, isRemembered ? memory.shown : shown};
  TypeNumbers on, off;
  for (std::uint32_t i = 0; i < shown.size(); ++i) {
    bool isShown = ends ? !isRemembered || memory.shown[i] : std::binary_search(types.begin(), types.end(), i);
    (isShown ? on : off).push_back(i);
  }
  setTypesVisible(scene, on, true);
  setTypesVisible(scene, off, false);
  return next;
}

namespace {

/// A copy of a crowd as a whole.
std::optional<InstancePlace> copyPlace(const scene::Scene& scene, std::uint32_t copy) {
  if (copy >= std::uint32_t(scene::copyCount(scene.model))) return std::nullopt;
  scene::CopyGrid grid = scene::copyGrid(scene.model);
  glm::dvec3 cell(int(copy) % grid.counts.x, int(copy) / grid.counts.x % grid.counts.y,
                  int(copy) / (grid.counts.x * grid.counts.y));
  glm::dvec3 low(scene.model.data->low), high(scene.model.data->high);
  scene::ModelFrame frame = scene::modelFrame(scene);
  InstancePlace place;
  place.middle = frame.worldOf(0.5 * (low + high) + grid.step * cell);
  place.radius = 0.5 * glm::length(high - low) * frame.length;
  place.copy = copy;
  place.isWhole = true;
  return place;
}

}  // namespace

std::optional<InstancePlace> instancePlace(const scene::Scene& scene, std::uint32_t instance) {
  const scene::ModelLayer& layer = scene.model;
  if (!layer.data || layer.data->instances.empty()) return std::nullopt;
  if (scene::isCrowd(layer)) return copyPlace(scene, instance);
  const Model& model = *layer.data;
  auto count = std::uint32_t(model.instances.size());
  scene::CopyGrid grid = scene::copyGrid(layer);
  InstancePlace place;
  place.copy = instance / count;
  if (place.copy >= std::uint32_t(scene::copyCount(layer))) return std::nullopt;
  const Instance& one = model.instances[instance % count];
  const Molecule& molecule = model.molecules[one.molecule];
  int copy = int(place.copy);
  glm::dvec3 cell(copy % grid.counts.x, copy / grid.counts.x % grid.counts.y, copy / (grid.counts.x * grid.counts.y));
  scene::ModelFrame frame = scene::modelFrame(scene);
  place.middle = frame.worldOf(glm::dvec3(one.rotation * molecule.centre + one.position) + grid.step * cell);
  place.radius = molecule.radius * frame.length;
  place.type = molecule.type;
  place.ofType = instance % count - model.types[molecule.type].firstInstance;
  return place;
}

InstancePlace ballAround(const scene::Scene& scene, const TypeNumbers& types) {
  InstancePlace ball;
  if (!scene.model.data) return ball;
  const Model& model = *scene.model.data;
  glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
  auto forInstances = [&](const auto& visit) {
    for (std::uint32_t type : types) {
      if (type >= model.types.size()) continue;
      std::uint32_t first = model.types[type].firstInstance;
      for (std::uint32_t i = first; i < first + model.types[type].instanceCount; ++i) {
        const Molecule& molecule = model.molecules[model.instances[i].molecule];
        visit(glm::dvec3(model.instances[i].rotation * molecule.centre + model.instances[i].position),
              double(molecule.radius));
      }
    }
  };
  forInstances(
      [&](glm::dvec3 at, double radius) { low = glm::min(low, at - radius), high = glm::max(high, at + radius); });
  if (low.x > high.x) return ball;
  glm::dvec3 middle = (low + high) * 0.5;
  double reach = 0.0;
  forInstances([&](glm::dvec3 at, double radius) { reach = std::max(reach, glm::distance(at, middle) + radius); });
  scene::CopyGrid grid = scene::copyGrid(scene.model);
  glm::dvec3 last = grid.step * glm::dvec3(glm::max(grid.counts - 1, 0));
  scene::ModelFrame frame = scene::modelFrame(scene);
  ball.middle = frame.worldOf(middle + last * 0.5);
  ball.radius = (reach + glm::length(last) * 0.5) * frame.length;
  return ball;
}

}  // namespace velum::session
