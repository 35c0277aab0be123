#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace gdcm {
class DataSet;
}

/// What stored samples of DICOM files mean, beside slope and intercept.
namespace velum::io {

/// A Modality LUT: which value a stored sample stands for. Without entries there is none.
struct DicomTable {
  int first = 0;                       ///< The sample of the first entry; lower ones mean the same.
  std::vector<std::uint16_t> entries;  ///< Higher samples than its last mean that.
  std::string unit;

  double at(double sample) const {
    double last = double(entries.size()) - 1;
    return entries[std::size_t(std::clamp(sample - first, 0.0, last))];
  }
};

/// What stored samples stand for where they are numbers of colours (PALETTE COLOR). Without entries there is none.
struct DicomPalette {
  int first = 0;                          ///< The sample of the first entry; lower ones mean the same.
  int bits = 16;                          ///< Of red, green and blue: 8 or 16.
  std::vector<std::uint16_t> entries[3];  ///< Red, green, blue, equally many; higher samples mean the last.
};

/// The palette of a file. @param isSigned  of the stored samples
/// @param[out] flaw  why there is none, for people; left alone when there is one
DicomPalette paletteOf(const gdcm::DataSet& set, bool isSigned, std::string& flaw);

/// The Modality LUT of a file; of no entries when it has none.
/// @param isSigned  of the stored samples: the descriptor's first sample is of their kind
/// @param[out] flaw  why it cannot be applied, for people; left alone when it can
DicomTable modalityTableOf(const gdcm::DataSet& set, bool isSigned, std::string& flaw);

/// Unit of the values in words of people: of Rescale Type or Modality LUT Type ("HU", "MGML"); "" when not specified.
std::string unitOfRescaleType(const std::string& type);
/// The same of PET's Units (0054,1001) and, for uptake values, SUV Type (0054,1006).
std::string unitOfPet(const gdcm::DataSet& set);

/// The offsets of the planes of a radiation dose along their normal from the first, mm.
/// @param first  position of the first plane, LPS; @param normal  of the planes
/// @return one a plane; empty when the file has none
/// @param[out] flaw, warning  what is wrong with them, for people; left alone when nothing is
std::vector<double> doseOffsetsOf(const gdcm::DataSet& set, int planes, double firstZ, double normalZ,
                                  std::string& flaw, std::string& warning);

}  // namespace velum::io
