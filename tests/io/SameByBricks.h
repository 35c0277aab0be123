#pragma once
#include "TestFiles.h"
#include "core/VoxelSource.h"
#include "io/volumes/OpenSource.h"

namespace velum::io {

inline scene::Source sourceOf(const std::filesystem::path& path, const scene::RawLayout& raw = {}) {
  scene::Source source;
  source.path = path.string();
  source.raw = raw;
  return source;
}

/// All of the head but what needs the voxels.
inline void expectSameHead(const Volume& a, const Volume& b) {
  EXPECT_EQ(a.dims, b.dims);
  EXPECT_EQ(a.type, b.type);
  EXPECT_EQ(a.channels, b.channels);
  EXPECT_EQ(a.timeSteps, b.timeSteps);
  EXPECT_EQ(a.isColor, b.isColor);
  EXPECT_EQ(a.worldFromVoxel, b.worldFromVoxel);
  EXPECT_EQ(a.lengthUnit, b.lengthUnit);
  EXPECT_EQ(a.scale, b.scale);
  EXPECT_EQ(a.offset, b.offset);
  EXPECT_EQ(a.unit, b.unit);
  EXPECT_EQ(a.modality, b.modality);
  EXPECT_EQ(a.isSpacingKnown, b.isSpacingKnown);
  EXPECT_EQ(a.isOrientationKnown, b.isOrientationKnown);
  EXPECT_EQ(a.timeStepSeconds, b.timeStepSeconds);
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.channelNames, b.channelNames);
  EXPECT_EQ(a.channelColors, b.channelColors);
  EXPECT_EQ(a.warnings, b.warnings);
}

/// A file's source gives the head and the voxels of a volume, in every voxel and place.
inline void expectGives(const VoxelSource& source, const Volume& whole) {
  Progress progress;
  EXPECT_TRUE(source.head().voxels.empty());
  expectSameHead(source.head(), whole);
  EXPECT_EQ(source.levels().front().worldFromVoxel, whole.worldFromVoxel);
  EXPECT_TRUE(readLevel(source, 0, progress).voxels == whole.voxels);
}

/// The file's source gives what the reader of whole files gives.
/// @return whether it has a source
inline bool expectSameByBricks(const scene::Source& source) {
  SCOPED_TRACE(source.path);
  auto opened = openSource(source);
  Progress progress;
  if (opened) expectGives(*opened, readVolume(source, progress));
  return opened != nullptr;
}

}  // namespace velum::io
