#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

#include "core/LabelVolume.h"

namespace velum::io {

/// Texts that our writer puts into the header's description of a volume whose orientation, or spacing, is unknown; both
/// may be there.
inline constexpr std::string_view kOrientationUnknown = "velum: orientation unknown";
inline constexpr std::string_view kSpacingUnknown = "velum: spacing unknown";

/// The fields of a NIfTI-1, NIfTI-2 or Analyze 7.5 header that matter to us, in machine byte order, as the file has
/// them.
struct NiftiHeader {
  std::filesystem::path file;   ///< The file that holds the header.
  std::filesystem::path image;  ///< The file that holds the voxels: the same, or the .img of a pair.
  bool bigEndian = false;
  bool saysUnknown = false;    ///< Its description has kOrientationUnknown.
  bool saysNoSpacing = false;  ///< Its description has kSpacingUnknown.
  bool hasOrientation = true;  ///< False for Analyze 7.5.
  std::size_t headerBytes = 348;
  std::array<std::int64_t, 8> dim{};
  std::array<double, 8> pixdim{};
  int intent = 0;
  int datatype = 0;
  double dataOffset = 0;  ///< Bytes before the voxels, after inflating.
  double slope = 0, intercept = 0;
  int units = 0;
  int qformCode = 0, sformCode = 0;
  glm::dvec3 quaternion{0.0}, qoffset{0.0};
  std::array<glm::dvec3, 4> sform{};  ///< Columns.
};

/// @param file  .nii, .nii.gz, or either half of a pair. @throw InputError when the file is none of these, or the other
/// half of a pair is missing
NiftiHeader readNiftiHeader(const std::filesystem::path& file);
/// The texts of the extensions between header and voxels, up to the first that is not whole.
std::vector<std::string> readNiftiExtensions(const NiftiHeader& header);

}  // namespace velum::io
