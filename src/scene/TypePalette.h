#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "scene/ModelLayer.h"

namespace velum::scene {

/// The colour of each type by a palette, sRGB. By type: families of hues for compartments and their surfaces, in which
/// types that do the same look alike; what all else swims in, as plasma around a virus, is pale and warm and has many
/// hues.
std::vector<glm::vec3> paletteColors(const Model& model, Palette palette);

}  // namespace velum::scene
