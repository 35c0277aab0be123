#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/Plugins.h"
#include "io/read/FileNames.h"
#include "io/stores/Codecs.h"
#include "io/stores/Hdf5Driver.h"

namespace velum::io {

namespace {

constexpr std::size_t kMostAxes = 8, kMostText = 1 << 20, kMostNumbers = 1 << 16, kMostNames = 1 << 20;

/// The type of samples; nothing for what is no number of ours.
std::optional<ChunkType> chunkTypeOf(hid_t type) {
  ChunkType made;
  H5T_class_t kind = ::H5Tget_class(type);
  made.bytes = int(::H5Tget_size(type));
  bool isFit = made.bytes == 1 || made.bytes == 2 || made.bytes == 4 || made.bytes == 8;
  if (!isFit || ::H5Tget_precision(type) != std::size_t(8 * made.bytes)) return std::nullopt;
  if (kind == H5T_INTEGER)
    made.kind = ::H5Tget_sign(type) == H5T_SGN_NONE ? ChunkType::Kind::Unsigned : ChunkType::Kind::Signed;
  else if (kind == H5T_FLOAT && made.bytes > 1)
    made.kind = ChunkType::Kind::Float;
  else
    return std::nullopt;
  made.isBigEndian = ::H5Tget_order(type) == H5T_ORDER_BE;
  return made;
}

/// A dataset of the library.
class LibraryDataset : public Hdf5Dataset {
 public:
  LibraryDataset(const Hdf5Lock& lock, Hdf5Id dataset, Path path)
      : mDataset(std::move(dataset)), mType(::H5Dget_type(mDataset), ::H5Tclose), mPath(std::move(path)) {
    readShape(lock);
    auto known = chunkTypeOf(mType);
    if (!known) refuse(mPath, "its samples are no whole numbers or floats of 8 to 64 bits");
    type = *known;
    readLayout(lock);
  }
  ~LibraryDataset() override {
    Hdf5Lock lock;
    Hdf5Id type(std::move(mType));
    Hdf5Id dataset(std::move(mDataset));
  }

  std::optional<Hdf5Piece> find(std::span<const std::uint64_t> index) const override {
    std::vector<hsize_t> origin;
    for (std::size_t i = 0; i < chunk.size(); ++i) origin.push_back(index[i] * chunk[i]);
    Hdf5Lock lock;
    return findChunk(lock, mDataset, origin.data(), mPath);
  }

  Bytes read(std::span<const std::uint64_t> origin, std::span<const std::uint64_t> size) const override {
    std::uint64_t bytes = std::uint64_t(type.bytes);
    for (std::uint64_t count : size) bytes *= count;
    std::vector<hsize_t> first(origin.begin(), origin.end()), count(size.begin(), size.end());
    Bytes samples(static_cast<std::size_t>(bytes));
    Hdf5Lock lock;
    Hdf5Id from(::H5Dget_space(mDataset), ::H5Sclose);
    Hdf5Id to(::H5Screate_simple(int(count.size()), count.data(), nullptr), ::H5Sclose);
    if (::H5Sselect_hyperslab(from, H5S_SELECT_SET, first.data(), nullptr, count.data(), nullptr) < 0 ||
        ::H5Dread(mDataset, mType, to, from, H5P_DEFAULT, samples.data()) < 0)
      refuse(mPath, "samples cannot be read" + lock.reason());
    return samples;
  }

 private:
  void readShape(const Hdf5Lock& lock) {
    Hdf5Id space(::H5Dget_space(mDataset), ::H5Sclose);
    int axes = space.isValid() ? ::H5Sget_simple_extent_ndims(space) : -1;
    if (axes < 1 || std::size_t(axes) > kMostAxes)
      refuse(mPath, fmt::format("has {} axes, which makes no sense{}", axes, lock.reason()));
    hsize_t sizes[kMostAxes];
    ::H5Sget_simple_extent_dims(space, sizes, nullptr);
    shape.assign(sizes, sizes + axes);
  }

  void readLayout(const Hdf5Lock&) {
    Hdf5Id made(::H5Dget_create_plist(mDataset), ::H5Pclose);
    if (::H5Pget_external_count(made) > 0) refuse(mPath, "its samples lie in other files, which are not opened");
    if (::H5Pget_layout(made) != H5D_CHUNKED) return;
    hsize_t sizes[kMostAxes];
    if (::H5Pget_chunk(made, int(kMostAxes), sizes) != int(shape.size())) refuse(mPath, "its chunks do not fit it");
    chunk.assign(sizes, sizes + shape.size());
    for (int i = 0, count = ::H5Pget_nfilters(made); i < count; ++i) {
      unsigned flags = 0, settings = 0;
      std::size_t values = 0;
      char name[64] = {};
      int id = ::H5Pget_filter2(made, unsigned(i), &flags, &values, nullptr, sizeof(name) - 1, name, &settings);
      filters.push_back({id, name});
    }
  }

  Hdf5Id mDataset, mType;
  Path mPath;
};

/// A file of the library.
class LibraryFile : public Hdf5File {
 public:
  LibraryFile(Path path, Hdf5Id file) : mPath(std::move(path)), mFile(std::move(file)) {}
  ~LibraryFile() override {
    Hdf5Lock lock;
    Hdf5Id file(std::move(mFile));
  }
  const Path& path() const override { return mPath; }

