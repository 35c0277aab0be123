#pragma once
#include <cstdint>
#include <vector>

#include "shared/cuts.h"
#include "velum/scene/Scene.h"

namespace velum::shared {

inline bool operator==(const CutSpare& a, const CutSpare& b) { return a.distance == b.distance && a.share == b.share; }

}  // namespace velum::shared

namespace velum::render {

/// What the enabled cuts of a scene spare, by structure. Structures that no cut spares take four bytes up to the
/// largest id that some cut spares, and nothing where no cut spares any.
struct SpareTable {
  std::vector<std::uint32_t> rowOf;    ///< by structure: its row from 1; 0: no cut spares it
  std::vector<shared::CutSpare> rows;  ///< [rows][enabled cuts, in their order]
  std::size_t cuts = 0;                ///< enabled ones
  bool hasDepths = false;              ///< some spare ends somewhere

  bool isEmpty() const { return rows.empty(); }
  /// What an enabled cut spares of a structure. @param cut  which of the enabled ones
  shared::CutSpare of(std::uint32_t structure, std::size_t cut) const;
  bool operator==(const SpareTable&) const = default;
};

SpareTable makeSpareTable(const scene::Scene& scene);

/// The table as shaders read it (spareTexture of common/cuts.glsl): how many structures it knows, for each of these the
/// place after which its spares begin, or 0, then all spares as bits of floats.
std::vector<glm::uvec2> spareTexels(const SpareTable& table);

}  // namespace velum::render
