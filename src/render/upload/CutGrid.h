#pragma once
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "shared/cuts.h"

namespace velum::shared {

inline bool operator==(const CutData& a, const CutData& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace velum::shared

namespace velum::render {

/// The number of cuts from which on a grid is made; fewer cuts are tested faster one by one.
inline constexpr std::size_t kFewCuts = 8;

/// Which cuts matter where: for each of the kCutGrid^3 cells of the data's box, the list of the cuts that may remove
/// some of the cell, in their order. Where one cut removes the whole cell and nothing is spared, the list has only that
/// cut. Shaders read the texels (common/cuts.glsl): where the list of each cell begins, x fastest; where the list of
/// everything outside the box begins; where the last list ends; then the lists.
struct CutGrid {
  std::vector<std::uint32_t> texels;  ///< Empty: every cut matters everywhere.

  /// @param cell  number of the cell; kCutGrid^3: outside the box
  std::span<const std::uint32_t> cutsIn(std::size_t cell) const {
    return std::span(texels).subspan(texels[cell], texels[cell + 1] - texels[cell]);
  }
};

/// Made from the coarsest cells to the finest. Cost: about the number of cuts times the cells that their faces meet.
/// @param sceneFromTex  the data's box, as in FrameParams
/// @param hasSpares  some cut spares something: a cell that one cut removes may still show what it spares
CutGrid makeCutGrid(std::span<const shared::CutData> cuts, const glm::mat4& sceneFromTex, bool hasSpares);

}  // namespace velum::render
