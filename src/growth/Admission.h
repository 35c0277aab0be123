#pragma once
#include <vector>

#include "core/LabelVolume.h"
#include "core/Shared.h"
#include "growth/GrowRule.h"
#include "growth/RowBits.h"
#include "growth/ValueBits.h"

namespace velum::growth {

/// Which voxels may join a region, a row at a time: by value, owner, gradient and barriers. Any thread.
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
  /// Of the bricks along a row.
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
    glm::ivec3 first, last;  ///< last included; empty where the barrier lies outside
  };
  std::vector<Box> mBarriers;  ///< voxels that each may hold
};

/// 1 where a label volume has a label, in a row of its own.
/// @param bits  wordsOf(dims.x), all written
void labelBits(const LabelVolume& labels, int y, int z, std::uint16_t id, Word* bits);

}  // namespace velum::growth
