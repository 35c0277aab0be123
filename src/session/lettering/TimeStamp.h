#pragma once
#include <optional>
#include <string>

#include "scene/SceneFwd.h"

namespace velum::session {

/// The time of a time step, as people read it: "0.42 s", "15 ms", "2:05 min", "1:02:05 h", with as many decimals as
/// tell the steps apart, the same for all of them.
/// @param step, steps  from 0; how many there are  @param seconds  from a step to the next, > 0
std::string timeText(int step, int steps, double seconds);

/// The time that is written over pictures.
struct TimeStamp {
  std::string text;    ///< timeText(), or "step 3 of 10" where nobody knows how long a step is
  std::string widest;  ///< that of the last step, which no other is wider than where digits are equally wide
};
/// That of a scene's current time step; none where its volume has no time.
std::optional<TimeStamp> timeStampOf(const scene::Scene& scene);

}  // namespace velum::session
