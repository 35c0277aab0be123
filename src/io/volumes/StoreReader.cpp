#include "io/stores/OpenStore.h"
#include "io/stores/WriteStore.h"
#include "io/volumes/ReadLevel.h"
#include "io/volumes/Readers.h"

namespace velum::io {

Volume readStore(const scene::Source& source, Progress& progress) {
  progress.report(0.0, "Reading metadata");
  auto image = openImage(source.path, source.series);
  bool isAlignedByBorders = image->facts().isAlignedByBorders;
  return readFitting(std::move(image), source, isAlignedByBorders, progress);
}

std::vector<std::string> writeZarr(const Volume& volume, const Path& path, Progress& progress) {
  return writeStore(VolumeSource(volume), path, {}, progress);
}

}  // namespace velum::io
