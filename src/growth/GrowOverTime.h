#pragma once
#include <deque>
#include <span>
#include <vector>

#include "growth/Grower.h"

namespace velum::growth {

/// Does all steps of a scene, with their ends, at any time step of the volume: what it knows from before only saves
/// time. A step of another time step is *carried*: it begins at its seeds where these have values of its range; else
/// at what the structure has one time step nearer to its own, where that may join, and so on back to the step's own. So
/// what moves little by little is followed, and the labels are the same whatever was seen before. Where one of its
/// places that are not of it has lost its values, what went to those a time step nearer is theirs likewise.
class GrowOverTime {
 public:
  /// Labels after the first `count` steps.
  /// @param given  before the first one, see labelsFor()  @throw Cancelled, ArgumentError
  Shared<LabelVolume> labelsAt(int timeStep, std::size_t count, const Shared<Volume>& volume,
                               const Shared<LabelVolume>& given, std::span<const scene::Growth> steps,
                               Progress& progress);

 private:
  struct Known {
    int timeStep;
    std::size_t count;
    Shared<LabelVolume> labels, others;  ///< see Grown::others
  };
  void follow(const Shared<Volume>& volume, const Shared<LabelVolume>& given, std::span<const scene::Growth> steps);
  const Known* find(int timeStep, std::size_t count) const;
  Shared<LabelVolume> labelsAt(int timeStep, std::size_t count, Progress& progress);
  Known begunAt(int timeStep, std::size_t count, Progress& progress);

  Shared<Volume> mVolume;
  Shared<LabelVolume> mGiven, mGround;
  std::vector<scene::Growth> mSteps;
  std::deque<Known> mKnown;  ///< the last one found comes last
  Grower mGrower;
};

/// All steps of a scene, one after the other, onto what is given.
/// @throw Cancelled, ArgumentError
Shared<LabelVolume> growLabels(const Shared<Volume>& volume, const Shared<LabelVolume>& given,
                               std::span<const scene::Growth> steps, int timeStep, Progress& progress);

}  // namespace velum::growth
