#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/Image.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// How many pixels of a picture show each type of its model.
struct TypePixels {
  std::vector<std::uint64_t> byType;  ///< empty: not known
  std::uint64_t all = 0;              ///< pixels of the picture, whatever they show
};
/// Counts the types of a picture. @param types  the type of each pixel; -1: none  @param count  of the model's types
TypePixels countPixels(std::span<const std::int32_t> types, std::size_t count);
/// Counts the types of a picture with the channel "type" (render::Layers). @param count  of the model's types
TypePixels countPixels(const Image& image, std::size_t count);

/// A type, or several that go together, or a structure, in a legend.
struct LegendEntry {
  std::string name;
  std::vector<glm::vec3> colors;  ///< sRGB, as the picture has them; of several types those of which it shows most
};
/// The entries of a scene's legend: those that it lists, or types of which the picture shows most, the most first, and
/// then the structures that are shown. What is called alike shares an entry. Nothing of layers that are not shown.
std::vector<LegendEntry> legendEntries(const scene::Scene& scene, const TypePixels& pixels);

}  // namespace velum::session
