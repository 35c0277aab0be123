#pragma once
#include <string_view>

namespace velum::io {

/// A term of SNOMED CT, by which DICOM says what a segment shows.
struct DicomCode {
  std::string_view value, meaning;
};
struct SegmentCodes {
  DicomCode category, type;
};

/// The codes for a structure, chosen by words of its name; those of "anatomical structure" where no word is known.
SegmentCodes segmentCodesOf(std::string_view name);

}  // namespace velum::io
