#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "scene/ModelLayer.h"

namespace velum::scene {

/// The colour of each type by a palette, sRGB. In the palette by type, each compartment and its surface has a family of
/// hues, in which types of the same function look alike; types of the surrounding medium, such as plasma around a
/// virus, are pale and warm, in many hues.
std::vector<glm::vec3> paletteColors(const Model& model, Palette palette);

}  // namespace velum::scene
