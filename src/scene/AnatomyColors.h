#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string_view>

namespace velum::scene {

/// The colour, sRGB, in which atlases print the structure with this name: bones bone-coloured, arteries red, veins
/// blue, the liver brown. Knows names as TotalSegmentator, FreeSurfer and BodyParts write them, and plain English;
/// nothing for an unknown name.
std::optional<glm::vec3> anatomyColor(std::string_view name);

/// True when a structure's name says that it is the skin.
bool isSkin(std::string_view name);

/// A colour for a structure for which the file gives none: that of its anatomy, with neighbours in the list a shade
/// apart; else one of many calm colours in which the form of a shaded surface is easy to see. The same id and name give
/// the same colour.
glm::vec3 solidColor(std::uint16_t id, std::string_view name);

}  // namespace velum::scene
