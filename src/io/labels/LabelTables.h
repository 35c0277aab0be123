#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/LabelVolume.h"

namespace velum::io {

/// The label table of a CaretExtension (XML); empty when the text is not one.
std::vector<LabelInfo> parseCaretLabels(std::string_view xml);
/// A segment of a 3D Slicer .seg.nrrd: the voxels of one layer (channel) that have one value.
struct SlicerSegment {
  int layer = 0;
  std::uint16_t value = 0;
  LabelInfo label;  ///< Its id is `value`, or another number where two layers use the same value.
};
/// The segments among the key/value pairs of a NRRD; empty when there are none.
std::vector<SlicerSegment> parseSlicerSegments(const std::map<std::string, std::string>& keyValues);
/// Ids for regions that a file numbers in any way: the region's number where that can be an id and no region before has
/// it, else the smallest id that is no region's number. Of more than 65535 regions the last ones share an id.
std::vector<std::uint16_t> idsApart(const std::vector<int>& numbers);
/// The table sorted by id, without 0 and repeated ids, and with made-up rows for ids of @p inUse that it lacks.
std::vector<LabelInfo> completeTable(std::vector<LabelInfo> table, const std::vector<std::uint16_t>& inUse);

/// The tracking id by which a DICOM segment, whose number is only its place in the file, keeps the id of its structure:
/// "velum 12".
std::string trackingIdOf(std::uint16_t id);
/// The structure's id in a tracking id; nothing when another program has written that.
std::optional<std::uint16_t> idOfTrackingId(std::string_view text);

}  // namespace velum::io
