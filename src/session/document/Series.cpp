#include "session/document/Series.h"

#include <algorithm>
#include <cmath>

#include "core/FileName.h"
#include "io/stores/OpenStore.h"
#include "io/volumes/ReadVolume.h"
#include "session/document/Open.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

/// So much of the values at either end is left out of the greys: single bright points would darken all else.
constexpr double kLeftOut = 0.01;

Series seriesOf(const io::SeriesInfo& info) {
  return {info.uid, info.description, info.modality, info.date, info.imageCount, info.size, info.middleFile, {}};
}

}  // namespace

bool mayHoldSeries(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error) || lowerCase(path.filename().string()) == "dicomdir" || io::isStore(path);
}

std::vector<Series> seriesIn(const fs::path& path, Progress& progress) {
  std::vector<Series> found;
  auto all = io::listSeries(path, progress);
  bool isStored = io::isStore(path);
  bool holdsImages = std::any_of(all.begin(), all.end(), [](auto& info) { return !info.isSegmentation; });
  for (const auto& info : all)
    if (!info.isSegmentation || (isStored && !holdsImages)) found.push_back(seriesOf(info));
  if (!holdsImages) return found;
  for (const auto& info : all) {
    if (!info.isSegmentation) continue;
    SeriesLabels labels{info.description.empty() ? info.middleFile.filename().string() : info.description,
                        isStored ? path : info.middleFile, isStored ? info.uid : std::string()};
    bool isKnown = std::any_of(found.begin(), found.end(), [&](auto& s) { return s.uid == info.referencedSeries; });
    for (Series& series : found)
      if (!isKnown || series.uid == info.referencedSeries) series.labels.push_back(labels);
  }
  return found;
}

Image seriesPicture(const Series& series, int size, Progress& progress) {
  io::SeriesInfo info;
  info.middleFile = series.middleFile;
  Volume section = io::readSeriesImage(info, progress);
  return planePicture(section, size);
}

Image planePicture(const Volume& section, int size) {
  Histogram histogram = computeHistogram(section);
  double low = quantile(histogram, kLeftOut), high = quantile(histogram, 1.0 - kLeftOut);
  double longer = std::max(section.dims.x, section.dims.y), step = std::max(1.0, longer / size);
  Image picture;
  picture.width = std::max(1, int(section.dims.x / step));
  picture.height = std::max(1, int(section.dims.y / step));
  picture.channels = {"R", "G", "B"};
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      glm::ivec3 voxel(std::min(int((x + 0.5) * step), section.dims.x - 1),
                       std::min(int((y + 0.5) * step), section.dims.y - 1), 0);
      double grey = (valueAt(section, voxel) - low) / std::max(high - low, 1e-12);
      picture.pixels.insert(picture.pixels.end(), 3, float(std::clamp(grey, 0.0, 1.0)));
    }
  return picture;
}

Loaded readSeries(const std::string& path, const std::string& uid, const SeriesLabels& labels, Progress& progress,
                  const DataPolicy& policy) {
  scene::Source source;
  source.path = path;
  source.series = uid;
  Loaded loaded = read({source}, progress, policy);
  if (labels.file.empty()) return loaded;
  scene::Source segments;
  segments.path = labels.file.string();
  segments.series = labels.key;
  addLabels(loaded.scene, segments, progress);
  return loaded;
}

}  // namespace velum::session
