#include "io/stores/ImageStore.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/Error.h"
#include "core/FileName.h"
#include "io/read/ByteSource.h"
#include "io/stores/BdvImage.h"
#include "io/stores/Hdf5Array.h"
#include "io/stores/ImarisImage.h"
#include "io/stores/N5Image.h"
#include "io/stores/WriteStore.h"
#include "io/stores/ZarrSource.h"

namespace velum::io {

namespace {

constexpr std::size_t kHead = 4096;
constexpr std::string_view kZarr[] = {"zarr.json", ".zgroup", ".zattrs", ".zarray", kUnfinishedName};
constexpr std::string_view kN5[] = {"attributes.json", "s0/attributes.json", "setup0/attributes.json"};

bool holdsAny(const Path& folder, const auto& names) {
  return std::any_of(std::begin(names), std::end(names), [&](std::string_view name) {
    std::error_code error;
    return std::filesystem::is_regular_file(folder / name, error);
  });
}

/// An archive of a Zarr store, by its name or by what is in it.
bool isZarrArchive(const Path& path, std::string_view head) {
  if (!head.starts_with("PK\x03\x04")) return false;
  std::string name = lowerCase(path.filename().string());
  if (name.ends_with(".ozx") || name.ends_with(".zarr.zip") || name.ends_with(".zarr")) return true;
  try {
    auto store = openStore(path);
    return std::any_of(std::begin(kZarr), std::end(kZarr),
                       [&](std::string_view file) { return store->open(std::string(file)) != nullptr; });
  } catch (const InputError&) {
    return false;  // some other archive
  }
}

std::unique_ptr<StoreSource> sourceOf(ArrayPyramid pyramid, std::vector<std::string> notes) {
  auto& warnings = pyramid.head.warnings;
  warnings.insert(warnings.begin(), notes.begin(), notes.end());
  return std::make_unique<ArraySource>(std::move(pyramid));
}

class ZarrImages : public ImageStore {
 public:
  explicit ZarrImages(const Path& path) : mStore(openStore(path)) {}
  std::vector<StoreImage> list() const override { return listImages(*mStore); }
  std::unique_ptr<StoreSource> open(const std::string& wanted, std::vector<std::string> notes) const override {
    std::string key = keyBelow(*mStore, "", wanted);
    auto image = readOmeImage(*mStore, key);
    if (!image) refuse(mStore->pathOf(""), fmt::format("the store holds no image {}", inQuotes(key)));
    return std::make_unique<ZarrSource>(mStore, std::move(*image), std::move(notes));
  }

 private:
  std::shared_ptr<const Store> mStore;
};

class N5Images : public ImageStore {
 public:
  explicit N5Images(std::shared_ptr<const Store> store) : mStore(std::move(store)) {}
  std::vector<StoreImage> list() const override { return listN5Images(*mStore); }
  std::unique_ptr<StoreSource> open(const std::string& wanted, std::vector<std::string> notes) const override {
    return sourceOf(readN5Image(mStore, keyBelow(*mStore, "", wanted)), std::move(notes));
  }

 private:
  std::shared_ptr<const Store> mStore;
};

class ImarisImages : public ImageStore {
 public:
  explicit ImarisImages(std::shared_ptr<const Hdf5File> file) : mFile(std::move(file)) {}
  std::vector<StoreImage> list() const override { return listImarisImages(*mFile); }
  std::unique_ptr<StoreSource> open(const std::string& key, std::vector<std::string> notes) const override {
    return sourceOf(readImarisImage(mFile, key), std::move(notes));
  }

 private:
  std::shared_ptr<const Hdf5File> mFile;
};

class BdvStore : public ImageStore {
 public:
  explicit BdvStore(BdvImages images) : mImages(std::move(images)) {}
  std::vector<StoreImage> list() const override { return mImages.list(); }
  std::unique_ptr<StoreSource> open(const std::string& key, std::vector<std::string> notes) const override {
    return sourceOf(mImages.read(key), std::move(notes));
  }

 private:
  BdvImages mImages;
};

/// Voxels of BigDataViewer with the XML that lies beside them, if any does.
std::unique_ptr<ImageStore> openBdv(std::shared_ptr<const BdvVoxels> voxels, const Path& path) {
  auto data = spimDataBeside(path);
  bool hasPlaces = data.has_value();
  if (!data) data = voxels->describe();
  return std::make_unique<BdvStore>(BdvImages(std::move(*data), std::move(voxels), hasPlaces));
}

std::unique_ptr<ImageStore> openByXml(const Path& xml) {
  SpimData data = readSpimData(xml);
  Path path = data.voxels;
  std::shared_ptr<const BdvVoxels> voxels =
      data.format == "bdv.n5" ? bdvInN5(openStore(path)) : bdvInHdf5(openHdf5(path));
  return std::make_unique<BdvStore>(BdvImages(std::move(data), std::move(voxels), true));
}

std::unique_ptr<ImageStore> openN5Store(const Path& path) {
  std::shared_ptr<const Store> store = openStore(path);
  if (isBdv(*store)) return openBdv(bdvInN5(std::move(store)), path);
  return std::make_unique<N5Images>(std::move(store));
}

std::unique_ptr<ImageStore> openHdf5Store(const Path& path) {
  std::shared_ptr<const Hdf5File> file = openHdf5(path);
  if (isImaris(*file)) return std::make_unique<ImarisImages>(std::move(file));
  if (isBdv(*file)) return openBdv(bdvInHdf5(std::move(file)), path);
  refuse(path, "is a file of HDF5 of no kind that is read here; those of Imaris and BigDataViewer are");
}

}  // namespace

StoreKind storeKind(const Path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    if (holdsAny(path, kZarr)) return StoreKind::Zarr;
    Path name = path.has_filename() ? path : path.parent_path();
    return holdsAny(path, kN5) || lowerExtension(name) == ".n5" ? StoreKind::N5 : StoreKind::None;
  }
  if (!std::filesystem::is_regular_file(path, error)) return StoreKind::None;
  try {
    return storeKindOfFile(path, readHead(path, kHead));
  } catch (const InputError&) {
    return StoreKind::None;  // the reader will say what is wrong
  }
}

StoreKind storeKindOfFile(const Path& path, std::string_view head) {
  if (isHdf5(head)) return StoreKind::Hdf5;
  if (isSpimData(head)) return StoreKind::SpimData;
  return isZarrArchive(path, head) ? StoreKind::Zarr : StoreKind::None;
}

std::unique_ptr<ImageStore> openImageStore(const Path& path) {
  if (isUnfinished(path))
    refuse(path,
           "is not whole: it is being written, or its writer was stopped; to go on, give the same command again or "
           "make the pyramid again in the window; or remove it");
  std::error_code error;
  if (!std::filesystem::exists(path, error)) refuse(path, "there is no such file or folder");
  switch (storeKind(path)) {
    case StoreKind::N5:
      return openN5Store(path);
    case StoreKind::Hdf5:
      return openHdf5Store(path);
    case StoreKind::SpimData:
      return openByXml(path);
    case StoreKind::Zarr:
      return std::make_unique<ZarrImages>(path);
    case StoreKind::None:
      break;
  }
  refuse(path,
         "is no store: neither Zarr nor N5, no HDF5 of Imaris or BigDataViewer, and no XML of the latter; it may be "
         "damaged");
}

}  // namespace velum::io
