#include "scene/Scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <unordered_set>
#include <utility>

#include "core/Error.h"
#include "core/Vectors.h"
#include "scene/ModelView.h"
#include "scene/PatientDirections.h"
#include "scene/Shown.h"

namespace velum::scene {

namespace {

/// @param worldFromBox  of places 0..1
void addBox(Bounds& bounds, const glm::dmat4& worldFromBox) {
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec3 world(worldFromBox * glm::dvec4(corner & 1, corner >> 1 & 1, corner >> 2, 1.0));
    bounds.min = glm::min(bounds.min, world);
    bounds.max = glm::max(bounds.max, world);
  }
}

}  // namespace

bool hasData(const Scene& scene) {
  return scene.volume.data || scene.labels.data || !scene.surfaces.empty() || scene.model.data;
}

Bounds computeBounds(const Scene& scene) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Bounds bounds{glm::dvec3(kInfinity), glm::dvec3(-kInfinity)};
  if (scene.volume.data)
    addBox(bounds, worldFromBox(*scene.volume.data));
  else if (scene.labels.data)
    addBox(bounds, worldFromBox(scene.labels.data->dims(), scene.labels.data->worldFromVoxel()));
  for (const auto& surface : scene.surfaces) {
    if (!surface.data) continue;
    for (const auto& p : surface.data->positions) {
      bounds.min = glm::min(bounds.min, glm::dvec3(p));
      bounds.max = glm::max(bounds.max, glm::dvec3(p));
    }
  }
  if (scene.model.data) {
    ModelBox box = worldBoxOfModel(scene);
    bounds.min = glm::min(bounds.min, box.low);
    bounds.max = glm::max(bounds.max, box.high);
  }
  return bounds.min.x <= bounds.max.x ? bounds : Bounds{};
}

namespace {}  // namespace

Camera frameCamera(const Scene& scene, StandardView view, double aspect) {
  struct Side {
    glm::dvec3 toEye, up;
  };
  static const Side kSides[] = {{{0, -1, 0}, {0, 0, 1}},       {{0, 1, 0}, {0, 0, 1}},  {{1, 0, 0}, {0, 0, 1}},
                                {{-1, 0, 0}, {0, 0, 1}},       {{0, 0, 1}, {0, -1, 0}}, {{0, 0, -1}, {0, -1, 0}},
                                {{-0.55, -1, 0.35}, {0, 0, 1}}};
  const Side& side = kSides[static_cast<int>(view)];
  Bounds bounds = computeBounds(scene);
  Camera camera = scene.camera;
  camera.target = (bounds.min + bounds.max) * 0.5;
  camera.up = side.up;
  // Fit the box as it is seen: half its extent along the picture's right and up, at the depth of its nearest corner.
  glm::dvec3 toEye = glm::normalize(side.toEye);
  glm::dvec3 right = glm::normalize(glm::cross(side.up, toEye));
  glm::dvec3 up = glm::cross(toEye, right);
  glm::dvec3 half = solidEdges(bounds.max - bounds.min) * 0.5;
  auto extent = [&](glm::dvec3 axis) { return glm::dot(glm::abs(axis), half); };
  constexpr double kMargin = 1.06;
  if (isModelAlone(scene)) {
    Camera seen = frameModel(scene, {right, up, toEye}, aspect);
    seen.up = side.up;
    return seen;
  }
  double halfHeight = std::max(extent(up), extent(right) / aspect) * kMargin;
  camera.height = 2.0 * halfHeight;
  double distance = halfHeight / std::tan(glm::radians(camera.fieldOfViewDeg) * 0.5) + extent(toEye);
  camera.eye = camera.target + toEye * distance;
  return camera;
}

