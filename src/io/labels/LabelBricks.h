#pragma once
#include "core/LabelVolume.h"
#include "core/Task.h"
#include "core/VoxelSource.h"
#include "io/labels/LabelNumbers.h"
#include "io/read/Refuse.h"

namespace velum::io {

/// How labels are read brick by brick.
struct LabelBrickOptions {
  int level = 0;                    ///< of the source: the finest that is read
  bool mayBeCoarser = true;         ///< a coarser level is read where that one does not fit
  double mostBytes = 0;             ///< of bricks of several ids
  bool carriesIds = false;          ///< as StoreSource::carryIds()
  bool areIdsSigned = false;        ///< ids that are carried are signed in the file
  glm::dmat4 worldFromFinest{1.0};  ///< where voxels of the finest level lie
  LengthUnit unit = LengthUnit::Millimetre;
  KnownIds known;  ///< ids that a scene has for numbers of the file
  Path path;       ///< for messages
};

/// Reads the first channel and time step of a source as labels, brick by brick, on all cores. What lies in memory is
/// what the labels take, and a few bricks. Labels that take more than they may are read at the next coarser level;
/// where there is none, or the source has no other, they are halved by the most frequent id until they fit.
///
/// Ids are numbers of up to 64 bits (LabelNumbers). Of more numbers than there are ids those that most voxels have are
/// read, which takes two more walks over the source.
/// @return with rows in its table for ids that are others in the file, and, in its warnings, what was not read as it is
/// @throw InputError for values that are no ids, or a brick that cannot be read; Cancelled. Any thread.
LabelVolume readLabelBricks(const VoxelSource& source, const LabelBrickOptions& how, Progress& progress);

}  // namespace velum::io
