#pragma once
#include <optional>
#include <span>
#include <string>

namespace gdcm {
class DataSet;
}

namespace velum::io {

/// What a PET file says of dose and time; times in seconds since a common day, in the scanner's zone.
struct DicomPet {
  std::string units, decayCorrection;
  bool isCorrected = false;  ///< For attenuation and decay.
  std::optional<double> seriesTime, acquisitionTime;
  std::optional<double> privateScanTime;  ///< GE's, for series that were made later.
  std::optional<double> injectionTime;    ///< Of the same day as the series where the file gives none.
  double weightKg = 0, doseBq = 0, halfLifeS = 0;
  double frameReferenceS = 0, frameDurationS = 0;  ///< 0 when not given.
};

DicomPet petOf(const gdcm::DataSet& set);

/// How activity becomes uptake.
struct Uptake {
  double perActivity = 0;  ///< SUVbw of a Bq/ml; 0: it cannot be had
  std::string note;        ///< where the factor comes from, or what the file lacks for it, for people
};

/// The factor from Bq/ml to the standardised uptake value by body weight, as QIBA's vendor-neutral pseudo-code has it;
/// nothing of both when the values are no activity concentration.
/// @param files  of one series, at least one
Uptake uptakeOf(std::span<const DicomPet* const> files);

}  // namespace velum::io
