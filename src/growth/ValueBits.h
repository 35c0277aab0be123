#pragma once
#include <memory>

#include "core/Volume.h"
#include "growth/RowBits.h"

namespace velum::growth {

/// Tells which voxels of a row have a value from `low` to `high`. Works on raw samples, with exactly the result that
/// comparing valueAt() gives. Any thread.
class ValueBits {
 public:
  /// The comparison for one type of sample.
  struct Kernel {
    virtual ~Kernel() = default;
    /// @param sample  place of the row's first sample, counted in samples from the volume's first
    virtual void of(const void* samples, std::size_t sample, int width, Word* bits) const = 0;
  };

  ValueBits(const Volume& volume, double low, double high, int channel, int timeStep);
  /// @param bits  wordsOf(dims.x)
  void of(const Volume& volume, int y, int z, Word* bits) const;

 private:
  std::size_t mFirst = 0;  ///< sample of voxel 0, 0, 0
  std::unique_ptr<Kernel> mKernel;
};

}  // namespace velum::growth
