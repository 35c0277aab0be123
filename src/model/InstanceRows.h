#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/Model.h"
#include "scene/SceneFwd.h"
#include "scene/Spare.h"

namespace velum::shared {
struct TypeRow;
struct TypeSpareRow;
}  // namespace velum::shared

namespace velum::model {

/// The row of each type, [types]: its colour; alpha holds the kType* flags of shaders/shared/instance.h.
std::vector<shared::TypeRow> makeTypeRows(const scene::ModelLayer& layer);

/// What the enabled cuts leave of each type, [types][enabled cuts], lengths as in the scene.
std::vector<shared::TypeSpareRow> makeTypeSpareRows(const scene::Scene& scene);

/// A word with a bit for each of the first 32 enabled cuts: set when the cut removes an instance only if all of it is
/// inside.
std::uint32_t wholeInstanceBits(const scene::Scene& scene);

/// What a cut leaves of a type: the spare in ModelCut::spares with the longest path that is the type's own or that of a
/// compartment above it. A spare that leaves nothing where there is no such path, or where the type's mass or number of
/// instances is out of the cut's ranges.
scene::TypeSpare typeSpareOf(const scene::Cut& cut, const Model& model, const MoleculeType& type,
                             std::string_view path);

}  // namespace velum::model
