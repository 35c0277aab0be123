#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/stores/ImageStore.h"

/// Opens stores of chunked volumes: Zarr, in folders or archives of them; N5, in folders; HDF5 of Imaris and of
/// BigDataViewer, whose XML opens it, too.
namespace velum::io {

/// True for what openImageStore() opens. Any thread.
bool isStore(const Path& path);

/// The images in a store. @throw InputError
std::vector<StoreImage> imagesIn(const Path& path);

/// Opens an image of a store. Metadata is read, and no voxel.
/// @param image  its key, one of those of imagesIn(); empty: the first
/// @throw InputError for a store or an image that is missing, damaged or not supported
std::unique_ptr<StoreSource> openImage(const Path& path, const std::string& image);

/// True for a store whose image of that key (empty: the first) has ids for samples. False for what is no store, or
/// cannot be read. Any thread.
bool holdsLabels(const Path& path, const std::string& image);

}  // namespace velum::io
