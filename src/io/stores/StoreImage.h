#pragma once
#include <glm/glm.hpp>
#include <string>

namespace velum::io {

/// One of the images in a store.
struct StoreImage {
  std::string key, name;
  bool isLabels = false;
  std::string labelsOf;  ///< of labels: the key of their image
  glm::ivec3 dims{0};    ///< voxels of its finest level; zero where the list does not know them
  bool operator==(const StoreImage&) const = default;
};

}  // namespace velum::io
