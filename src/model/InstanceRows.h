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

/// Colour by type, [types]; alpha: kType* of shaders/shared/instance.h.
std::vector<shared::TypeRow> makeTypeRows(const scene::ModelLayer& layer);

/// What the enabled cuts leave of each type, [types][enabled cuts], lengths as in the scene.
std::vector<shared::TypeSpareRow> makeTypeSpareRows(const scene::Scene& scene);

/// A bit for each of the first 32 enabled cuts that removes an instance only when all of it is inside.
std::uint32_t wholeInstanceBits(const scene::Scene& scene);

/// What a cut leaves of a type: the longest path in ModelCut::spares that is the type's or that of a compartment above
/// it; nothing where there is none, or where the type's mass or number is out of the cut's ranges.
scene::TypeSpare typeSpareOf(const scene::Cut& cut, const Model& model, const MoleculeType& type,
                             std::string_view path);

}  // namespace velum::model
