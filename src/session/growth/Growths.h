#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/Task.h"
#include "core/Volume.h"
#include "growth/GrowOverTime.h"
#include "scene/Growth.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// A step of growing that was held before it flowed into something else, or was stopped.
struct Leak {
  int structure = 0;
  double distance = 0.0;  ///< up to which it has grown, of its step
  double times = 0.0;     ///< how many times as large its section would become; 0: it was stopped
  bool operator==(const Leak&) const = default;
};

/// The steps as they are grown at the scene's time step, see growth::GrowOverTime: what is to be in `grown`.
std::vector<scene::Growth> growthsNow(const scene::Scene& scene);
/// The labels hold all growths of the scene, at its time step.
bool isGrown(const scene::Scene& scene);
/// Says that the labels hold no growths yet: before the first one is added, and when they have been read.
void markGiven(scene::LabelLayer& labels);
/// Grows all that the scene asks for, at once. Any thread.
/// @return what the user should know, one line each  @throw Cancelled
std::vector<std::string> settleGrowths(scene::Scene& scene, Progress& progress);
/// The same for one time step after another. @param known  of those before: saves time
std::vector<std::string> settleGrowths(scene::Scene& scene, growth::GrowOverTime& known, Progress& progress);

/// The last step of a structure; null when it was not grown.
const scene::Growth* lastGrowth(const scene::Scene& scene, int structure);
/// A change of each step of a structure: another range, a gradient stop, barriers, places that are not of it. It grows
/// anew from its seeds, as far as it is pulled: what held it before may be mended.
void changeGrowth(scene::Scene& scene, int structure, const std::function<void(scene::Growth&)>& change);
/// The middles of the voxels along a stroke, each once, in its order. None outside the volume.
std::vector<glm::dvec3> placesAlong(const Volume& volume, std::span<const glm::dvec3> path);
/// A structure that was grown goes on from more places, as far as it goes already: a step that follows its others, so
/// that nothing is grown anew. Of a click, or of a stroke, see placesAlong(). Places whose voxels have no values of its
/// range are left out, and where none is left nothing changes.
/// @return how many it goes on from
std::size_t addSeeds(scene::Scene& scene, int structure, std::span<const glm::dvec3> places);
/// Says of places that they are not of a structure that was grown: it gives up what is nearer to them by values and
/// form, see scene::Growth::others. Each of its steps is told, as any of them may have leaked, and it grows anew, as
/// far as it is pulled. Of a place whose voxel has none of its values the nearest one beside it counts; places that
/// have none, and those that are its seeds, are left out, and where none is left nothing changes.
/// @return how many were added
std::size_t addOthers(scene::Scene& scene, int structure, std::span<const glm::dvec3> places);
/// Forgets a structure that was grown: its steps, its row, and what cuts spare of it.
void removeGrown(scene::Scene& scene, int structure);

/// The last step of a structure ends where it was held.
void holdGrowth(scene::Scene& scene, const Leak& held);
/// The opposite: it goes as far as the structure is pulled.
void growOn(scene::Scene& scene, int structure);

}  // namespace velum::session
