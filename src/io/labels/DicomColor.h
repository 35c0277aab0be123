#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace velum::io {

/// A colour in DICOM's CIELab (white D50): 16 bits each, from the least to the largest value of L, a and b.
using DicomLab = std::array<std::uint16_t, 3>;

glm::vec3 srgbFromDicomLab(const DicomLab& lab);
/// @param srgb  0..1
DicomLab dicomLabFromSrgb(const glm::vec3& srgb);

}  // namespace velum::io
