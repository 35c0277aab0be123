#include "io/volumes/StoreSeries.h"

#include "core/VoxelSource.h"
#include "io/stores/OpenStore.h"

namespace velum::io {

namespace {

constexpr double kMostOfPicture = 256e6;  ///< bytes of the level of which a picture is made

SeriesInfo seriesOf(const Path& path, const StoreImage& image) {
  SeriesInfo series;
  series.uid = image.key;
  series.description = image.name;
  series.isSegmentation = image.isLabels;
  series.referencedSeries = image.labelsOf;
  series.middleFile = image.key.empty() ? path : path / image.key;
  series.size = image.dims;
  series.imageCount = image.dims.z;
  if (image.dims.z > 0) return series;
  try {
    auto source = openImage(path, image.key);
    series.imageCount = source->head().dims.z;
    series.size = source->head().dims;
  } catch (const InputError&) {
    // It is listed: what is wrong is said when it is opened.
  }
  return series;
}

}  // namespace

std::vector<SeriesInfo> seriesInStore(const Path& path, Progress& progress) {
  std::vector<SeriesInfo> series;
  for (const StoreImage& image : imagesIn(path)) {
    progress.throwIfCancelled();
    series.push_back(seriesOf(path, image));
  }
  return series;
}

std::optional<StorePlace> placeInStore(const Path& path) {
  std::error_code error;
  Path store = path;
  while (!std::filesystem::exists(store, error) && store.has_relative_path()) store = store.parent_path();
  if (!isStore(store)) return std::nullopt;
  std::string key = store == path ? std::string() : path.lexically_relative(store).string();
  return StorePlace{store, key};
}

Volume readStorePicture(const StorePlace& place, Progress& progress) {
  const Path& path = place.store;
  auto image = openImage(path, place.key);
  int level = int(image->levels().size()) - 1;
  if (levelBytes(*image, level) > kMostOfPicture) refuse(path, "its coarsest level is too large for a small picture");
  Volume volume = readLevel(*image, level, progress);
  std::size_t plane = timeStepBytes(volume) / std::size_t(volume.dims.z), middle = std::size_t(volume.dims.z) / 2;
  volume.voxels.erase(volume.voxels.begin(), volume.voxels.begin() + std::ptrdiff_t(plane * middle));
  volume.voxels.resize(plane);
  volume.dims.z = volume.timeSteps = 1;
  computeRange(volume);
  return volume;
}

}  // namespace velum::io
