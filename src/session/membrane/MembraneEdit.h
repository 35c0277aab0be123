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

/// What a membrane can protect by protectStructure(): the scene's structures, or, where a model is all that there is,
/// its types, numbered from 1, in their colours.
std::vector<scene::Structure> protectableStructures(const scene::Scene& scene);
/// True where protectableStructures() are the types of a model.
bool protectsTypes(const scene::Scene& scene);
/// The numbers, as of protectableStructures(), of the types with a path, or in the compartment with this path and
/// below, ascending. @param path  with dots, or its last parts ("capsid", "capsid.CA")
std::vector<int> protectableTypes(const Model& model, std::string_view path);

/// Protects all values from `low` to `high`, in the volume's unit, in the same way.
void protectValues(scene::Membrane& membrane, double low, double high, double strength = kProtectStrength);

/// Chooses the rule by which kernels push, and sets the cloth that goes with it. The sided rule gets a loose cloth that
/// hugs the rest plane, as the rule's corridor keeps the cloth off what is protected; the paper's rule gets a stiffer
/// cloth, which wraps around what repels it.
void setRule(scene::Membrane& membrane, scene::KernelRule rule);

}  // namespace velum::session
