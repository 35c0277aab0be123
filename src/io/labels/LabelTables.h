#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/LabelVolume.h"

namespace velum::io {

/// The label table of a CaretExtension (XML); empty when the text is none.
std::vector<LabelInfo> parseCaretLabels(std::string_view xml);
/// A segment of a 3D Slicer .seg.nrrd: the voxels of one layer (channel) that have one value.
struct SlicerSegment {
  int layer = 0;
  std::uint16_t value = 0;
  LabelInfo label;  ///< The id is the value, or a number of its own where layers use a value twice.
};
/// The segments among the key/value pairs of a NRRD; empty when there are none.
std::vector<SlicerSegment> parseSlicerSegments(const std::map<std::string, std::string>& keyValues);
/// Ids of regions that a file numbers as it likes: the number where it is an id that none before has, else the smallest
/// that nobody wants. Of more than 65535 regions the last share one.
std::vector<std::uint16_t> idsApart(const std::vector<int>& numbers);
/// Sorts by id, drops 0 and repeated ids, and makes up what @p inUse lacks.
std::vector<LabelInfo> completeTable(std::vector<LabelInfo> table, const std::vector<std::uint16_t>& inUse);

/// How a DICOM segment, whose number is its place in the file, keeps the id of its structure: "velum 12".
std::string trackingIdOf(std::uint16_t id);
/// The id in it; nothing when it is of another program.
std::optional<std::uint16_t> idOfTrackingId(std::string_view text);

}  // namespace velum::io
