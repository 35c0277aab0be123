#include "render/passes/InstancePass.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/Vectors.h"
#include "gpu/GpuError.h"
#include "model/FocusRows.h"
#include "model/InstanceRows.h"
#include "model/Levels.h"
#include "render/WorkQueue.h"
#include "scene/Shown.h"
#include "shared/instance.h"

namespace velum::render {

namespace {

constexpr std::uint32_t kSoftwareCulled = 1u << 17, kHardwareCulled = 1u << 22;  // instances that are culled at a time
constexpr int kSoftwareShaded = 1 << 17;                                         // pixels at a time: some 20 ms
constexpr double kPieceMs = 16.0, kMostGroups = 32768.0;     // of a piece that a software driver draws
constexpr std::uint32_t kMostInstances = 1u << 27;           // over all copies: what numbers have room for
constexpr int kLeastLightEdge = 128, kMostLightEdge = 1024;  // pixels of the light's view
constexpr float kLightDetail = 2.0f;                         // shadows are soft
constexpr float kPreviewDetail = 3.0f;
constexpr float kLargeRadius = 10.0f;  // pixels: see docs/PERFORMANCE.md
constexpr int kTaps = 7;
// What of the pass is timed by itself.
constexpr const char* kClipping = "Clipping";
constexpr const char* kFocus = "Focus";

/// Whether a frame asks what becomes of instances, rather than only draws what is left of them.
bool wantsStates(const Frame& frame) {
  return frame.countsInstances || scene::hasGhosts(frame.scene.model) || !model::focusRows(frame.scene).empty();
}

/// Pixels along each edge of the light's view: about as many as the picture has.
int lightEdge(const Frame& frame) {
  int edge = kLeastLightEdge;
  while (edge < kMostLightEdge && edge < std::max(frame.pictureSize.x, frame.pictureSize.y)) edge *= 2;
  return edge;
}

/// What of the model the picture shows, as the key light sees it: a square about it.
shared::InstanceView lightViewOf(const FrameData& data, const shared::InstanceView& eye) {
  scene::ModelBox box = scene::modelBox(data.frame.scene.model);
  double scale = angstromOf(data);
  glm::dvec3 low = box.low * scale - sceneOrigin(data.grid), high = box.high * scale - sceneOrigin(data.grid);
  glm::dvec3 middle = 0.5 * (low + high);
  double radius = 0.5 * glm::length(high - low);
  glm::dvec3 forward(eye.forward), towards = glm::dvec3(glm::vec3(eye.eye));
  double depth = std::max(glm::dot(middle - towards, forward), 0.0);
  double shown = std::max(glm::length(glm::dvec3(eye.right)), glm::length(glm::dvec3(eye.up))) *
                 (eye.isOrthographic ? 1.0 : std::max(depth, 0.25 * radius)) * 1.4;
  if (shown < radius) middle = towards + forward * depth;
  double reach = std::min(radius, shown);
  shared::InstanceView view = eye;
  glm::dvec3 along = -glm::dvec3(data.params.keyLight);
  glm::dvec3 helper = std::abs(along.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
  glm::dvec3 right = glm::normalize(glm::cross(along, helper)), up = glm::cross(right, along);
  view.eye = glm::vec4(glm::vec3(middle - along * (2.0 * radius)), 0.0f);
  view.right = glm::vec4(glm::vec3(right * reach), 0.0f);
  view.up = glm::vec4(glm::vec3(up * reach), 0.0f);
  view.forward = glm::vec4(glm::vec3(along), 0.0f);
  view.pictureSize = glm::vec2(float(lightEdge(data.frame)));
  view.shift = glm::vec2(0.5f);
  view.isOrthographic = 1;
  view.detail = std::max(kLightDetail, view.detail);
  return view;
}

/// The instances of the types that a cut keeps in view, which follow each other type by type, some at a time.
/// @param spares  [types][cuts]
std::vector<model::InstancePart> focusParts(const scene::ModelLayer& layer,
                                            const std::vector<shared::TypeSpareRow>& spares, std::size_t cuts,
                                            std::size_t cut, std::uint32_t most) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> runs;
  const std::vector<MoleculeType>& types = layer.data->types;
  for (std::size_t t = 0; t < types.size(); ++t) {
    if (spares[t * cuts + cut].isFocus == 0.0f || types[t].instanceCount == 0) continue;
    auto first = std::uint32_t(types[t].firstInstance), end = first + std::uint32_t(types[t].instanceCount);
    if (!runs.empty() && runs.back().second == first)
      runs.back().second = end;
    else
      runs.emplace_back(first, end);
  }
  std::vector<model::InstancePart> parts;
  for (const auto& [first, end] : runs)
    for (model::InstancePart part : model::instanceParts(end - first, scene::copyCount(layer), most)) {
      part.first += first, part.end += first;
      parts.push_back(part);
    }
  return parts;
}

}  // namespace

void InstancePass::prepare(FrameData& data) {
  if (!isModelDrawn(data.frame.scene)) {
    mKey.reset();
    mSet = {};
    mCount = 0;
    mHasStates = false;
    return;
  }
  makeSet(data);
  writeRows(data);
  mHasStates = wantsStates(data.frame);
  if (mHasStates)
    mStates.resize(std::uint32_t(data.frame.scene.model.data->instances.size()),
                   scene::copyCount(data.frame.scene.model));
  mHandedOver.clear();
  mHasMembranes = (data.params.flags & shared::kFlagMembranes) != 0;
  mHasFocus = !model::focusRows(data.frame.scene).empty();
  mHasGhosts = scene::hasGhosts(data.frame.scene.model);
}

void InstancePass::compile(const FrameData&) {
  if (mCount == 0) return;
  if (!mOpenness) mOpenness = gpu::Program({"render/openness.comp"});
  if (!mShade) mShade = gpu::Program({"render/instances.comp"});
  mPrograms.compile(need());
}

bool InstancePass::isReady() {
  return mCount == 0 || (mOpenness.isReady() && mShade.isReady() && mPrograms.compile(need()));
}

model::InstancePrograms::Need InstancePass::need() const { return {culledBy(), mHasMembranes, mHasFocus, mHasGhosts}; }

model::CullBy InstancePass::culledBy() const {
  return mHasStates ? model::CullBy::States : mHasMembranes ? model::CullBy::Membranes : model::CullBy::Cuts;
}

void InstancePass::makeSet(const FrameData& data) {
  const scene::ModelLayer& layer = data.frame.scene.model;
  std::uint64_t count = scene::instanceCount(layer);
  // Lists of draws are buffers' texels, two an instance.
  std::uint64_t most = std::min<std::uint64_t>(kMostInstances, mMostTexels / shared::kDrawRooms);
  if (count > most)
    throw gpu::GpuError(
        fmt::format("{} instances are too many for this driver; {} are the most: take fewer copies", count, most));
  Shared<LevelSet> levels = layer.levels;
  if (!levels) {
    if (!mOwnLevels || mOwnLevelsOf != layer.data.id()) {
      Progress progress;
      mOwnLevels = Shared<LevelSet>(model::computeLevels(*layer.data, progress));
      mOwnLevelsOf = layer.data.id();
    }
    levels = mOwnLevels;
  }
  Key key{layer.data.id(), levels.id(), {sceneOrigin(data.grid), angstromOf(data)}};
  if (!mKey || !(*mKey == key)) {
    if (!mKey || mKey->model != key.model) mEye.forget();
    mSet = {};
    mSet = model::InstanceSet(*layer.data, *levels, key.placement);
    mKey = key;
  }
  mCount = std::uint32_t(count);
  mEye.resize(data.frame.windowSize, std::uint32_t(layer.data->instances.size()), scene::copyCount(layer));
}

void InstancePass::writeRows(const FrameData& data) {
  auto types = model::makeTypeRows(data.frame.scene.model);
  types.resize(std::max<std::size_t>(1, types.size()));
  mTypes = gpu::Buffer("types", std::span<const shared::TypeRow>(types));
  mTypeTexels = gpu::Texture::makeOfBuffer("types", gpu::Format::Rgba32f, mTypes);
  mSpareRows = model::makeTypeSpareRows(data.frame.scene);
  mSpareRows.resize(std::max<std::size_t>(1, mSpareRows.size()));
  mTypeSpares = gpu::Buffer("spares of types", std::span<const shared::TypeSpareRow>(mSpareRows));
  mTypeSpareTexels = gpu::Texture::makeOfBuffer("spares of types", gpu::Format::Rgba32f, mTypeSpares);
}

void InstancePass::bindRows() const {
  mSet.bind();
  mTypeTexels.bindSampler(shared::kTypeUnit);
  mTypeSpareTexels.bindSampler(shared::kTypeSpareUnit);
}

shared::InstanceView InstancePass::viewOf(const FrameData& data, int sample) const {
  const Frame& frame = data.frame;
  shared::FrameParams params = data.params;
  setSample(params, frame, sample);
  scene::CopyGrid copies = scene::copyGrid(frame.scene.model);
  shared::InstanceView view{};
  view.eye = params.eye;
  view.right = params.right;
  view.up = params.up;
  view.forward = params.forward;
  view.pictureSize = params.pictureSize;
  view.shift = glm::vec2(frame.windowOrigin) + 0.5f + params.subpixel;
  double scale = angstromOf(data);
  view.copyStep = glm::vec4(glm::vec3(copies.step * scale), 0.0f);
  glm::dvec3 low = glm::dvec3(frame.scene.model.data->low) * scale,
             high = glm::dvec3(frame.scene.model.data->high) * scale;
  // Balls of coarse levels reach a little beyond the spheres of the atoms.
  view.copySphere =
      glm::vec4(glm::vec3(0.5 * (low + high) - sceneOrigin(data.grid)), 0.55f * float(glm::length(high - low)));
  view.copiesX = copies.counts.x;
  view.copiesY = copies.counts.y;
  view.copies = scene::copyCount(frame.scene.model);
  view.instanceCount = int(frame.scene.model.data->instances.size());
  view.cutCount = int(data.cuts.size());
  view.isOrthographic = (params.flags & shared::kFlagOrthographic) ? 1 : 0;
  view.detail = float(frame.scene.model.detail) * (frame.isPreview ? kPreviewDetail : 1.0f);
  view.largeRadius = kLargeRadius;
  view.wholeInstances = model::wholeInstanceBits(frame.scene);
  view.stateWords = mStates.words();
  return view;
}

/// The next piece of a list takes about as long as is wanted, and at most twice as many groups as the last.
void InstancePass::took(double ms) {
  if (mHandedOver.empty()) return;
  Piece piece = mHandedOver.front();
  mHandedOver.pop_front();
  if (piece.groups == 0) return;
  Pace& pace = mPace[std::size_t(piece.list)];
  // The first piece has the driver compile.
  if (!std::exchange(pace.isKnown, true)) return;
  double wanted = kPieceMs / std::max(ms, 0.01) * piece.groups;
  pace.next = std::uint32_t(std::clamp(wanted, 1.0, std::min(2.0 * piece.groups, kMostGroups)));
}

template <class Run>
void InstancePass::add(WorkQueue& queue, Run run) {
  queue.add(*this, [this, run] {
    mHandedOver.push_back({-1, 0});
    run();
  });
}

std::uint32_t InstancePass::atATime() const { return mIsSoftware ? kSoftwareCulled : kHardwareCulled; }

void InstancePass::addPhase(model::InstanceTarget& target, model::CullBy by, Phase phase, WorkQueue& queue) {
  for (const auto& part : target.partsOf(phase, atATime()))
    add(queue, [this, &target, by, phase, part] {
      bindRows();
      mStates.bind();
      target.cull(mPrograms, by, phase, part);
    });
  add(queue, [this, &target, phase] { target.closeLists(mPrograms, phase); });
}

/// What becomes of each instance does not depend on where in a pixel its ray goes: once a frame.
void InstancePass::addStates(const FrameData& data, WorkQueue& queue) {
  const scene::ModelLayer& model = data.frame.scene.model;
  queue.add(kClipping, [this] { mStates.begin(); });
  for (const auto& part :
       model::instanceParts(std::uint32_t(model.data->instances.size()), scene::copyCount(model), atATime()))
    queue.add(kClipping, [this, part] {
      bindRows();
      mEye.bindView();
      mStates.clip(mPrograms, mHasMembranes, part);
    });
  for (const model::FocusRow& row : model::focusRows(data.frame.scene)) addFocus(data, row, queue);
}

void InstancePass::addFocus(const FrameData& data, const model::FocusRow& row, WorkQueue& queue) {
  const Frame& frame = data.frame;
  double aspect = double(frame.pictureSize.x) / frame.pictureSize.y;
  shared::FocusView view = makeFocusView(frame.scene, row, aspect, sceneOrigin(data.grid), sceneRadius(data.grid));
  const scene::ModelLayer& model = frame.scene.model;
  auto inFocus = focusParts(model, mSpareRows, data.cuts.size(), std::size_t(row.cut), atATime());
  auto all = model::instanceParts(std::uint32_t(model.data->instances.size()), scene::copyCount(model), atATime());
  queue.add(kFocus, [this, view] { mStates.beginFocus(view); });
  auto addLooks = [&](const std::vector<model::InstancePart>& parts, auto look) {
    for (const auto& part : parts)
      queue.add(kFocus, [this, look, part] {
        bindRows();
        mEye.bindView();
        look(part);
      });
  };
  addLooks(inFocus, [this](const auto& part) { mStates.drawFocus(mPrograms, mHasMembranes, part); });
  if (row.hasAperture) queue.add(kFocus, [this] { mStates.flood(mPrograms); });
  addLooks(all, [this](const auto& part) { mStates.clear(mPrograms, mHasMembranes, part); });
}

void InstancePass::addGhosts(model::InstanceTarget& target, const FrameData& data, int sample, WorkQueue& queue) {
  shared::InstanceView view = viewOf(data, sample);
  add(queue, [&target, view] { target.begin(view); });
  addPhase(target, model::CullBy::Ghosts, Phase::All, queue);
  addDraws(target, Phase::All, false, queue);
  add(queue, [this, &target] { target.makePyramid(mPrograms); });
  addDraws(target, Phase::All, true, queue);
}

void InstancePass::addDraws(model::InstanceTarget& target, Phase phase, bool owners, WorkQueue& queue) {
  if (mIsSoftware) {
    add(queue, [this] { mPlace = {}; });
    queue.addUntilDone(*this, [this, &target, phase, owners] { return drawNext(target, phase, owners); });
    return;
  }
  for (int list = 0; list < shared::kDrawLists; ++list)
    add(queue, [this, &target, phase, owners, list] {
      bindRows();
      target.drawList(mPrograms, phase, list, owners);
      gpu::barrier();
    });
}

/// The next piece of what a software driver draws. @return true when it was the last
bool InstancePass::drawNext(model::InstanceTarget& target, Phase phase, bool owners) {
  if (!mPlace.isKnown) {
    mPlace.groups = target.groupCounts(phase);
    mPlace.isKnown = true;
  }
  while (mPlace.list < shared::kDrawLists && mPlace.next >= mPlace.groups[std::size_t(mPlace.list)]) {
    ++mPlace.list;
    mPlace.next = 0;
  }
  if (mPlace.list >= shared::kDrawLists) {
    mHandedOver.push_back({-1, 0});
    return true;
  }
  std::uint32_t left = mPlace.groups[std::size_t(mPlace.list)] - mPlace.next;
  std::uint32_t count = std::min(left, mPace[std::size_t(mPlace.list)].next);
  bindRows();
  target.drawGroups(mPrograms, phase, mPlace.list, owners, mPlace.next, count);
  gpu::barrier();
  mHandedOver.push_back({mPlace.list, count});
  mPlace.next += count;
  return false;
}

void InstancePass::addSteps(const FrameData& data, int sample, WorkQueue& queue) {
  if (mCount == 0) return;
  const scene::Lighting& lighting = data.frame.scene.lighting;
  shared::InstanceView view = viewOf(data, sample);
  model::CullBy by = culledBy();
  add(queue, [this, view] { mEye.begin(view); });
  if (sample == 0 && mHasStates) addStates(data, queue);
  bool wantsLight = lighting.shaded && lighting.shadow > 0 && !data.frame.isPreview;
  if (sample == 0) mHasLight = wantsLight;
  if (sample == 0 && wantsLight) {
    mLightParams = lightViewOf(data, view);
    mLight.resize(glm::ivec2(lightEdge(data.frame)), std::uint32_t(view.instanceCount), view.copies);
    add(queue, [this] {
      mLight.begin(mLightParams);
      mLightParams.size = mLight.size();
      mLightView.set(mLightParams);
    });
    addPhase(mLight, by, Phase::All, queue);
    addDraws(mLight, Phase::All, false, queue);
  }
  addPhase(mEye, by, Phase::SeenBefore, queue);
  addDraws(mEye, Phase::SeenBefore, false, queue);
  add(queue, [this] { mEye.makePyramid(mPrograms); });
  addPhase(mEye, by, Phase::Others, queue);
  addDraws(mEye, Phase::Others, false, queue);
  add(queue, [this] { mEye.makePyramid(mPrograms); });
  addDraws(mEye, Phase::SeenBefore, true, queue);
  addDraws(mEye, Phase::Others, true, queue);
  add(queue, [this, &data, sample] {
    if (sample == 0) mEye.noteSeen(mPrograms);
    beginShading(data, sample);
  });
  // Openness first, all of it: a pixel looks at its neighbours'.
  if (lighting.shaded) addStrips(mOpenness, (data.frame.windowSize + shared::kOpenStep - 1) / shared::kOpenStep, queue);
  addStrips(mShade, data.frame.windowSize, queue);
}

/// Strips of rows, each as much as a software driver has done before anybody notices.
void InstancePass::addStrips(const gpu::Program& program, glm::ivec2 size, WorkQueue& queue) {
  constexpr int kEdge = 8;  // of a group
  int rows = mIsSoftware ? std::max(kSoftwareShaded / std::max(size.x, 1), 1) : size.y;
  rows = (rows + kEdge - 1) / kEdge * kEdge;
  for (int first = 0; first < size.y; first += rows)
    add(queue, [this, &program, size, first, rows] {
      bindShading();
      if (&program == &mOpenness)
        mOpen.bindImage(shared::kOpenImage, gpu::Access::Write);
      else
        mSurfaces.bindImages();
      program.set(0, first);
      gpu::dispatch(program, {(size.x + kEdge - 1) / kEdge, (std::min(rows, size.y - first) + kEdge - 1) / kEdge, 1});
      gpu::barrier();
    });
}

void InstancePass::beginShading(const FrameData& data, int sample) {
  const scene::Scene& scene = data.frame.scene;
  scene::ModelBox box = scene::modelBox(scene.model);
  glm::dvec3 forward(data.params.forward), eye = glm::dvec3(glm::vec3(data.params.eye));
  double scale = angstromOf(data);
  glm::dvec3 low = box.low * scale - sceneOrigin(data.grid), high = box.high * scale - sceneOrigin(data.grid);
  double middle = glm::dot(0.5 * (low + high) - eye, forward);
  double half = 0.5 * glm::dot(glm::abs(forward), high - low);
  bool hasPaper = scene.finish.paper != scene::Paper::None;
  shared::InstanceShade values{};
  values.fogTop = glm::vec4(hasPaper ? scene.finish.paperColor : scene.background.top, 1.0f);
  values.fogBottom = glm::vec4(hasPaper ? scene.finish.paperColor : scene.background.bottom, 1.0f);
  values.fog = float(scene.lighting.fog);
  values.fogNear = float(std::max(0.0, middle - half));
  values.fogFar = float(middle + half);
  values.nearColors = float(scene.model.nearColors);
  values.radius = float(scene.lighting.occlusionRadius * glm::length(high - low));
  values.lightTexel = mHasLight ? 2.0f * glm::length(glm::vec3(mLightParams.up)) / mLightParams.pictureSize.x : 0.0f;
  values.noise = float(std::fmod(0.6180339887498949 * sample, 1.0));
  values.occlusionTaps = data.frame.isPreview ? 3 : kTaps;
  values.firstInstance = firstModelInstance(scene);
  values.firstType = std::uint32_t(data.structures.size());
  values.palette = static_cast<int>(scene.model.palette);
  values.hasLight = mHasLight ? 1 : 0;
  values.angstrom = float(scale);
  values.openShift = glm::ivec2(sample & 1, sample >> 1 & 1);
  mShadeParams.set(values);
  glm::ivec2 places = (mEye.size() + shared::kOpenStep - 1) / shared::kOpenStep;
  if (!mOpen || glm::ivec2(mOpen.size()) != places)
    mOpen = gpu::Texture::make2d("openness", gpu::Format::Rgba32f, places);
}

void InstancePass::bindShading() const {
  bindRows();
  mEye.bindView();
  mLightView.bind(shared::kInstanceLightBinding);
  mShadeParams.bind(shared::kInstanceShadeBinding);
  mEye.bindOwners();
  mEye.bindDepths(shared::kDepthUnit);
  (mHasLight ? mLight : mEye).bindDepths(shared::kShadowUnit);
  mOpen.bindSampler(shared::kOpenUnit);
}

void InstancePass::bind(const FrameData&) const {
  if (mCount > 0) bindRows();
}

}  // namespace velum::render
