#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/Model.h"
#include "scene/ModelLayer.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// Types of a model by their places in Model::types, any order.
using TypeNumbers = std::vector<std::uint32_t>;

/// The names from the root to a compartment with dots between them, as pathOf() of a type.
std::string compartmentPath(const Model& model, std::uint32_t compartment);
/// All types in a compartment and below it, ascending.
TypeNumbers typesBelow(const Model& model, std::uint32_t compartment);

/// Which types are drawn, by their places in the model; empty without a model.
std::vector<bool> visibleTypes(const scene::ModelLayer& layer);
/// Which have a colour of their own rather than the palette's.
std::vector<bool> ownColors(const scene::ModelLayer& layer);

/// The name of an undo step: "Hide CA", "Hide 3 types".
std::string typesLabel(const scene::Scene& scene, std::string_view verb, const TypeNumbers& types);

// Edits. Places that the model does not have are left out; a type of which nothing is left to say goes from the list.
void setTypesVisible(scene::Scene& scene, const TypeNumbers& types, bool visible);
/// @param color  sRGB; none: the palette's again
void setTypesColor(scene::Scene& scene, const TypeNumbers& types, std::optional<glm::vec3> color);
/// How their instances show that cuts have removed. @param ghosts  none: as the layer says
void setTypesGhosts(scene::Scene& scene, const TypeNumbers& types, std::optional<scene::Ghosts> ghosts);
/// How many instances of a type or compartment are to be seen. @param visible  none: any number
void setVisibleTarget(scene::Scene& scene, std::string_view path, std::optional<double> visible);
/// The number that is wanted; none where any will do.
std::optional<double> visibleTarget(const scene::Scene& scene, std::string_view path);
/// Shown, in the palette's colours, as nothing is said of them.
void resetTypes(scene::Scene& scene, const TypeNumbers& types);

/// What was shown before some types were shown alone. Passing state.
struct TypeSoloMemory {
  TypeNumbers alone;        ///< ascending; none: the rest means nothing
  std::vector<bool> shown;  ///< by type
};
/// These types and no others are shown.
bool isSolo(const scene::Scene& scene, const TypeNumbers& types);
/// Shows types alone, or, where they are alone already, what was shown before: all, where that is not known. From some
/// that are alone to others, what was shown before both is kept.
/// @return the memory for the next call
TypeSoloMemory toggleSoloTypes(scene::Scene& scene, const TypeSoloMemory& memory, TypeNumbers types);

/// Where an instance stands.
struct InstancePlace {
  glm::dvec3 middle{0.0};    ///< of its sphere, world
  double radius = 0.0;       ///< of it
  std::uint32_t type = 0;    ///< in Model::types
  std::uint32_t ofType = 0;  ///< the how-manyth of its type, from 0
  std::uint32_t copy = 0;    ///< of the model
};
/// @param instance  over all copies, as render::Pick has it; nothing where there is no such one
std::optional<InstancePlace> instancePlace(const scene::Scene& scene, std::uint32_t instance);

/// A ball around all instances of some types, in all copies; radius 0 where there are none. Only middle and radius.
InstancePlace ballAround(const scene::Scene& scene, const TypeNumbers& types);

}  // namespace velum::session
