#include "velum/session/growth/Growths.h"

#include <algorithm>
#include <ranges>

#include "velum/extrusion/Grower.h"

namespace velum::session {

bool isGrown(const scene::Scene& scene) { return scene.labels.grown == scene.labels.growths; }

void markGiven(scene::LabelLayer& labels) {
  if (labels.growths.empty() && labels.grown.empty()) labels.given = labels.data;
}

std::vector<std::string> settleGrowths(scene::Scene& scene, Progress& progress) {
  auto& labels = scene.labels;
  if (isGrown(scene) || !scene.volume.data) return {};
  if (labels.grown.empty() && !labels.given) labels.given = labels.data;
  auto grown = extrusion::growLabels(scene.volume.data, labels.given, labels.growths, progress);
  std::vector<std::string> notes = grown->warnings;
  labels.data = labels.growths.empty() ? labels.given : grown;
  labels.grown = labels.growths;
  scene::completeStructures(labels);
  return notes;
}

const scene::Growth* lastGrowth(const scene::Scene& scene, int structure) {
  for (const auto& step : std::views::reverse(scene.labels.growths))
    if (step.structure == structure) return &step;
  return nullptr;
}

void changeGrowth(scene::Scene& scene, int structure, const std::function<void(scene::Growth&)>& change) {
  for (auto& step : scene.labels.growths)
    if (step.structure == structure) change(step);
}

void removeGrown(scene::Scene& scene, int structure) {
  if (!lastGrowth(scene, structure)) return;
  std::erase_if(scene.labels.growths, [&](const auto& step) { return step.structure == structure; });
  std::erase_if(scene.labels.structures, [&](const auto& row) { return row.id == structure; });
  for (auto& cut : scene.cuts)
    std::erase_if(cut.spares, [&](const auto& spare) { return spare.structure == structure; });
}

void holdGrowth(scene::Scene& scene, const Leak& held) {
  for (auto& step : std::views::reverse(scene.labels.growths))
    if (step.structure == held.structure) {
      step.distance = std::min(step.distance, held.distance);
      return;
    }
}

void growOn(scene::Scene& scene, int structure) {
  double distance = 0.0;
  for (const auto& cut : scene.cuts)
    for (const auto& spare : cut.spares)
      if (spare.structure == structure)
        distance = std::max(distance, spare.distance + (scene::isMembrane(cut) ? cut.size.z : 0.0));
  for (auto& step : std::views::reverse(scene.labels.growths))
    if (step.structure == structure) {
      step.distance = std::max(step.distance, distance);
      return;
    }
}

}  // namespace velum::session
