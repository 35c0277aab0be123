#pragma once
#include <string_view>

namespace velum::io {

/// A term of SNOMED CT, as DICOM codes what a segment is.
struct DicomCode {
  std::string_view value, meaning;
};
struct SegmentCodes {
  DicomCode category, type;
};

/// What a structure of this name is, as far as words of its name say; an anatomical structure else.
SegmentCodes segmentCodesOf(std::string_view name);

}  // namespace velum::io
