#pragma once
#include <cstdint>
#include <vector>

#include "scene/SceneFwd.h"
#include "shared/cuts.h"

namespace velum::render {

/// What the enabled cuts of a scene spare, by structure. Memory: four bytes for each id up to the largest that some cut
/// spares, beside the rows; nothing where no cut spares any structure.
struct SpareTable {
  std::vector<std::uint32_t> rowOf;  ///< by structure: its row from 1; 0: no cut spares it
  /// [rows][enabled cuts, in their order]: how deep the cut leaves the structure, scene frame
  std::vector<float> depths;
  std::size_t cuts = 0;    ///< how many cuts are enabled
  bool hasDepths = false;  ///< some spare ends at a depth

  bool isEmpty() const { return depths.empty(); }
  /// How deep an enabled cut leaves a structure in its removed side; 0: not at all; shared::kCutFar: all of it.
  /// @param cut  index among the enabled cuts
  float depthOf(std::uint32_t structure, std::size_t cut) const;
  bool operator==(const SpareTable&) const = default;
};

SpareTable makeSpareTable(const scene::Scene& scene);

/// The table as shaders read it (spareTexture of common/cuts.glsl): the number of structures in the table; for each
/// structure the place after which its depths begin, or 0; then all depths as bits of floats.
std::vector<std::uint32_t> spareTexels(const SpareTable& table);

}  // namespace velum::render
