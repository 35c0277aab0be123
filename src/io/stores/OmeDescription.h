#pragma once
#include <vector>

#include "core/LabelVolume.h"
#include "core/Volume.h"
#include "io/stores/OmeImage.h"
#include "io/stores/PyramidPlan.h"

/// The metadata of stores that are written.
namespace velum::io {

enum class OmeVersion {
  V04,  ///< Zarr 2: a file for each brick
  V05   ///< Zarr 3: bricks in shards
};

/// How an image is to be written.
struct OmeLayout {
  OmeVersion version = OmeVersion::V05;
  int zstdLevel = 0;
  std::vector<PlannedLevel> levels;
  bool isLabels = false;
  bool carriesIds = false;        ///< samples are the bits of whole numbers (StoreSource::carryIds)
  bool hasChosenWindows = false;  ///< somebody chose the windows of channels: they are not just their ranges
};

/// The axes: time and channels where there are several, then z, y, x.
std::vector<OmeAxis> axesOf(const Volume& head);
/// A list with an entry an axis, in their order.
template <class Number>
std::vector<Number> alongAxes(const std::vector<OmeAxis>& axes, Number timeStep, Number channel,
                              glm::vec<3, Number> place) {
  std::vector<Number> list;
  for (const OmeAxis& axis : axes) switch (axis.role) {
      case OmeAxis::Role::Time:
        list.push_back(timeStep);
        break;
      case OmeAxis::Role::Channel:
        list.push_back(channel);
        break;
      case OmeAxis::Role::Z:
        list.push_back(place.z);
        break;
      case OmeAxis::Role::Y:
        list.push_back(place.y);
        break;
      case OmeAxis::Role::X:
        list.push_back(place.x);
        break;
    }
  return list;
}

/// Whether a volume's axes are those of its world, so that scales and a translation place it.
bool isStraight(const Volume& head);

/// A file of metadata: its name below the folder that it describes, and its text.
struct MetadataFile {
  std::string name, text;
};
/// Of the array of a level.
MetadataFile describeArray(const OmeLayout& layout, const Volume& head, int level);
/// Of the image.
/// @param windows     of each channel; empty: none are said
/// @param structures  of labels
std::vector<MetadataFile> describeImage(const OmeLayout& layout, const Volume& head,
                                        const std::vector<glm::dvec2>& windows,
                                        const std::vector<LabelInfo>& structures);

}  // namespace velum::io
