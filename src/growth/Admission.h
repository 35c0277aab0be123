#pragma once
#include <vector>

#include "core/FinestVoxels.h"
#include "core/LabelVolume.h"
#include "core/Shared.h"
#include "growth/GrowRule.h"
#include "growth/RowBits.h"
#include "growth/ValueBits.h"

namespace velum::growth {

/// Tells, row by row, which voxels of a volume's finest level may join a region: by their value, owner and gradient,
/// and by barriers. Any thread.
class Admission {
 public:
  /// @param labels  on the grid of the volume's finest level
  Admission(Shared<Volume> volume, const Shared<LabelVolume>& labels, GrowRule rule);

  /// See FinestVoxels::grid().
  const Volume& grid() const { return mVoxels.grid(); }
  /// True where only those words of a row are to be asked for that somebody needs: they lie in bricks that may have to
  /// be read.
  bool isPiecewise() const { return mVoxels.isStreamed(); }
  const GrowRule& rule() const { return mRule; }
  const Shared<LabelVolume>& labels() const { return mLabels; }
  void setLabels(const Shared<LabelVolume>& labels);
  /// @param words  which of the row are asked for @param bits  these words, all written
  /// @throw InputError when a brick cannot be read
  void open(int y, int z, WordSpan words, Word* bits) const;

 private:
  /// How many voxels of the bricks along a row have no owner.
  enum class Free : std::uint8_t { None, Some, All };
  Free freeAlong(int by, int bz) const;
  void keepFree(int y, int z, WordSpan words, Word* bits) const;
  void keepFlat(int y, int z, WordSpan words, Word* bits) const;
  void keepOutOfBarriers(int y, int z, WordSpan words, Word* bits) const;
  template <class ValueOf>
  double slope(glm::ivec3 voxel, const ValueOf& valueOf) const;

  Shared<Volume> mVolume;
  FinestVoxels mVoxels;
  Shared<LabelVolume> mLabels;
  GrowRule mRule;
  ValueBits mValues;
  std::vector<Free> mFree;  ///< [brick z][brick y]; empty where words are asked for one by one
  glm::dmat3 mWorldFromSlope;
  struct Box {
    glm::ivec3 first, last;  ///< both included; empty where the barrier lies outside the volume
  };
  std::vector<Box> mBarriers;  ///< for each barrier: box of the voxels that it may hold
};

/// Writes a row of bits: 1 where the label volume's row (y, z) has the label `id`.
/// @param words  which of the row are asked for @param bits  these words, all written
void labelBits(const LabelVolume& labels, int y, int z, std::uint16_t id, WordSpan words, Word* bits);
/// The same of a whole row.
void labelBits(const LabelVolume& labels, int y, int z, std::uint16_t id, Word* bits);

}  // namespace velum::growth
