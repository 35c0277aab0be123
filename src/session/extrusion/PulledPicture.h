#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/Task.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// A structure that a hand is pulling out of a cut.
struct Pulled {
  int cut = 0;  ///< id of the cut
  int structure = 0;
  double distance = 0.0;  ///< how far it stands out now
  double before = 0.0;    ///< how far it stands out in the picture over which this one is laid
  bool operator==(const Pulled&) const = default;
};

/// An overlay over a picture that stays as it is while a hand pulls.
struct PulledPicture {
  int width = 0, height = 0;
  std::vector<std::uint32_t> pixels;  ///< 0xAARRGGBB, premultiplied, shape [height][width]; 0 where nothing shows
};

/// Draws structures that stand out of cuts, as far as they have been found, over a picture that stays, so that a hand
/// that pulls sees at once what it has: the structures' voxels that border on something else or on the end of the
/// distance, in the curve's colours, lit from the eye. The part that stood out farther before is dimmed. Made for
/// speed, some milliseconds for a million voxels; the renderer draws the picture that stays. Nothing shows of a face
/// that is seen from behind.
///
/// No GL; any thread. Runs in that thread alone: other threads may be busy, and the slowest would be waited for.
/// @param size  of the overlay, pixels; the whole picture
/// @throw Cancelled
PulledPicture drawPulled(const scene::Scene& scene, const std::vector<Pulled>& pulled, glm::ivec2 size,
                         const Progress& progress);

}  // namespace velum::session
