#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/LabelVolume.h"
#include "core/Shared.h"
#include "core/Task.h"
#include "core/Volume.h"
#include "growth/GrowOverTime.h"
#include "growth/Grower.h"
#include "growth/SmoothRegion.h"
#include "scene/Growth.h"
#include "session/growth/GrowthWorker.h"

namespace velum::session {

using Steps = std::vector<scene::Growth>;

/// What has been grown so far: the labels with the steps that they hold, the last of them perhaps not to its end.
struct Progressed {
  Shared<LabelVolume> labels;
  Steps steps;
  Shared<LabelVolume> rough;   ///< the same before the last step's end; nothing where that is not known
  Shared<LabelVolume> before;  ///< without the last step; nothing where that is not known
  std::int64_t voxels = 0;     ///< of the last step
  std::optional<Leak> leak;
  GrowthFigures figures;  ///< of the last step

  /// Labels that hold all steps to their ends.
  void take(const Shared<LabelVolume>& whole) {
    labels = whole;
    rough = steps.empty() || !growth::isSmoothed(steps.back()) ? whole : Shared<LabelVolume>();
    before = {};
    voxels = 0;
  }
};

/// What is wanted: steps as they are at the time step that is shown, and as they were made.
struct Goal {
  Steps steps, made;
  std::size_t carried = 0;  ///< of the first so many nothing is shown before they are done
  bool operator==(const Goal&) const = default;
  bool isCarried(std::size_t i) const { return i < carried || steps[i].timeStep != made[i].timeStep; }
};

/// True when what is wanted goes on where what there is has come to.
bool isOnTheWay(const Steps& grown, const Steps& wanted);
bool isOnTheWay(const Progressed& now, const Steps& wanted);

/// How closely a structure is watched while it grows.
enum class Watch { Not, Jumps, All };

/// Grows steps a piece at a time, for whoever shows the front as it comes. One thread at a time.
class GrowInParts {
 public:
  /// Goes on for about as long as a piece of work takes. @param ground  labels before all steps  @throw Cancelled
  Progressed growSome(const Shared<Volume>& of, const Shared<LabelVolume>& ground, Progressed to, const Goal& all,
                      const std::function<Watch(int)>& watch, Progress& progress);

 private:
  double growPart(const Shared<Volume>& of, Progressed& to, const scene::Growth& step, double reached, double slabs,
                  Watch watch, Progress& progress);
  void growWhole(const Shared<Volume>& of, Progressed& to, const scene::Growth& step, Progress& progress);

  growth::Grower mGrower;
  growth::GrowOverTime mOverTime;
};

}  // namespace velum::session
