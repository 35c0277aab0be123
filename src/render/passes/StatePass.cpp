#include "render/passes/StatePass.h"

#include <algorithm>
#include <utility>

#include "model/FocusRows.h"
#include "model/InstanceRows.h"
#include "render/WorkQueue.h"
#include "render/passes/InstanceViews.h"
#include "shared/bindings.h"

namespace velum::render {

namespace {

constexpr const char* kClipping = "Clipping";
constexpr const char* kFocus = "Focus";

std::vector<model::InstancePart> allParts(const ModelPass& model) {
  return model::instanceParts(model.instanceRoom().instances, model.copies().used(), model.atATime());
}

/// The instances of the types that a cut keeps in view, which follow each other type by type, some at a time.
/// @param cuts  that are enabled
std::vector<model::InstancePart> focusParts(const scene::ModelLayer& layer, const ModelPass& model, std::size_t cuts,
                                            std::size_t cut) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> runs;
  const std::vector<MoleculeType>& types = layer.data->types;
  for (std::size_t t = 0; t < types.size(); ++t) {
    if (model.spareRows()[t * cuts + cut].isFocus == 0.0f || types[t].instanceCount == 0) continue;
    auto first = std::uint32_t(types[t].firstInstance), end = first + std::uint32_t(types[t].instanceCount);
    if (!runs.empty() && runs.back().second == first)
      runs.back().second = end;
    else
      runs.emplace_back(first, end);
  }
  std::vector<model::InstancePart> parts;
  for (const auto& [first, end] : runs)
    for (model::InstancePart part : model::instanceParts(end - first, model.copies().used(), model.atATime())) {
      part.first += first, part.end += first;
      parts.push_back(part);
    }
  return parts;
}

}  // namespace

void StatePass::prepare(FrameData&) {
  if (mModel.hasStates()) mStates.resize(mModel.instanceRoom());
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
  queue.add(kClipping, [this, view = mModel.eyeView(data, sample)] {
    mView.set(view);
    mStates.begin();
  });
  bool hasMembranes = mModel.need().hasMembranes;
  addLooks(
      kClipping, allParts(mModel),
      [this, hasMembranes](const auto& part) { mStates.clip(mModel.programs(), hasMembranes, part); }, queue);
  for (const model::FocusRow& row : model::focusRows(data.frame.scene)) addFocus(data, row, queue);
}

void StatePass::addFocus(const FrameData& data, const model::FocusRow& row, WorkQueue& queue) {
  const Frame& frame = data.frame;
  double aspect = double(frame.pictureSize.x) / frame.pictureSize.y;
  shared::FocusView view = makeFocusView(frame.scene, row, aspect, sceneOrigin(data.grid), sceneRadius(data.grid));
  auto inFocus = focusParts(frame.scene.model, mModel, data.cuts.size(), std::size_t(row.cut));
  bool hasMembranes = mModel.need().hasMembranes;
  queue.add(kFocus, [this, view] { mStates.beginFocus(view); });
  addLooks(
      kFocus, inFocus,
      [this, hasMembranes](const auto& part) { mStates.drawFocus(mModel.programs(), hasMembranes, part); }, queue);
  if (row.hasAperture) queue.add(kFocus, [this] { mStates.flood(mModel.programs()); });
  addLooks(
      kFocus, allParts(mModel),
      [this, hasMembranes](const auto& part) { mStates.clear(mModel.programs(), hasMembranes, part); }, queue);
}

}  // namespace velum::render
