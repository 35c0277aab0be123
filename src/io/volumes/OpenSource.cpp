#include "io/volumes/OpenSource.h"

#include "io/volumes/FormatTable.h"
#include "io/volumes/RawSource.h"

namespace velum::io {

std::unique_ptr<VoxelSource> openSource(const scene::Source& source) {
  if (hasRawLayout(source)) return openSamples(describeRaw(source), source);
  if (std::filesystem::is_directory(source.path)) return nullptr;
  const FormatRow* row = chooseReader(readFileHead(source.path));
  return row && row->open ? row->open(source) : nullptr;
}

std::unique_ptr<VoxelSource> openLargeSource(const scene::Source& source) {
  auto opened = openSource(source);
  bool isLarge = opened && levelBytes(*opened, 0) >= kLargeVolumeBytes;
  return isLarge ? std::move(opened) : nullptr;
}

}  // namespace velum::io
