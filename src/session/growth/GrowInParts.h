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

/// What has been grown so far: the labels with the steps that they hold; the last step may not have come to its end.
struct Progressed {
  Shared<LabelVolume> labels;
  Steps steps;
  Shared<LabelVolume> rough;   ///< the labels before the last step's end is smoothed; nothing where they are not known
  Shared<LabelVolume> before;  ///< the labels without the last step; nothing where they are not known
  std::int64_t voxels = 0;     ///< that the last step has grown
  std::optional<Leak> leak;
  GrowthFigures figures;  ///< of the last step

  /// Takes over labels that hold all steps to their ends.
  void take(const Shared<LabelVolume>& whole) {
    labels = whole;
    rough = steps.empty() || !growth::isSmoothed(steps.back()) ? whole : Shared<LabelVolume>();
    before = {};
    voxels = 0;
  }
};

/// The steps to be grown: as they are at the time step that is shown (steps), and as they were made (made).
struct Goal {
  Steps steps, made;
  std::size_t carried = 0;  ///< how many of the first steps show nothing before all of them are done
  bool operator==(const Goal&) const = default;
  bool isCarried(std::size_t i) const { return i < carried || steps[i].timeStep != made[i].timeStep; }
};

/// True when growing can go on from what has been grown to what is wanted, without beginning again.
bool isOnTheWay(const Steps& grown, const Steps& wanted);
bool isOnTheWay(const Progressed& now, const Steps& wanted);

/// How closely the growth of a structure is watched for leaks: not at all; for jumps of its section (growth::Leak); or
/// for all signs, also in its first slab: one that is most of its plane, or values that reach the darkest.
enum class Watch { Not, Jumps, All };

/// Grows steps a piece at a time, for a caller that shows the front as it comes. To be used by one thread at a time.
class GrowInParts {
 public:
  /// Goes on for about as long as one piece of work takes. @param ground  labels before all steps  @param to  what has
  /// been grown so far  @param watch  how to watch a structure, by its id  @throw Cancelled
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
