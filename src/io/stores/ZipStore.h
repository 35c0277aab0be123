#pragma once
#include <memory>

#include "io/stores/Store.h"

namespace velum::io {

/// A ZIP archive as a store: ZIP64, too, and in it members that are stored as they are, which are read in pieces, or
/// deflated, which are inflated whole. @throw InputError when it is none, is damaged, or packs members in another way
std::unique_ptr<Store> openZipStore(const Path& path);

}  // namespace velum::io