StandardView defaultView(const Scene& scene) {
  Bounds bounds = computeBounds(scene);
  glm::dvec3 edges = bounds.max - bounds.min;
  // A slab of an MR, mostly of vessels, is seen as it was taken: along its longest ways there would be a strip of it.
  auto modality = scene.volume.data ? scene.volume.data->modality : Modality::Unknown;
  bool isMr = modality == Modality::MR || modality == Modality::Angiography;
  if (edges.z < (isMr ? 0.45 : 0.2) * std::min(edges.x, edges.y)) return StandardView::Superior;
  if (edges.x < 0.2 * std::min(edges.y, edges.z)) return StandardView::Left;
  if (edges.y < 0.2 * std::min(edges.x, edges.z)) return StandardView::Anterior;
  return hasPatientDirections(scene) ? StandardView::Anterior : StandardView::Oblique;
}

const Cut* findCut(const Scene& scene, int id) {
  int place = cutPlace(scene, id);
  return place < 0 ? nullptr : &scene.cuts[std::size_t(place)];
}

Cut* findCut(Scene& scene, int id) { return const_cast<Cut*>(findCut(std::as_const(scene), id)); }

int cutPlace(const Scene& scene, int id) {
  if (id <= 0) return -1;
  auto found = std::find_if(scene.cuts.begin(), scene.cuts.end(), [id](const Cut& cut) { return cut.id == id; });
  return found == scene.cuts.end() ? -1 : int(found - scene.cuts.begin());
}

int nextCutId(const Scene& scene) { return nextId(scene.cuts); }

int addCut(Scene& scene, Cut cut) {
  if (scene.cuts.size() >= kMostCuts)
    throw ArgumentError(fmt::format("a scene holds {} cuts at most; remove one first", kMostCuts));
  cut.id = nextCutId(scene);
  scene.cuts.push_back(std::move(cut));
  return scene.cuts.back().id;
}

void completeItems(Scene& scene) {
  for (Track& track : scene.timeline.tracks)
    if (!std::ranges::is_sorted(track.keys, {}, &Key::time)) std::ranges::stable_sort(track.keys, {}, &Key::time);
  completeIds(scene.cuts);
  completeIds(scene.lettering.captions);
  completeIds(scene.lettering.marks);
  for (auto& cut : scene.cuts) {
    if (!isMembrane(cut))
      cut.membrane.reset();
    else if (!cut.membrane)
      cut.membrane.emplace();
  }
}

