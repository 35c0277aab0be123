#include "session/model/ClipState.h"

#include <algorithm>

#include "scene/Scene.h"
#include "scene/Shown.h"

namespace velum::session {

namespace {

bool isBetween(double share) { return share > 0.0 && share < 1.0; }

bool hasFocus(const scene::Cut& cut) { return cut.model.focus && !cut.model.focus->types.empty(); }

/// Lots decide about some instances of the row's types.
bool isThinned(const scene::Cut& cut, const scene::TypeSpare& spare) {
  // From the share, to either side: where all stay anyway there is nothing to fade.
  bool fades =
      spare.share < 1.0 && spare.falloff != 0.0 && spare.amount > 0.0 && cut.shape != scene::CutShape::Everywhere;
  return isBetween(spare.share) || fades || (hasFocus(cut) && isBetween(spare.viewShare));
}

/// Removes something, whatever is there.
bool isActing(const scene::Cut& cut, std::string_view root) {
  if (hasFocus(cut) || cut.model.leastMass > 0.0 || cut.model.leastCopies > 0.0 ||
      cut.model.mostMass != scene::Spare::kEndless || cut.model.mostCopies != scene::Spare::kEndless)
    return true;
  auto takes = [](const scene::TypeSpare& spare) {
    return spare.share < 1.0 || spare.distance != scene::Spare::kEndless;
  };
  if (std::any_of(cut.model.spares.begin(), cut.model.spares.end(), takes)) return true;
  // What no row speaks of goes.
  return std::none_of(cut.model.spares.begin(), cut.model.spares.end(),
                      [root](const scene::TypeSpare& spare) { return spare.type == root; });
}

}  // namespace

ClipState clipState(const scene::Scene& scene) {
  const auto& model = scene.model.data;
  std::string_view root = model && !model->compartments.empty() ? std::string_view(model->compartments[0].name) : "";
  ClipState state = ClipState::Whole;
  for (const scene::Cut& cut : scene::enabledOf(scene.cuts)) {
    if (!isActing(cut, root)) continue;
    state = ClipState::Cut;
    if (std::any_of(cut.model.spares.begin(), cut.model.spares.end(),
                    [&](const scene::TypeSpare& spare) { return isThinned(cut, spare); }))
      return ClipState::Thinned;
  }
  return state;
}

void showWhole(scene::Scene& scene) {
  for (scene::Cut& cut : scene.cuts) cut.enabled = false;
}

void showCut(scene::Scene& scene) {
  bool isOff = scene::enabledOf(scene.cuts).empty();
  for (scene::Cut& cut : scene.cuts) {
    cut.enabled = cut.enabled || isOff;
    double share = cut.shape == scene::CutShape::Everywhere ? 1.0 : 0.0;
    for (scene::TypeSpare& spare : cut.model.spares) {
      if (isBetween(spare.share)) spare.share = share;
      if (isBetween(spare.viewShare)) spare.viewShare = 0.0;
      spare.falloff = 0.0;
    }
  }
}

}  // namespace velum::session
