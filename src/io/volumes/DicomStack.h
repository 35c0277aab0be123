#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "io/volumes/DicomFile.h"

namespace velum::io {

/// How the planes of a series form a volume.
struct DicomStack {
  int planes = 0;  ///< Places along the stacking direction that have a plane.
  int timeSteps = 1;
  std::vector<int> slots;         ///< Per frame of the input: time * planes + plane, or -1 for one that is left out.
  std::vector<double> positions;  ///< Of each plane in units of the even grid: 0, 1, 2 where nothing is missing.
  int gridPlanes = 0;             ///< Planes of the even grid; more than `planes` where some are missing.
  bool isEven = true;             ///< positions are 0, 1, 2, ...
  std::vector<glm::ivec2> gaps;   ///< Planes of the even grid that no plane is near, {first, count}.
  double farthest = 0;            ///< Planes farther apart, in units of the even grid, have nothing between them.
  glm::dmat4 worldFromVoxel{1.0};
  bool isOrientationKnown = true;
  bool isSpacingKnown = true;
  std::vector<std::string> warnings;
};

/// Orders frames by their place along the normal, never by name; finds repeats, gaps and tilt.
/// @param frames   of equal orientation
/// @param preferred  index of a file whose frames win over others at the same place; -1 for none
/// Between planes that are more than a few steps or 25 mm apart nothing is known: these are parts of a body with
/// nothing in between.
/// @throw InputError, naming @p path, when nearly all of the planes are missing
DicomStack stackFrames(const std::vector<DicomFrame>& frames, int preferred, const std::filesystem::path& path);

}  // namespace velum::io
