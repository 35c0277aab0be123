#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "scene/ModelLayer.h"

namespace velum::scene {

/// The colour of each type by a palette, sRGB. Lipids are cream and nucleic acids yellow in all of them. In the palette
/// by compartment, each compartment and its surface has a family's hue, that of the surrounding medium, such as plasma
/// around a virus, pale and warm. In the palette by type, the types of a family differ by steps in lightness, those of
/// the same function by less. In the palette by function, types of which it is not known are grey.
std::vector<glm::vec3> paletteColors(const Model& model, Palette palette);

/// Whether it is known of any type what it does: of more than lipids and nucleic acids.
bool knowsFunctions(const Model& model);

}  // namespace velum::scene
