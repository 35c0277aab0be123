#pragma once
#include <glm/glm.hpp>
#include <string>

#include "core/Volume.h"

namespace velum::scene {

/// Least and largest usable edge of a voxel, in any unit; with others no picture can be computed.
inline constexpr double kLeastSpacing = 1e-12, kMostSpacing = 1e9;

/// The level of a pyramid that is the finest that fits into memory.
inline constexpr int kFittingLevel = -1;

/// How to read a file without a header. Used when dims are positive.
struct RawLayout {
  glm::ivec3 dims{0};                   ///< voxels along x (fastest), y, z; (0,0,0): the file says
  SampleType type = SampleType::UInt8;  ///< type of one sample
  int channels = 1;                     ///< samples per voxel, interleaved, 1..4
  bool bigEndian = false;               ///< byte order of samples of more than one byte
  int headerBytes = 0;                  ///< bytes to skip at the start of the file (of each file, for a folder)
  bool operator==(const RawLayout&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("dims", o.dims, FieldInfo{"voxel", {0, 65535}, "Voxels along x, y, z; 0 0 0 means that the file says."});
    visit("type", o.type, FieldInfo{"", {}, "Type of one sample."});
    visit("channels", o.channels, FieldInfo{"", {1, 4}, "Samples per voxel."});
    visit("bigEndian", o.bigEndian, FieldInfo{"", {}, "Byte order of samples of more than one byte."});
    visit("headerBytes", o.headerBytes, FieldInfo{"byte", {0, 2147483647}, "Bytes to skip at the start."});
  }
};

/// Where data comes from and how it is to be read. A saved path is relative to the scene file.
struct Source {
  std::string path;           ///< file, or folder of images
  std::string series;         ///< DICOM SeriesInstanceUID when the folder holds several; empty: the largest. Of a store
                              ///< (Zarr): the path of an image in it; empty: the first
  int level = kFittingLevel;  ///< of a pyramid: 0 the finest
  RawLayout raw;              ///< for files without a header
  glm::dvec3 spacing{0.0};    ///< overrides the file's spacing where positive
  std::string fingerprint;    ///< of the file when it was read, to know it again (session/Sources.h); empty: not known
  bool operator==(const Source&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("path", o.path, FieldInfo{"", {}, "File or folder, relative to the scene file."});
    visit(
        "series", o.series,
        FieldInfo{"", {}, "DICOM series UID, when the folder holds several; of a Zarr store: path of an image in it."});
    visit("level", o.level,
          FieldInfo{.range = {kFittingLevel, 62},
                    .doc = "Level of a pyramid, 0 the finest; -1: the finest that fits into memory.",
                    .leftOutByDefault = true});
    visit("raw", o.raw, FieldInfo{"", {}, "How to read a file without a header."});
    visit("spacing", o.spacing,
          FieldInfo{"", {0, kMostSpacing}, "Overrides the file's voxel spacing where positive, in the file's unit."});
    visit("fingerprint", o.fingerprint,
          FieldInfo{"", {}, "Size and hash of the file when it was read; empty: not known."});
  }
};

}  // namespace velum::scene
