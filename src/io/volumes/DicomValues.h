#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace gdcm {
class DataSet;
}

/// Meanings of stored samples of DICOM files, beside slope and intercept.
namespace velum::io {

/// A Modality LUT: the value that each stored sample stands for. Empty where the file has none.
struct DicomTable {
  int first = 0;                       ///< The sample of the first entry; lower ones mean the same.
  std::vector<std::uint16_t> entries;  ///< Samples above the last entry's mean the same as that.
  std::string unit;

  double at(double sample) const {
    double last = double(entries.size()) - 1;
    return entries[std::size_t(std::clamp(sample - first, 0.0, last))];
  }
};

/// The colours that stored samples stand for where they are indices of colours (PALETTE COLOR). Empty where the file
/// has none.
struct DicomPalette {
  int first = 0;                          ///< The sample of the first entry; lower ones mean the same.
  int bits = 16;                          ///< Bits of each of red, green and blue: 8 or 16.
  std::vector<std::uint16_t> entries[3];  ///< Red, green, blue, equally many; higher samples mean the last.
};

/// The palette of a file. @param isSigned  the stored samples are signed
/// @param[out] flaw  why there is no palette, for people; not changed when there is one
DicomPalette paletteOf(const gdcm::DataSet& set, bool isSigned, std::string& flaw);

/// The Modality LUT of a file; without entries when the file has none.
/// @param isSigned  the stored samples are signed, and so is the first sample in the LUT's descriptor
/// @param[out] flaw  why the LUT cannot be applied, for people; not changed when it can
DicomTable modalityTableOf(const gdcm::DataSet& set, bool isSigned, std::string& flaw);

/// Unit of the values, in words for people, from Rescale Type or Modality LUT Type ("HU", "MGML"); "" when not
/// specified.
std::string unitOfRescaleType(const std::string& type);
/// Unit of the values from PET's Units (0054,1001) and, for uptake values, SUV Type (0054,1006).
std::string unitOfPet(const gdcm::DataSet& set);

/// The offsets of the planes of a radiation dose along their normal from the first, mm.
/// @param first  position of the first plane, LPS; @param normal  of the planes
/// @return one a plane; empty when the file has none
/// @param[out] flaw, warning  what is wrong with the offsets, for people; not changed when nothing is
std::vector<double> doseOffsetsOf(const gdcm::DataSet& set, int planes, double firstZ, double normalZ,
                                  std::string& flaw, std::string& warning);

}  // namespace velum::io
