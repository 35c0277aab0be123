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

/// The names from the root to a compartment with dots between them, as pathOf() gives for a type.
std::string compartmentPath(const Model& model, std::uint32_t compartment);
/// All types in a compartment and below it, ascending.
TypeNumbers typesBelow(const Model& model, std::uint32_t compartment);

/// Which types are drawn, by their places in the model; empty without a model.
std::vector<bool> visibleTypes(const scene::ModelLayer& layer);
/// Which types have a colour of their own rather than the palette's, by their places in the model.
std::vector<bool> ownColors(const scene::ModelLayer& layer);

/// How words about a scene call a type or compartment: as its author does (scene::ownName()), else by the last name of
/// its path.
std::string nameAt(const scene::Scene& scene, std::string_view path);

/// The name of an undo step: "Hide CA", "Hide 3 types".
std::string typesLabel(const scene::Scene& scene, std::string_view verb, const TypeNumbers& types);

// Edits. Numbers of types that the model does not have are left out; a type whose entry says nothing any more goes from
// the scene's list of types.
void setTypesVisible(scene::Scene& scene, const TypeNumbers& types, bool visible);
/// @param color  sRGB; none: the palette's again
void setTypesColor(scene::Scene& scene, const TypeNumbers& types, std::optional<glm::vec3> color);
/// How the types' instances are shown where cuts have removed them. @param ghosts  none: as the layer says
void setTypesGhosts(scene::Scene& scene, const TypeNumbers& types, std::optional<scene::Ghosts> ghosts);
/// Gives a type or compartment another name. @param name  empty: the file's again
void rename(scene::Scene& scene, std::string_view path, std::string_view name);
/// Lists types, compartments or structures in the legend, which is turned on, or takes them out of its list.
/// @param paths  each gets an entry; of structures their names
void listInLegend(scene::Scene& scene, const std::vector<std::string>& paths, bool listed);
/// Sets how many instances of a type or compartment are to be seen, in the place of a number that was to be drawn.
/// @param visible  none: any number will do, drawn or seen
void setVisibleTarget(scene::Scene& scene, std::string_view path, std::optional<double> visible);
/// How many instances are to be seen; none where any number will do.
std::optional<double> visibleTarget(const scene::Scene& scene, std::string_view path);
/// The number, of drawn or of seen instances, that is set for a type or compartment; null where none is.
const scene::TypeTarget* targetOf(const scene::ModelLayer& layer, std::string_view path);
inline bool isHeld(const scene::ModelLayer& layer, std::string_view path) { return targetOf(layer, path) != nullptr; }
/// Notes that a hand has set how many instances of a type or compartment are drawn: numbers of its compartment hold it
/// from now on. The number of its instances to be seen is no more, nor are numbers of drawn ones of the compartments
/// that it is in, as they are others now.
void holdDrawn(scene::Scene& scene, std::string_view path, double drawn);
/// Forgets the numbers of a type or compartment, of all that is in it, and the drawn numbers of what it is in:
/// something else says now how many are drawn.
void dropTargets(scene::Scene& scene, std::string_view path);
/// True where a path is that of a type or compartment within a compartment, at any depth.
bool isWithin(std::string_view path, std::string_view compartment);
/// The types and compartments within a compartment whose numbers a hand has set, without those that are within another
/// of these; in the order of the scene's list.
std::vector<std::string> heldWithin(const scene::Scene& scene, std::string_view path);
/// Forgets how types look: they are shown, in the palette's colours. Their names stay.
void resetTypes(scene::Scene& scene, const TypeNumbers& types);

/// What was shown before some types were shown alone. Passing state.
struct TypeSoloMemory {
  TypeNumbers alone;        ///< the types shown alone, ascending; empty: `shown` means nothing
  std::vector<bool> shown;  ///< by type
};
/// True when these types and no others are shown.
bool isSolo(const scene::Scene& scene, const TypeNumbers& types);
/// Shows types alone, or, where these types are alone already, what was shown before them: all types, where that is not
/// known. When some types are alone and others are to be, what was shown before the first is kept.
/// @return the memory for the next call
TypeSoloMemory toggleSoloTypes(scene::Scene& scene, const TypeSoloMemory& memory, TypeNumbers types);

/// Where an instance stands, and which one of its type it is.
struct InstancePlace {
  glm::dvec3 middle{0.0};    ///< of its sphere, world
  double radius = 0.0;       ///< of its sphere, scene units
  std::uint32_t type = 0;    ///< in Model::types
  std::uint32_t ofType = 0;  ///< its number among the instances of its type, from 0
  std::uint32_t copy = 0;    ///< the copy of the model in which it stands, from 0
  bool isWhole = false;      ///< it is a whole copy, of a crowd: no type is meant
};
/// @param instance  its number over all copies, or of a crowd's copy, as render::Pick has it; nothing where there is no
/// such instance
std::optional<InstancePlace> instancePlace(const scene::Scene& scene, std::uint32_t instance);

/// A ball around all instances of some types, in all copies; radius 0 where there are none. Only `middle` and `radius`
/// are set.
InstancePlace ballAround(const scene::Scene& scene, const TypeNumbers& types);

}  // namespace velum::session
