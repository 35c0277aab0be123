#pragma once
#include <deque>
#include <span>
#include <vector>

#include "growth/Grower.h"

namespace velum::growth {

/// Does all growing steps of a scene, with their ends (smoothRegion()), at any time step of the volume. Results that it
/// keeps only save time: the labels are the same whatever was asked before. A step that was clicked at another time
/// step is *carried*: it begins at its seeds where the voxels there still have values of its range; else at those
/// voxels which the structure has one time step nearer to the step's own and which may join here, and so on back to the
/// step's own time step. So a structure that moves little by little is followed. The step's others are carried
/// likewise: where the voxel of one of them has left the range, the voxels that went to the others one time step nearer
/// are taken as others.
class GrowOverTime {
 public:
  /// The labels of a time step after the first `count` steps.
  /// @param given  the labels before the first step, see labelsFor() @throw Cancelled, ArgumentError
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
  std::deque<Known> mKnown;  ///< the one found most recently comes last
  Grower mGrower;
};

/// The labels after all steps of a scene, done one after the other onto the labels `given`.
/// @throw Cancelled, ArgumentError
Shared<LabelVolume> growLabels(const Shared<Volume>& volume, const Shared<LabelVolume>& given,
                               std::span<const scene::Growth> steps, int timeStep, Progress& progress);

}  // namespace velum::growth
