#pragma once
#include <memory>
#include <string>
#include <vector>

#include "io/read/Refuse.h"
#include "io/stores/StoreImage.h"
#include "io/stores/StoreSource.h"

namespace velum::io {

/// The formats of stores. Those of a folder, or an archive of one, are Zarr and N5; a file is HDF5, or the XML of
/// BigDataViewer, which names others.
enum class StoreKind { None, Zarr, N5, Hdf5, SpimData };

/// What lies at a path, by the names in a folder or the first bytes of a file. Any thread.
StoreKind storeKind(const Path& path);
/// The same for a file whose first bytes are known, thousands of them.
StoreKind storeKindOfFile(const Path& path, std::string_view head);

/// A store that is open.
class ImageStore {
 public:
  virtual ~ImageStore() = default;
  /// The images in it. @throw InputError for damaged metadata
  virtual std::vector<StoreImage> list() const = 0;
  /// Opens an image. Metadata is read, and no voxel. @param key  one of those of list(), or what leads to the same
  /// @throw InputError when it is missing, damaged or not supported
  virtual std::unique_ptr<StoreSource> open(const std::string& key, std::vector<std::string> notes) const = 0;
};

/// @throw InputError for what is no store, damaged or not written to its end
std::unique_ptr<ImageStore> openImageStore(const Path& path);

}  // namespace velum::io
