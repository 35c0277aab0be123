#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string_view>

namespace velum::session {

/// Takes a place as somebody types it, "x,y,z", from the front of a text. @return nothing, and takes some of it, where
/// there is none
std::optional<glm::dvec3> takePlace(std::string_view& text);

}  // namespace velum::session
