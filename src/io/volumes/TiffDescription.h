#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace velum::io {

/// How the pages of a TIFF form a volume, according to its ImageDescription (OME-XML or ImageJ).
struct TiffLayout {
  enum class Kind { Plain, ImageJ, Ome };
  Kind kind = Kind::Plain;
  std::uint64_t sizeX = 0, sizeY = 0;             ///< 0: not told.
  std::uint64_t sizeZ = 0, sizeC = 1, sizeT = 1;  ///< sizeZ 0: as many as there are pages.
  std::string order = "CZT";                      ///< Order of the axes from page to page, the fastest first.
  glm::dvec3 spacing{0.0};                        ///< 0: not told.
  double unitMm = 0.0;                            ///< ImageJ: the unit of the resolution tags in mm; 0: none.
  double timeStepSeconds = 0.0;
  std::vector<std::string> channelNames;
  /// OME, sRGB; empty where the colour of any channel is not told, or all are the same.
  std::vector<glm::vec3> channelColors;
  /// OME TiffData: which page holds which plane; where `planes` is empty, the pages follow each other in `order`.
  struct Plane {
    std::uint64_t page = 0, z = 0, c = 0, t = 0, count = 1;
  };
  std::vector<Plane> planes;
  bool hasOtherFiles = false;  ///< The OME-XML names other files beside this one.
};

/// Reads OME-XML (the first image's Pixels), an ImageJ description, or neither; never fails: values that make no sense
/// count as not told. Reads attributes only; entities in names are not resolved.
/// @param fileName  name of this file, to know which OME planes are in other files
TiffLayout parseTiffDescription(std::string_view text, std::string_view fileName);

/// A page that is used, and the place of its plane in the volume.
struct PlaneTarget {
  std::uint64_t page = 0, z = 0, c = 0, t = 0;
};
/// Where every plane of the layout goes, ascending by page. `layout.sizeZ` must be set; `channelPlanes` is sizeC
/// divided by the samples per pixel. Empty when the layout needs a page that does not exist, or fills the same place
/// twice.
std::vector<PlaneTarget> placePlanes(const TiffLayout& layout, std::uint64_t channelPlanes, std::uint64_t pageCount);

}  // namespace velum::io
