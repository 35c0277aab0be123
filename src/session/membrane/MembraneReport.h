#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "membrane/forces/Forces.h"
#include "membrane/forces/KeptWhole.h"
#include "membrane/forces/Limit.h"
#include "session/membrane/Advice.h"

namespace velum::session {

/// What a membrane is doing, for people.
struct MembraneStatus {
  enum class Phase {
    Computing,  ///< forces are on their way; the sheet keeps the forces that it has
    Settling,
    Paused,
    Resting
  };
  Phase phase = Phase::Resting;
  std::size_t kernels = 0;       ///< of the whole volume, or of the box of finer voxels
  membrane::ForceVoxels voxels;  ///< that forces and figures come from
  double forcesMs = 0;           ///< time that it took to make the forces
  glm::ivec2 particles{0};       ///< of the sheet as it is now
  int steps = 0;                 ///< since the sheet began to move
  double speed = 0;              ///< largest speed, length/s
  double stepMs = 0;             ///< time that one step takes
  bool isMeasured = false;       ///< the figures below are those of the sheet as it rests
  double keptWhole = 1.0;        ///< cut area of the sheet by that of the plane: 0 cuts nothing
  membrane::Shares shares;       ///< what becomes of what the plane would cut
  membrane::Fate fate;           ///< what becomes of all that is protected
  bool wantsAdvice = false;      ///< little is kept
  std::vector<Advice> advice;    ///< steps that help then, the best first
  membrane::LeftOut leftOut;     ///< specks that are left out of what is protected by value
  std::int64_t planePairs = 0;   ///< cut area: pairs of neighbouring protected voxels that the plane separates
  std::int64_t sheetPairs = 0;   ///< cut area: the pairs that the sheet separates
  double meanDistance = 0;       ///< of the sheet from the rest plane
  std::string error;             ///< why forces could not be made; empty: nothing is wrong
};

/// What became of one membrane.
struct MembraneReport {
  int cut = 0;  ///< its id
  std::string name;
  std::size_t kernels = 0;       ///< of the whole volume, or of the box of finer voxels
  membrane::ForceVoxels voxels;  ///< that forces and figures come from
  glm::ivec2 particles{0};       ///< of the sheet at rest
  int steps = 0;
  bool atRest = false;
  double stepMs = 0;  ///< mean time of a step with all its iterations, on the wall
  double kernelsMs = 0, leastCutMs = 0, totalMs = 0;
  std::optional<membrane::KeptWhole> kept;        ///< when asked for
  std::optional<membrane::KeptWholeLimit> limit;  ///< when asked for
  std::optional<membrane::LeftOut> leftOut;       ///< with `kept`
  std::vector<Advice> advice;  ///< with `kept`, where it is wanted and something helps, the best first
};

}  // namespace velum::session
