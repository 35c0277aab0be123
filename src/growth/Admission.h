#pragma once
#include <vector>

#include "core/LabelVolume.h"
#include "core/Shared.h"
#include "growth/GrowRule.h"
#include "growth/RowBits.h"
#include "growth/ValueBits.h"

namespace velum::growth {

/// Tells, row by row, which voxels may join a region: by their value, owner and gradient, and by barriers. Any thread.
class Admission {
 public:
  /// @param labels  on the volume's grid
  Admission(Shared<Volume> volume, const Shared<LabelVolume>& labels, GrowRule rule);

  const Volume& volume() const { return *mVolume; }
  const GrowRule& rule() const { return mRule; }
  const Shared<LabelVolume>& labels() const { return mLabels; }
  void setLabels(const Shared<LabelVolume>& labels);
  /// @param bits  wordsOf(dims.x), all written
  void open(int y, int z, Word* bits) const;

 private:
  /// How many voxels of the bricks along a row have no owner.
  enum class Free : std::uint8_t { None, Some, All };
  Free freeAlong(int by, int bz) const;
  void keepFree(int y, int z, Word* bits) const;
  void keepFlat(int y, int z, Word* bits) const;
  void keepOutOfBarriers(int y, int z, Word* bits) const;

  Shared<Volume> mVolume;
  Shared<LabelVolume> mLabels;
  GrowRule mRule;
  ValueBits mValues;
  std::vector<Free> mFree;  ///< [brick z][brick y]
  glm::dmat3 mWorldFromSlope;
  struct Box {
    glm::ivec3 first, last;  ///< both included; empty where the barrier lies outside the volume
  };
  std::vector<Box> mBarriers;  ///< for each barrier: box of the voxels that it may hold
};

/// Writes a row of bits: 1 where the label volume's row (y, z) has the label `id`.
/// @param bits  wordsOf(dims.x), all written
void labelBits(const LabelVolume& labels, int y, int z, std::uint16_t id, Word* bits);

}  // namespace velum::growth
