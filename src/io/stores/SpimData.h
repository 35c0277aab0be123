#pragma once
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/read/Refuse.h"

namespace velum::io {

/// What the XML of BigDataViewer (SpimData) says.
struct SpimData {
  /// A view setup: what one camera took from one side of one tile.
  struct Setup {
    int id = 0;
    std::string name;
    std::optional<glm::ivec3> size;  ///< voxels
    std::optional<glm::dvec3> voxelSize;
    std::string unit;
    std::map<std::string, std::string> attributes;  ///< "channel", "tile", "angle", "illumination": ids as text
  };
  std::string format;                                                ///< of the voxels: "bdv.hdf5", "bdv.n5", ...
  Path voxels;                                                       ///< the file or folder that holds them
  std::vector<Setup> setups;                                         ///< in the file's order
  std::vector<int> timePoints;                                       ///< their ids, in the file's order; never empty
  std::map<std::pair<int, int>, glm::dmat4> worldFrom;               ///< of (time point, setup): place of a voxel
  std::map<std::pair<std::string, std::string>, std::string> names;  ///< of (attribute, id)
};

/// @throw InputError for what is no such XML, is damaged, or names voxels that are not there
SpimData readSpimData(const Path& xml);

/// What the XML beside a file or folder of voxels says; nothing where there is none, or it names others.
std::optional<SpimData> spimDataBeside(const Path& voxels);

/// True for the first bytes of such an XML.
bool isSpimData(std::string_view head);

}  // namespace velum::io
