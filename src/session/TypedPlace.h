#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string_view>

namespace velum::session {

/// Reads a place as somebody types it, "x,y,z", and takes it off the front of `text`. @return nothing where the text
/// does not begin with a place; part of the text may be taken off even then
std::optional<glm::dvec3> takePlace(std::string_view& text);

}  // namespace velum::session