glm::dmat4 worldFromCut(const Cut& cut) {
  glm::dvec3 z = unitOr(cut.axis, {0, 0, 1});
  glm::dvec3 helper = std::abs(z.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
  glm::dvec3 x = glm::normalize(glm::cross(helper, z));
  glm::dvec3 y = glm::cross(z, x);
  double c = std::cos(glm::radians(cut.spinDeg)), s = std::sin(glm::radians(cut.spinDeg));
  return {glm::dvec4(c * x + s * y, 0), glm::dvec4(c * y - s * x, 0), glm::dvec4(z, 0), glm::dvec4(cut.centre, 1)};
}

void completeStructures(LabelLayer& labels) {
  if (!labels.data) return;
  std::unordered_set<int> known;
  for (const auto& structure : labels.structures) known.insert(structure.id);
  for (const auto& info : labels.data->table)
    if (known.insert(info.id).second) {
      labels.structures.push_back({info.id, info.name, info.color, info.opacity, true});
      if (info.fileId != 0) labels.structures.back().fileId = std::to_string(info.fileId);
    }
  std::sort(labels.structures.begin(), labels.structures.end(),
            [](const Structure& a, const Structure& b) { return a.id < b.id; });
}

std::uint64_t fileIdOf(const Structure& structure) {
  std::uint64_t number = 0;
  const std::string& text = structure.fileId;
  auto end = std::from_chars(text.data(), text.data() + text.size(), number);
  return end.ec == std::errc() && end.ptr == text.data() + text.size() ? number : 0;
}

bool mixesChannels(const VolumeLayer& layer) {
  return layer.data && !layer.data->isColor && layer.channels.size() > 1 &&
         int(layer.channels.size()) == layer.data->channels;
}

TransferFunction& currentTransfer(VolumeLayer& layer) {
  if (!mixesChannels(layer)) return layer.transfer;
  return layer.channels[std::size_t(std::clamp(layer.channel, 0, int(layer.channels.size()) - 1))].transfer;
}

const TransferFunction& currentTransfer(const VolumeLayer& layer) {
  return currentTransfer(const_cast<VolumeLayer&>(layer));
}

namespace {
glm::dvec2 windowOr(const VolumeLayer& layer, double level, double width) {
  if (width > 0 || !layer.data) return {level, std::max(width, 1e-300)};
  glm::dvec2 range = layer.data->range;
  return {(range.x + range.y) * 0.5, std::max(range.y - range.x, 1e-12)};
}
}  // namespace

glm::dvec2 effectiveWindow(const VolumeLayer& layer, const ChannelLook& look) {
  return windowOr(layer, look.windowLevel, look.windowWidth);
}

glm::dvec2 effectiveWindow(const VolumeLayer& layer) {
  if (mixesChannels(layer))
    return effectiveWindow(layer,
                           layer.channels[std::size_t(std::clamp(layer.channel, 0, int(layer.channels.size()) - 1))]);
  return windowOr(layer, layer.windowLevel, layer.windowWidth);
}

void setWindow(VolumeLayer& layer, double level, double width) {
  bool mixes = mixesChannels(layer);
  ChannelLook* look =
      mixes ? &layer.channels[std::size_t(std::clamp(layer.channel, 0, int(layer.channels.size()) - 1))] : nullptr;
  (look ? look->windowLevel : layer.windowLevel) = level;
  (look ? look->windowWidth : layer.windowWidth) = width;
}

namespace {
bool showsGrey(const Cut& cut) { return isInlay(cut) || cut.face == CutFace::Section; }
}  // namespace

bool usesWindow(const Scene& scene) {
  bool hasGrey = std::ranges::any_of(enabledOf(scene.cuts), showsGrey);
  return hasGrey || scene.rayCast.mode == RenderMode::Mip;
}

Membrane drawnMembrane(Membrane membrane) {
  membrane.field = {};
  Cloth flat;
  flat.particles = membrane.cloth.particles;
  membrane.cloth = flat;
  membrane.repositioning = {};
  membrane.pins.clear();
  return membrane;
}

Scene pictureScene(Scene scene) {
  scene.sections = {}, scene.lettering = {}, scene.timeline = {};
  for (auto& cut : scene.cuts)
    if (cut.membrane) cut.membrane = drawnMembrane(std::move(*cut.membrane));
  if (!usesWindow(scene)) {
    scene.volume.windowLevel = scene.volume.windowWidth = 0.0;
    for (auto& look : scene.volume.channels) look.windowLevel = look.windowWidth = 0.0;
  }
  for (auto& cut : scene.cuts) cut.name.clear();
  for (auto& structure : scene.labels.structures) structure.name.clear(), structure.smoothing = 0.0;
  for (auto& look : scene.volume.channels) look.name.clear();
  dropNames(scene.model);
  // What was grown shows by the labels alone.
  scene.labels.growths.clear(), scene.labels.grown.clear();
  scene.labels.given = scene.labels.unsmoothed = {};
  scene.labels.smoothed.clear();
  return scene;
}

void placeSections(Scene& scene) {
  if (scene.sections.isPlaced) return;
  Bounds bounds = computeBounds(scene);
  scene.sections.crosshair = (bounds.min + bounds.max) * 0.5;
  if (const auto& volume = scene.volume.data) {
    // Onto a voxel, so that the first sections show voxels as they are rather than the mean of two.
    glm::dvec3 voxel(glm::inverse(volume->worldFromVoxel) * glm::dvec4(scene.sections.crosshair, 1.0));
    scene.sections.crosshair = glm::dvec3(volume->worldFromVoxel * glm::dvec4(glm::floor(voxel + 0.5), 1.0));
  }
  scene.sections.isPlaced = true;
}

}  // namespace velum::scene
