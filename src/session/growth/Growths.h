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

/// A step of growing that was held before it flowed into something else, or that was stopped.
struct Leak {
  int structure = 0;
  double distance = 0.0;  ///< up to which the step has grown, scene units
  double times = 0.0;     ///< how many times as large the section of the structure would become beyond; 0: the step was
                          ///< stopped
  bool operator==(const Leak&) const = default;
};

/// The steps as they are grown at the scene's time step, see growth::GrowOverTime: what LabelLayer::grown is to hold.
std::vector<scene::Growth> growthsNow(const scene::Scene& scene);
/// True when the labels hold all growths of the scene, at its time step.
bool isGrown(const scene::Scene& scene);
/// Marks the labels as holding no growths yet: before the first growth is added, and when labels have been read.
void markGiven(scene::LabelLayer& labels);
/// Grows all regions that the scene asks for, at once. Any thread.
/// @return what the user should know, one line each  @throw Cancelled
std::vector<std::string> settleGrowths(scene::Scene& scene, Progress& progress);
/// The same for one time step after another. @param known  keeps what was grown at the time steps before: saves time
std::vector<std::string> settleGrowths(scene::Scene& scene, growth::GrowOverTime& known, Progress& progress);

/// The last step of growth of a structure; null when the structure was not grown.
const scene::Growth* lastGrowth(const scene::Scene& scene, int structure);
/// Changes each step of a structure: another range, a gradient stop, barriers, places that are not of the structure.
/// The structure then grows anew from its seeds, as far as it is pulled, because what held it before may be mended.
void changeGrowth(scene::Scene& scene, int structure, const std::function<void(scene::Growth&)>& change);
/// The middles of the voxels of the finest level along a stroke, world, each once, in the order of the stroke. Voxels
/// outside the volume are left out.
std::vector<glm::dvec3> placesAlong(const Volume& volume, std::span<const glm::dvec3> path);
/// Lets a structure that was grown go on from more places, as far as it goes already: adds a step behind its other
/// steps, so that nothing is grown anew. The places are those of a click, or of a stroke, see placesAlong(). Places
/// whose voxels have values outside the structure's range are left out, and where no place is left nothing changes.
/// @return from how many places the structure goes on
std::size_t addSeeds(scene::Scene& scene, int structure, std::span<const glm::dvec3> places);
/// Says that places do not belong to a structure that was grown: it gives up what is nearer to these places by values
/// and form, see scene::Growth::others. Each step of the structure gets the places, as any step may have leaked, and
/// the structure grows anew, as far as it is pulled. For a place whose voxel has a value outside the structure's range,
/// the nearest voxel beside it within the range counts; places without such a voxel, and places that are seeds of the
/// structure, are left out, and where no place is left nothing changes.
/// @return how many places were added
std::size_t addOthers(scene::Scene& scene, int structure, std::span<const glm::dvec3> places);
/// Forgets a structure that was grown: its steps, its row, and its spares in all cuts.
void removeGrown(scene::Scene& scene, int structure);

/// Lets the last step of a structure end where it was held.
void holdGrowth(scene::Scene& scene, const Leak& held);
/// The opposite of holdGrowth(): the last step goes as far as the structure is pulled.
void growOn(scene::Scene& scene, int structure);

}  // namespace velum::session
