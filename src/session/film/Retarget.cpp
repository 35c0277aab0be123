#include "session/film/Retarget.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/Error.h"
#include "io/labels/ReadLabels.h"
#include "scene/GreyWindows.h"
#include "scene/Presets.h"
#include "scene/timeline/SceneAt.h"
#include "session/document/Open.h"
#include "session/document/SetFields.h"
#include "session/structure/StructureSizes.h"

namespace velum::session {

namespace {

using scene::Scene;

/// From places of one volume to those of another.
struct Carry {
  glm::dvec3 from{0.0}, to{0.0};  ///< the place that goes to the other one
  glm::dvec3 share{1.0};          ///< how ways from there grow, along each axis of the world
  double length = 1.0;            ///< how lengths grow
  glm::dvec3 operator()(glm::dvec3 place) const { return to + (place - from) * share; }
};

Carry byBox(const Scene& before, const Scene& after) {
  scene::Bounds a = scene::computeBounds(before), b = scene::computeBounds(after);
  glm::dvec3 was = a.max - a.min, is = b.max - b.min;
  Carry carry{0.5 * (a.min + a.max), 0.5 * (b.min + b.max), {}, glm::length(is) / std::max(glm::length(was), 1e-12)};
  for (int i = 0; i < 3; ++i) carry.share[i] = was[i] > 0.0 ? is[i] / was[i] : carry.length;
  return carry;
}

struct Ball {
  glm::dvec3 middle;
  double radius;
};

Ball ballOf(const Scene& scene, const std::string& name, Progress& progress) {
  auto found = std::ranges::find(scene.labels.structures, name, &scene::Structure::name);
  if (!scene.labels.data || found == scene.labels.structures.end())
    throw ArgumentError(fmt::format("there is no structure '{}' in {}", name,
                                    scene.labels.source.path.empty() ? "the scene" : scene.labels.source.path));
  StructureSize size = countStructures(*scene.labels.data, progress)[found->id];
  if (size.voxels == 0) throw ArgumentError(fmt::format("the structure '{}' is empty", name));
  return {middleOfStructure(*scene.labels.data, found->id, size), radiusOfStructure(*scene.labels.data, size)};
}

Carry byStructure(const Scene& before, const Scene& after, const std::string& name, Progress& progress) {
  Ball a = ballOf(before, name, progress), b = ballOf(after, name, progress);
  double length = b.radius / a.radius;
  return {a.middle, b.middle, glm::dvec3(length), length};
}

void carryCamera(scene::Camera& camera, const Carry& carry) {
  glm::dvec3 arm = camera.eye - camera.target;
  camera.target = carry(camera.target);
  camera.eye = camera.target + arm * carry.length;
  camera.height *= carry.length;
}

void carryMembrane(scene::Membrane& membrane, const Carry& carry) {
  for (auto& pin : membrane.pins) pin.place = carry(pin.place);
  for (auto& kernel : membrane.field.kernels) kernel.centre = carry(kernel.centre), kernel.radius *= carry.length;
  for (auto& stroke : membrane.field.strokes) {
    for (auto& place : stroke.path) place = carry(place);
    stroke.radius *= carry.length;
  }
  membrane.shape = {};  // of forces of other data
}

void carryPlaces(Scene& scene, const Carry& carry) {
  carryCamera(scene.camera, carry);
  scene.sections.crosshair = carry(scene.sections.crosshair);
  for (auto* section : {&scene.sections.axial, &scene.sections.coronal, &scene.sections.sagittal}) {
    section->pan *= carry.length;
    section->height *= carry.length;
  }
  for (scene::Cut& cut : scene.cuts) {
    cut.centre = carry(cut.centre);
    cut.size *= carry.length;
    for (auto& spare : cut.spares) spare.distance *= carry.length;
    if (cut.membrane) carryMembrane(*cut.membrane, carry);
    if (cut.model.focus && cut.model.focus->lock) carryCamera(cut.model.focus->lock->camera, carry);
  }
  for (scene::Mark& mark : scene.lettering.marks)
    for (auto& point : mark.points) point = carry(point);
}

/// Curves and windows over values of one volume, over those of another.
void carryValues(scene::VolumeLayer& layer, glm::dvec2 was, glm::dvec2 is) {
  double grow = was.y > 0.0 ? is.y / was.y : 1.0;
  auto value = [&](double v) { return is.x + (v - was.x) * grow; };
  auto carryTransfer = [&](scene::TransferFunction& transfer) {
    for (auto& point : transfer.opacities) point.value = value(point.value);
    for (auto& point : transfer.colors) point.value = value(point.value);
    for (auto& point : transfer.gradientOpacities) point.value *= grow;
  };
  carryTransfer(layer.transfer);
  for (auto& channel : layer.channels) carryTransfer(channel.transfer);
  if (layer.windowWidth > 0.0) layer.windowLevel = value(layer.windowLevel), layer.windowWidth *= grow;
}

/// The numbers that structures have in other labels, by those that they had, for all that both have by name.
std::map<int, int> newIds(const scene::LabelLayer& before, const scene::LabelLayer& after) {
  std::map<int, int> ids;
  for (const auto& was : before.structures)
    for (const auto& is : after.structures)
      if (!was.name.empty() && was.name == is.name) ids[was.id] = is.id;
  return ids;
}

/// "spares[3].distance" with another number. @param before  what stands in front of the number
/// @return false where the number is that of a structure which the other labels do not have
bool changeId(std::string& path, const std::string& before, const std::map<int, int>& ids) {
  std::size_t at = path.find(before);
  if (at == path.npos) return true;
  std::size_t begin = at + before.size(), end = path.find(']', begin);
  int id = end == path.npos ? 0 : std::atoi(path.substr(begin, end - begin).c_str());
  if (id == 0) return true;
  auto found = ids.find(id);
  if (found != ids.end()) path.replace(begin, end - begin, std::to_string(found->second));
  return found != ids.end();
}

/// Marks go to the structures of the same names; those of others are left out.
void carryMarks(std::vector<scene::Mark>& marks, const std::map<int, int>& ids) {
  std::erase_if(marks, [&](const scene::Mark& mark) { return mark.structure > 0 && !ids.count(mark.structure); });
  for (scene::Mark& mark : marks)
    if (mark.structure > 0) mark.structure = ids.at(mark.structure);
  for (scene::Mark& mark : marks)
    for (int& structure : mark.pointStructures)
      if (structure > 0) structure = ids.count(structure) ? ids.at(structure) : 0;
}

/// Looks, spares, marks and tracks of structures go to the structures of the same names.
void carryStructures(Scene& scene, const scene::LabelLayer& before) {
  std::map<int, int> ids = newIds(before, scene.labels);
  for (auto& structure : scene.labels.structures)
    for (const auto& was : before.structures) {
      auto found = ids.find(was.id);
      if (found == ids.end() || found->second != structure.id) continue;
      auto file = structure.fileId;
      structure = was;
      structure.id = found->second;
      structure.fileId = file;
    }
  for (scene::Cut& cut : scene.cuts) {
    std::erase_if(cut.spares,
                  [&](const scene::Spare& spare) { return spare.structure > 0 && !ids.count(spare.structure); });
    for (auto& spare : cut.spares)
      if (spare.structure > 0) spare.structure = ids[spare.structure];
    std::ranges::sort(cut.spares, {}, &scene::Spare::structure);
    if (!cut.membrane) continue;
    auto& strengths = cut.membrane->field.byLabel;
    std::erase_if(strengths, [&](const auto& one) { return !ids.count(one.id); });
    for (auto& one : strengths) one.id = ids[one.id];
  }
  carryMarks(scene.lettering.marks, ids);
  std::erase_if(scene.timeline.tracks, [&](scene::Track& track) {
    return !changeId(track.path, "labels.structures[#", ids) || !changeId(track.path, "].spares[", ids);
  });
}

void dropTracks(Scene& scene, std::string_view part) {
  std::erase_if(scene.timeline.tracks, [&](const scene::Track& track) { return track.path.starts_with(part); });
}

std::vector<std::string> namesWithVoxels(const scene::LabelLayer& layer, Progress& progress) {
  std::vector<std::string> names;
  auto sizes = countStructures(*layer.data, progress);
  for (const auto& structure : layer.structures)
    if (!structure.name.empty() && sizes[structure.id].voxels > 0) names.push_back(structure.name);
  return names;
}

/// The structures with voxels in a scene that the other labels do not have, for people; empty: they have all.
std::string tellLost(const scene::LabelLayer& before, const scene::LabelLayer& after, Progress& progress) {
  constexpr std::size_t kNamed = 5;
  if (!before.data) return {};
  std::vector<std::string> lost = namesWithVoxels(before, progress);
  std::erase_if(lost, [&](const std::string& name) {
    return std::ranges::find(after.structures, name, &scene::Structure::name) != after.structures.end();
  });
  if (lost.empty()) return {};
  std::size_t more = lost.size() > kNamed ? lost.size() - kNamed : 0;
  lost.resize(lost.size() - more);
  return fmt::format("without structures that the other labels do not have: {}{}", fmt::join(lost, ", "),
                     more > 0 ? fmt::format(" and {} more", more) : "");
}

/// The scene with the other data in it, at the places and with the values of the one before.
Scene withData(const Scene& scene, const NewData& data, Progress& progress, std::vector<std::string>& notes) {
  Scene out = scene;
  if (!out.labels.growths.empty()) {
    notes.push_back("structures that were grown are left out: they are of other data");
    out.labels.growths.clear();
    out.labels.grown.clear();
  }
  if (!out.surfaces.empty()) {
    notes.push_back("surfaces are left out: they are of other data");
    out.surfaces.clear();
    dropTracks(out, "surfaces");
  }
  out.volume.source = {};
  out.labels.source = {};
  out.labels.structures.clear();
  setField(out, "volume.source.path", data.volume);
  if (!data.labels.empty()) setField(out, "labels.source.path", data.labels);
  auto told = followFields(out, scene, progress);
  notes.insert(notes.end(), told.begin(), told.end());
  if (out.labels.data) scene::completeStructures(out.labels);
  int steps = out.volume.data->timeSteps, channels = out.volume.data->channels;
  out.volume.timeStep = std::clamp(out.volume.timeStep, 0, steps - 1);
  out.volume.channel = std::clamp(out.volume.channel, 0, channels - 1);
  if (steps < 2) dropTracks(out, "volume.timeStep");
  return out;
}

}  // namespace

std::vector<std::string> sharedStructures(const scene::LabelLayer& labels, const std::string& other,
                                          Progress& progress) {
  if (!labels.data) return {};
  scene::LabelLayer read;
  scene::Source source;
  source.path = other;
  read.data = Shared<LabelVolume>(io::readLabels(foundInStore(source), progress));
  scene::completeStructures(read);
  std::vector<std::string> names = namesWithVoxels(labels, progress), others = namesWithVoxels(read, progress);
  std::erase_if(names, [&](const std::string& name) { return std::ranges::find(others, name) == others.end(); });
  return names;
}

Scene retargeted(const Scene& scene, const NewData& data, Progress& progress, std::vector<std::string>& notes) {
  if (!scene.volume.data) throw ArgumentError("the scene has no volume in whose place another one could come");
  Scene out = withData(scene, data, progress, notes);
  Carry carry = data.structure.empty() ? byBox(scene, out) : byStructure(scene, out, data.structure, progress);
  const Volume &was = *scene.volume.data, &is = *out.volume.data;
  bool isAlike = was.modality == is.modality && was.channels == is.channels;
  glm::dvec2 oldWindow = scene::firstWindow(was), newWindow = scene::firstWindow(is);
  auto change = [&](Scene& changed) {
    carryPlaces(changed, carry);
    if (isAlike) carryValues(changed.volume, oldWindow, newWindow);
  };
  change(out);
  scene::changeKeys(out, change);
  carryStructures(out, scene.labels);
  if (std::string lost = tellLost(scene.labels, out.labels, progress); !lost.empty()) notes.push_back(lost);
  if (isAlike) return out;
  out.volume.channels.clear();
  scene::applyPreset(out, scene::choosePreset(is));
  scene::completeChannels(out.volume);
  for (const char* part : {"volume.transfer", "volume.window", "volume.channels"}) dropTracks(out, part);
  notes.push_back("the volume is of another kind: it has the preset that fits it");
  return out;
}

}  // namespace velum::session
