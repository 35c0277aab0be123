#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "io/volumes/DicomFile.h"

namespace velum::io {

/// How the planes of a series form a volume.
struct DicomStack {
  int planes = 0;  ///< How many places along the stacking direction have a plane.
  int timeSteps = 1;
  /// For each frame of the input: time step * planes + plane, or -1 for a frame that is left out.
  std::vector<int> slots;
  /// Position of each plane in steps of the even grid: 0, 1, 2, ... where no plane is missing.
  std::vector<double> positions;
  int gridPlanes = 0;            ///< Planes of the even grid; more than `planes` where some are missing.
  bool isEven = true;            ///< positions are 0, 1, 2, ...
  std::vector<glm::ivec2> gaps;  ///< Planes of the even grid that no plane is near, {first, count}.
  double farthest = 0;           ///< Largest distance of planes, in steps of the even grid, between which values are
                                 ///< interpolated; see stackFrames().
  glm::dmat4 worldFromVoxel{1.0};
  bool isOrientationKnown = true;
  bool isSpacingKnown = true;
  std::vector<std::string> warnings;
};

/// Orders frames by their place along the normal, never by file name; finds repeated frames, gaps and tilt.
/// @param frames  of equal orientation
/// @param preferred  index of a file whose frames win over others at the same place; -1 for none Planes that are more
/// than a few steps or 25 mm apart count as separate parts of a body, with nothing known in between.
/// @throw InputError, naming @p path, when nearly all of the planes are missing
DicomStack stackFrames(const std::vector<DicomFrame>& frames, int preferred, const std::filesystem::path& path);

}  // namespace velum::io
