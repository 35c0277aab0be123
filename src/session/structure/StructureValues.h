#pragma once
#include <cstdint>
#include <map>

#include "core/LabelVolume.h"
#include "core/Task.h"
#include "core/Volume.h"

namespace velum::session {

/// What a scan measured in a structure, in the unit of its values.
struct StructureValues {
  std::uint64_t voxels = 0;  ///< of the scan, those with finite values whose middles lie in the structure
  double mean = 0, deviation = 0, least = 0, most = 0;
};

/// Values of all structures in which middles of the scan's voxels lie, by id: as they were measured, nothing between
/// voxels. Several channels: the one that is asked for. O(voxels of the scan), all cores.
/// @throw Cancelled. Any thread.
std::map<int, StructureValues> measureValues(const LabelVolume& labels, const Volume& scan, int channel, int timeStep,
                                             Progress& progress);

}  // namespace velum::session
