#pragma once
#include <memory>
#include <string>
#include <vector>

#include "io/stores/ArraySource.h"
#include "io/stores/Store.h"
#include "io/stores/StoreImage.h"

/// Images in N5: a group of datasets s0, s1, ..., the finest first, or a dataset by itself.
namespace velum::io {

/// The images in a store: the one at its root, or those in its groups. @throw InputError for damaged metadata
std::vector<StoreImage> listN5Images(const Store& store);

/// Reads the metadata of all levels of the image at a key. @throw InputError when there is none, or it cannot be read
ArrayPyramid readN5Image(const std::shared_ptr<const Store>& store, const std::string& key);

}  // namespace velum::io
