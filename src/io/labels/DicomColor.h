#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace velum::io {

/// DICOM's CIELab: D50, each from its least to its largest value in 16 bits.
using DicomLab = std::array<std::uint16_t, 3>;

glm::vec3 srgbFromDicomLab(const DicomLab& lab);
/// @param srgb  0..1
DicomLab dicomLabFromSrgb(const glm::vec3& srgb);

}  // namespace velum::io
