#pragma once
#include <cstdint>
#include <map>

#include "core/LabelVolume.h"
#include "core/Task.h"
#include "core/Volume.h"

namespace velum::session {

/// The values that a scan has in a structure, in the unit of its values.
struct StructureValues {
  std::uint64_t voxels = 0;  ///< of the scan: those with finite values whose middles lie in the structure
  double mean = 0, deviation = 0, least = 0, most = 0;
};

/// Values of all structures in which middles of the scan's voxels lie, by id. Values are as they were measured; nothing
/// is interpolated between voxels. Of a scan that is streamed the voxels of its finest level count; bricks
/// in which nothing is labelled are not read. Of several channels the given one is measured. O(voxels of the scan), or
/// of bricks with labels; all cores.
/// @throw Cancelled; InputError when a brick cannot be read. Any thread.
std::map<int, StructureValues> measureValues(const LabelVolume& labels, const Volume& scan, int channel, int timeStep,
                                             Progress& progress);

}  // namespace velum::session
