#pragma once
#include <memory>
#include <string>
#include <vector>

#include "io/stores/ArraySource.h"
#include "io/stores/Hdf5File.h"
#include "io/stores/StoreImage.h"

/// Images in files of Imaris (.ims, version 5.5), which are HDF5.
namespace velum::io {

bool isImaris(const Hdf5File& file);

/// The images in a file, by the names of their groups: "DataSet", "DataSet1", ... @throw InputError
std::vector<StoreImage> listImarisImages(const Hdf5File& file);

/// Reads the metadata of all levels of an image; empty key: the first. @throw InputError
ArrayPyramid readImarisImage(const std::shared_ptr<const Hdf5File>& file, const std::string& key);

}  // namespace velum::io