  bool has(const std::string& object) const override {
    Hdf5Lock lock;
    return isThere(object);
  }

  std::vector<std::string> names(const std::string& group) const override {
    std::vector<std::string> all;
    Hdf5Lock lock;
    if (!group.empty() && !isThere(group)) return all;
    Hdf5Id id(::H5Gopen2(mFile, group.empty() ? "/" : group.c_str(), H5P_DEFAULT), ::H5Gclose);
    if (!id.isValid()) return all;
    auto take = [](hid_t, const char* name, const H5L_info_t*, void* to) {
      auto& list = *static_cast<std::vector<std::string>*>(to);
      if (list.size() >= kMostNames) return herr_t(1);
      list.emplace_back(name);
      return herr_t(0);
    };
    if (::H5Literate(id, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, take, &all) < 0)
      refuse(mPath, "a group cannot be read: it is damaged" + lock.reason());
    std::sort(all.begin(), all.end(), naturalLess);
    return all;
  }

  std::optional<std::string> text(const std::string& object, const std::string& name) const override {
    Hdf5Lock lock;
    if (!object.empty() && !isThere(object)) return std::nullopt;
    std::string from = object.empty() ? "/" : object;
    if (::H5Aexists_by_name(mFile, from.c_str(), name.c_str(), H5P_DEFAULT) <= 0) return std::nullopt;
    Hdf5Id attribute(::H5Aopen_by_name(mFile, from.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), ::H5Aclose);
    if (!attribute.isValid()) return std::nullopt;
    Hdf5Id type(::H5Aget_type(attribute), ::H5Tclose), space(::H5Aget_space(attribute), ::H5Sclose);
    if (::H5Tget_class(type) != H5T_STRING) return std::nullopt;
    hssize_t count = ::H5Sget_simple_extent_npoints(space);
    std::size_t size = ::H5Tget_size(type);
    if (count < 1 || size < 1 || std::uint64_t(count) > kMostText / size) return std::nullopt;
    if (::H5Tis_variable_str(type) > 0) return variableText(attribute, type, space, count);
    std::string bytes(std::size_t(count) * size, '\0');
    if (::H5Aread(attribute, type, bytes.data()) < 0) return std::nullopt;
    std::string joined;
    for (std::size_t i = 0; i < std::size_t(count); ++i) joined += bytes.substr(i * size, size).c_str();
    return joined;
  }

  std::vector<double> numbers(const std::string& name) const override {
    Hdf5Lock lock;
    if (!isThere(name)) return {};
    Hdf5Id dataset(::H5Dopen2(mFile, name.c_str(), H5P_DEFAULT), ::H5Dclose);
    Hdf5Id space(dataset.isValid() ? ::H5Dget_space(dataset) : -1, ::H5Sclose);
    hssize_t count = space.isValid() ? ::H5Sget_simple_extent_npoints(space) : -1;
    if (count < 0 || std::size_t(count) > kMostNumbers)
      refuse(mPath, fmt::format("{} is no short list of numbers{}", inQuotes(name), lock.reason()));
    std::vector<double> all(static_cast<std::size_t>(count));
    if (count > 0 && ::H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()) < 0)
      refuse(mPath, fmt::format("{} cannot be read{}", inQuotes(name), lock.reason()));
    return all;
  }

  std::unique_ptr<Hdf5Dataset> open(const std::string& name) const override {
    Hdf5Lock lock;
    if (!isThere(name)) return nullptr;
    Hdf5Id dataset(::H5Dopen2(mFile, name.c_str(), H5P_DEFAULT), ::H5Dclose);
    if (!dataset.isValid()) refuse(mPath, fmt::format("{} cannot be opened{}", inQuotes(name), lock.reason()));
    return std::make_unique<LibraryDataset>(lock, std::move(dataset), mPath / name);
  }

 private:
  /// Each part of a path is asked for by itself, as the library wants. A link whose target is missing is not there.
  bool isThere(const std::string& object) const {
    for (std::size_t at = object.find('/'); at != object.npos; at = object.find('/', at + 1))
      if (::H5Lexists(mFile, object.substr(0, at).c_str(), H5P_DEFAULT) <= 0) return false;
    return ::H5Lexists(mFile, object.c_str(), H5P_DEFAULT) > 0 &&
           ::H5Oexists_by_name(mFile, object.c_str(), H5P_DEFAULT) > 0;
  }

  std::optional<std::string> variableText(hid_t attribute, hid_t type, hid_t space, hssize_t count) const {
    std::vector<char*> words(std::size_t(count), nullptr);
    if (::H5Aread(attribute, type, words.data()) < 0) return std::nullopt;
    std::string joined;
    for (const char* word : words)
      if (word) joined += word;
    ::H5Dvlen_reclaim(type, space, H5P_DEFAULT, words.data());
    return joined;
  }

  Path mPath;
  Hdf5Id mFile;
};

}  // namespace

std::unique_ptr<Hdf5File> plugin::openHdf5(const Path& path) {
  Hdf5Lock lock;
  Hdf5Id file = openByDriver(lock, path);
  if (!file.isValid()) refuse(path, "cannot be opened as HDF5: it is none, is damaged or cut short" + lock.reason());
  return std::make_unique<LibraryFile>(path, std::move(file));
}

}  // namespace velum::io
