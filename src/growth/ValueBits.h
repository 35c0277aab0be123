#pragma once
#include <memory>

#include "core/Volume.h"
#include "growth/RowBits.h"

namespace velum::growth {

/// Which voxels of a row have a value from `low` to `high`, by its raw samples: exactly what valueAt() says. Any
/// thread.
class ValueBits {
 public:
  /// Works on voxels' raw samples.
  struct Kernel {
    virtual ~Kernel() = default;
    /// @param sample  of the row's first voxel, in samples from the first one of the volume
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
