#include "render/passes/StatePass.h"

#include <algorithm>
#include <utility>

#include "model/FocusRows.h"
#include "model/InstanceRows.h"
#include "render/WorkQueue.h"
#include "render/passes/InstanceViews.h"
#include "scene/Shown.h"
#include "shared/bindings.h"

namespace velum::render {

namespace {

constexpr const char* kClipping = "Clipping";
constexpr const char* kFocus = "Focus";

std::vector<model::InstancePart> allParts(const scene::ModelLayer& layer, std::uint32_t most) {
  return model::instanceParts(std::uint32_t(layer.data->instances.size()), scene::copyCount(layer), most);
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

void StatePass::prepare(FrameData& data) {
  const scene::ModelLayer& model = data.frame.scene.model;
  if (mModel.hasStates()) mStates.resize(std::uint32_t(model.data->instances.size()), scene::copyCount(model));
}

template <class Look>
void StatePass::addLooks(const char* name, const std::vector<model::InstancePart>& parts, Look look, WorkQueue& queue) {
  for (const auto& part : parts)
    queue.add(name, [this, look, part] {
      mView.bind(shared::kInstanceViewBinding);
      look(part);
    });
}

void StatePass::addSteps(const FrameData& data, int sample, WorkQueue& queue) {
  if (sample != 0 || !mModel.hasStates()) return;
  queue.add(kClipping, [this, view = eyeViewOf(data, sample)] {
    mView.set(view);
    mStates.begin();
  });
  bool hasMembranes = mModel.need().hasMembranes;
  addLooks(
      kClipping, allParts(data.frame.scene.model, mModel.atATime()),
      [this, hasMembranes](const auto& part) { mStates.clip(mModel.programs(), hasMembranes, part); }, queue);
  for (const model::FocusRow& row : model::focusRows(data.frame.scene)) addFocus(data, row, queue);
}

void StatePass::addFocus(const FrameData& data, const model::FocusRow& row, WorkQueue& queue) {
  const Frame& frame = data.frame;
  double aspect = double(frame.pictureSize.x) / frame.pictureSize.y;
  shared::FocusView view = makeFocusView(frame.scene, row, aspect, sceneOrigin(data.grid), sceneRadius(data.grid));
  auto inFocus =
      focusParts(frame.scene.model, mModel.spareRows(), data.cuts.size(), std::size_t(row.cut), mModel.atATime());
  bool hasMembranes = mModel.need().hasMembranes;
  queue.add(kFocus, [this, view] { mStates.beginFocus(view); });
  addLooks(
      kFocus, inFocus,
      [this, hasMembranes](const auto& part) { mStates.drawFocus(mModel.programs(), hasMembranes, part); }, queue);
  if (row.hasAperture) queue.add(kFocus, [this] { mStates.flood(mModel.programs()); });
  addLooks(
      kFocus, allParts(frame.scene.model, mModel.atATime()),
      [this, hasMembranes](const auto& part) { mStates.clear(mModel.programs(), hasMembranes, part); }, queue);
}

}  // namespace velum::render
