#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string_view>

namespace velum::scene {

/// The colour in which atlases print what has such a name: bones bone-coloured, arteries red, veins blue, the liver
/// brown. Knows names as TotalSegmentator, FreeSurfer and BodyParts write them, and plain English. sRGB; nothing for a
/// name that it does not know.
std::optional<glm::vec3> anatomyColor(std::string_view name);

/// True of a name of the skin.
bool isSkin(std::string_view name);

/// A colour for a structure of which a file says none: its anatomy's, neighbours in the list a shade apart; else a calm
/// one of many, in which a shaded surface is read well. The same id and name give the same colour.
glm::vec3 solidColor(std::uint16_t id, std::string_view name);

}  // namespace velum::scene
