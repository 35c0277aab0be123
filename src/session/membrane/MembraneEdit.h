#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "core/Model.h"
#include "scene/Membrane.h"
#include "scene/SceneFwd.h"
#include "scene/Structure.h"
#include "session/look/ShowThis.h"

namespace velum::session {

/// Strength with which one click protects something.
inline constexpr double kProtectStrength = 100.0;

/// "Protect this": the membrane is to leave the material at a place whole, that is, all data with values like it; for
/// the brightest (or darkest) material also all that is brighter (darker). What was protected before stays protected.
/// @param strength  < 0 draws the sheet to the material instead; 0 lets the sheet through
/// @return what was measured; nothing, and no change, outside the volume
std::optional<Tissue> protectTissue(scene::Membrane& membrane, const scene::VolumeLayer& layer, glm::dvec3 world,
                                    double strength = kProtectStrength);

/// Protects a structure in the same way. @param id  label id; 0 does nothing
void protectStructure(scene::Membrane& membrane, int id, double strength = kProtectStrength);

/// Protects the instances of a type of the model in the same way. @param path  the type's
void protectType(scene::Membrane& membrane, const std::string& path, double strength = kProtectStrength);

/// What a membrane can protect as a whole: a structure, or a type of the model.
struct Protectable {
  int structure = 0;  ///< label id; 0: it is a type
  std::string type;   ///< the type's path
  std::string name;   ///< for people; may be empty
  glm::vec3 color{0.0f};
  double strength = 0.0;  ///< in the field at hand; 0: no force
  bool operator==(const Protectable&) const = default;
};
/// The scene's structures, then the types of its model, with the strengths that a field gives them.
std::vector<Protectable> protectables(const scene::Scene& scene, const scene::ForceField& field);

/// The paths of the types with a path, or in the compartment with this path and below, in the model's order.
/// @param path  with dots, or its last parts ("capsid", "capsid.CA")
std::vector<std::string> protectableTypes(const Model& model, std::string_view path);
/// @throw ArgumentError that says what to do where there is no model that a sheet could go around
void expectModelInReach(const scene::Scene& scene);

/// Protects all values from `low` to `high`, in the volume's unit, in the same way.
void protectValues(scene::Membrane& membrane, double low, double high, double strength = kProtectStrength);

/// Chooses the rule by which kernels push, and sets the cloth that goes with it. The sided rule gets a loose cloth that
/// hugs the rest plane, as the rule's corridor keeps the cloth off what is protected; the paper's rule gets a stiffer
/// cloth, which wraps around what repels it.
void setRule(scene::Membrane& membrane, scene::KernelRule rule);

}  // namespace velum::session
