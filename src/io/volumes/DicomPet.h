#pragma once
#include <optional>
#include <span>
#include <string>

namespace gdcm {
class DataSet;
}

namespace velum::io {

/// What a PET file says of dose and time; times are in seconds since a day common to all of them, in the scanner's time
/// zone.
struct DicomPet {
  std::string units, decayCorrection;
  bool isCorrected = false;  ///< The values are corrected for attenuation and decay.
  std::optional<double> seriesTime, acquisitionTime;
  /// From GE's private element; the scan's time for series that were made later.
  std::optional<double> privateScanTime;
  std::optional<double> injectionTime;  ///< Taken as on the day of the series where the file gives no day.
  double weightKg = 0, doseBq = 0, halfLifeS = 0;
  double frameReferenceS = 0, frameDurationS = 0;  ///< 0 when not given.
};

DicomPet petOf(const gdcm::DataSet& set);

/// The factor from activity to uptake.
struct Uptake {
  double perActivity = 0;  ///< SUVbw of one Bq/ml; 0: the factor cannot be computed
  std::string note;        ///< how the factor was found, or what the file lacks for it, for people
};

/// The factor from Bq/ml to the standardised uptake value by body weight, as QIBA's vendor-neutral pseudo-code has it;
/// both members stay empty when the values are not activity concentrations.
/// @param files  of one series, at least one
Uptake uptakeOf(std::span<const DicomPet* const> files);

}  // namespace velum::io
