#pragma once
#include <memory>

#include "core/FinestVoxels.h"
#include "growth/RowBits.h"

namespace velum::growth {

/// Tells which voxels of a row have a value from `low` to `high`. Works on raw samples, with exactly the result that
/// comparing valueAt() gives. Any thread.
class ValueBits {
 public:
  /// The comparison for one type of sample.
  struct Kernel {
    virtual ~Kernel() = default;
    /// @param count  how many samples of the run
    virtual void of(const SampleRun& run, int count, Word* bits) const = 0;
  };

  /// @param volume  of which no voxels are looked at
  ValueBits(const Volume& volume, double low, double high, int channel, int timeStep);
  /// @param words  which of the row are asked for @param bits  these words, all written
  /// @throw InputError when a brick cannot be read
  void of(const FinestVoxels& voxels, int y, int z, WordSpan words, Word* bits) const;

 private:
  int mChannel, mTimeStep;
  std::unique_ptr<Kernel> mKernel;
};

}  // namespace velum::growth
