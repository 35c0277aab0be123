#pragma once
#include <algorithm>
#include <cstdint>
#include <string_view>

#include "scene/Shown.h"

namespace velum::scene {

/// Most instances, over all copies of a model, and most copies, that have a number each.
constexpr std::uint64_t kMostNumbered = 1u << 27;
constexpr int kMostNumberedCopies = 4096;

/// How many copies can have a number for each of their instances. @param layer  has data
inline int numberedCopies(const ModelLayer& layer) {
  std::uint64_t most = kMostNumbered / std::max<std::uint64_t>(1, layer.data->instances.size());
  return int(std::min<std::uint64_t>({std::uint64_t(copyCount(layer)), most, std::uint64_t(kMostNumberedCopies)}));
}

/// Whether copies are so many that not all of their instances have numbers: far ones are drawn as wholes, and nobody
/// counts what becomes of their instances. @param layer  has data
inline bool isCrowd(const ModelLayer& layer) { return copyCount(layer) > numberedCopies(layer); }

/// Whether it can be counted what a picture shows of a layer.
inline bool isCounted(const ModelLayer& layer) { return layer.data && layer.visible && !isCrowd(layer); }

/// @throw InputError for a crowd, with what to do @param what  is asked for: "counts"
void refuseCrowd(const ModelLayer& layer, std::string_view what);

}  // namespace velum::scene
