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

/// Strength of what is protected by one click.
inline constexpr double kProtectStrength = 100.0;

/// "Protect this": the membrane is to leave the material at a place whole, that is all with values like it; the
/// brightest (or darkest) material of the data with all that is brighter (darker). What was protected before stays so.
/// @param strength  < 0 draws the sheet to the material instead; 0 lets it through
/// @return what was measured; nothing, and no change, outside the volume
std::optional<Tissue> protectTissue(scene::Membrane& membrane, const scene::VolumeLayer& layer, glm::dvec3 world,
                                    double strength = kProtectStrength);

/// The same for a structure. @param id  label id; 0 does nothing
void protectStructure(scene::Membrane& membrane, int id, double strength = kProtectStrength);

/// What a membrane can protect by protectStructure(): the scene's structures, or, where a model is all that there is,
/// its types, numbered from 1, in their colours.
std::vector<scene::Structure> protectableStructures(const scene::Scene& scene);
/// True where these are a model's types.
bool protectsTypes(const scene::Scene& scene);
/// The numbers of the types with this path, or in the compartment with it and below, ascending. @param path  with dots,
/// or its last parts ("capsid", "capsid.CA")
std::vector<int> protectableTypes(const Model& model, std::string_view path);

/// The same for all values from `low` to `high`, in the volume's unit.
void protectValues(scene::Membrane& membrane, double low, double high, double strength = kProtectStrength);

/// Chooses how kernels push, with the cloth that goes with it: by the sided rule a loose one that hugs the rest plane,
/// as its corridor keeps it off what is protected; by the paper's a stiffer one, so that it wraps around what repels
/// it.
void setRule(scene::Membrane& membrane, scene::KernelRule rule);

}  // namespace velum::session
