#include "session/TypedPlace.h"

#include <cmath>

#include "core/Text.h"

namespace velum::session {

std::optional<glm::dvec3> takePlace(std::string_view& text) {
  glm::dvec3 place(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0 && !text.starts_with(',')) return std::nullopt;
    if (axis > 0) text.remove_prefix(1);
    auto number = takeNumber(text);
    if (!number || !std::isfinite(*number)) return std::nullopt;
    place[axis] = *number;
  }
  return place;
}

}  // namespace velum::session
