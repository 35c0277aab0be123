#pragma once
#include <functional>
#include <string>
#include <vector>

#include "velum/core/Task.h"
#include "velum/scene/Scene.h"

namespace velum::session {

/// A step of growing that was held before it flowed into something else, or was stopped.
struct Leak {
  int structure = 0;
  double distance = 0.0;  ///< up to which it has grown, of its step
  double times = 0.0;     ///< how many times as large its section would become; 0: it was stopped
  bool operator==(const Leak&) const = default;
};

/// The labels hold all growths of the scene.
bool isGrown(const scene::Scene& scene);
/// Says that the labels hold no growths yet: before the first one is added, and when they have been read.
void markGiven(scene::LabelLayer& labels);
/// Grows all that the scene asks for, at once. Any thread.
/// @return what the user should know, one line each  @throw Cancelled
std::vector<std::string> settleGrowths(scene::Scene& scene, Progress& progress);

/// The last step of a structure; null when it was not grown.
const scene::Growth* lastGrowth(const scene::Scene& scene, int structure);
/// A change of each step of a structure: another range, a gradient stop, barriers. It grows anew from its seeds.
void changeGrowth(scene::Scene& scene, int structure, const std::function<void(scene::Growth&)>& change);
/// Forgets a structure that was grown: its steps, its row, and what cuts spare of it.
void removeGrown(scene::Scene& scene, int structure);

/// The last step of a structure ends where it was held.
void holdGrowth(scene::Scene& scene, const Leak& held);
/// The opposite: it goes as far as the structure is pulled.
void growOn(scene::Scene& scene, int structure);

}  // namespace velum::session
