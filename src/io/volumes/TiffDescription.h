#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace velum::io {

/// How the pages of a TIFF make a volume, as its ImageDescription tells (OME-XML or ImageJ).
struct TiffLayout {
  enum class Kind { Plain, ImageJ, Ome };
  Kind kind = Kind::Plain;
  std::uint64_t sizeX = 0, sizeY = 0;             ///< 0: not told.
  std::uint64_t sizeZ = 0, sizeC = 1, sizeT = 1;  ///< sizeZ 0: as many as there are pages.
  std::string order = "CZT";                      ///< Which runs fastest from page to page.
  glm::dvec3 spacing{0.0};                        ///< 0: not told.
  double unitMm = 0.0;                            ///< ImageJ: the unit of the resolution tags in mm; 0: none.
  double timeStepSeconds = 0.0;
  std::vector<std::string> channelNames;
  std::vector<glm::vec3> channelColors;  ///< OME, sRGB; empty where any is not told or all are the same.
  /// OME TiffData: which page holds which plane; empty: in `order`.
  struct Plane {
    std::uint64_t page = 0, z = 0, c = 0, t = 0, count = 1;
  };
  std::vector<Plane> planes;
  bool hasOtherFiles = false;  ///< OME that names other files beside this one.
};

/// Reads OME-XML (the first image's Pixels), an ImageJ description, or neither; never fails: what makes no sense counts
/// as not told. Reads no more than attributes; entities in names stay as they are.
/// @param fileName  to know which OME planes are in other files
TiffLayout parseTiffDescription(std::string_view text, std::string_view fileName);

/// For each page that is used: where its plane goes.
struct PlaneTarget {
  std::uint64_t page = 0, z = 0, c = 0, t = 0;
};
/// Every plane of the layout, ascending by page. `layout.sizeZ` must be set, `channelPlanes` is sizeC over the samples
/// per pixel. Empty when the layout needs a page that is not there, or the same place twice.
std::vector<PlaneTarget> placePlanes(const TiffLayout& layout, std::uint64_t channelPlanes, std::uint64_t pageCount);

}  // namespace velum::io
