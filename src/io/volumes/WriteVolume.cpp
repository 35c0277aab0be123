#include "io/volumes/WriteVolume.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/ReplaceFile.h"
#include "io/read/FileNames.h"
#include "io/read/Losses.h"
#include "io/read/Refuse.h"
#include "io/volumes/FormatTable.h"
#include "io/volumes/Writers.h"

namespace velum::io {

namespace {

std::vector<std::string_view> writtenExtensions() {
  std::vector<std::string_view> all;
  for (const FormatRow& row : formatTable())
    if (row.isWritten()) all.push_back(row.format.written);
  return all;
}

}  // namespace

void checkWhole(const Volume& v, const Path& path) {
  std::size_t wanted = timeStepBytes(v) * std::size_t(std::max(0, v.timeSteps));
  if (wanted == 0 || v.voxels.size() != wanted) refuse(path, "an empty volume cannot be written");
}

bool isNameLost(const Volume& volume, const Path& path) { return !volume.name.empty() && volume.name != titleOf(path); }

void expectVolumeFormat(const Path& path) {
  if (!chooseWriter(path)) refuse(path, fmt::format("volumes are written as {}", fmt::join(writtenExtensions(), ", ")));
}

std::vector<std::string> writeVolume(const Volume& volume, const std::filesystem::path& path, Progress& progress) {
  expectVolumeFormat(path);
  const FormatRow* row = chooseWriter(path);
  checkWhole(volume, path);
  if (row->writeAlone) return row->writeAlone(volume, path, progress);
  ReplaceFile file(path);
  auto losses = row->write(volume, file, progress);
  file.commit();
  progress.report(1.0, "Wrote " + path.filename().string());
  return losses;
}

}  // namespace velum::io
