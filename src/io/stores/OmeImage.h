#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/LabelVolume.h"
#include "io/stores/StoreImage.h"
#include "io/stores/ZarrArray.h"

/// What OME-Zarr says of the images in a store, versions 0.1 to 0.5, and of 0.6 what is said in the same words.
namespace velum::io {

/// An axis of an image's arrays.
struct OmeAxis {
  enum class Role { Time, Channel, Z, Y, X };
  std::string name, unit;
  Role role = Role::X;
};

/// A level: an array, and where its samples lie, each list with a number an axis.
struct OmeLevel {
  std::string key;                         ///< of the array
  std::vector<double> scale, translation;  ///< place = scale * index + translation, of the centre of a voxel
  bool hasTranslation = false;
};

struct OmeChannel {
  std::string label;
  std::optional<glm::vec3> color;    ///< sRGB
  std::optional<glm::dvec2> window;  ///< values from dark to bright, where somebody chose them
};

/// An image: a group with `multiscales`, or a bare array.
struct OmeImage {
  std::string key;   ///< of the group
  std::string name;  ///< as the file calls it; may be empty
  std::vector<OmeAxis> axes;
  std::vector<OmeLevel> levels;
  std::vector<OmeChannel> channels;
  bool isBare = false;                ///< an array of which nothing says what its axes measure
  bool isLabels = false;              ///< its samples are ids
  std::vector<LabelInfo> structures;  ///< as in StoreFacts
};

/// The image at a key; nothing where there is none. @throw InputError for one that is damaged or breaks the rules
std::optional<OmeImage> readOmeImage(const Store& store, const std::string& key);

/// The images of a store, or of a group of it: the one at its root, series, wells of a plate, and the labels beside
/// each. Reads metadata only. @throw InputError for metadata that is damaged
std::vector<StoreImage> listImages(const Store& store);

}  // namespace velum::io
