#pragma once
#include <glm/glm.hpp>
#include <string>

#include "read/FileBytes.h"
#include "velum/core/Volume.h"

namespace velum::io {

/// What a .vti says before its voxels.
struct VtiHeader {
  glm::dvec3 dims{0.0};  ///< Points (or cells) along each axis.
  double components = 1;
  SampleType type = SampleType::UInt8;  ///< For its size: 64-bit integers stand as Float64.
  std::string arrayName;
  bool isCellData = false, hasDirection = false;
  bool isCompressed = false, isLzma = false, isAscii = false;
};

/// Reads the tags in front of the voxels and the block table of a compressed array, at most a few hundred KiB.
/// @throw InputError when it is no .vti, has no array, or its block table does not fit the voxels
VtiHeader parseVtiHeader(const FileBytes& file, const std::string& name);

}  // namespace velum::io
