#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/Task.h"
#include "membrane/forces/Forces.h"
#include "membrane/forces/Kernels.h"
#include "membrane/forces/LeastCut.h"
#include "scene/SceneFwd.h"

namespace velum::membrane {

/// The attraction of material on a sheet, expressed as a cost of sheets over the columns of a lattice. A column in
/// which the sheet does not lie on attracting material costs the strongest attraction anywhere; a column in which it
/// does costs that less the attraction of the material there. Each step from column to column costs by its area, and
/// each layer away from the rest plane costs a little. So a sheet goes to attracting material where that is worth the
/// area of the walls which lead there.
///
/// Differs: not in [IMC], whose attracting kernels pull at particles nearby (eq. 3 with c < 0); by the sided rule the
/// sheet is pulled back too strongly for that, and a horizon is followed as a surface: an optimal one, by a minimum
/// cut.
class Attraction {
 public:
  /// @param strengths  of the voxels of the box, [z][y][x]: strengths below 0 attract
  Attraction(const CutLattice& lattice, std::span<const float> strengths, const ProtectedVoxels& grid,
             const scene::Cut& cut);

  bool isAnywhere() const { return mMost > 0; }
  /// The costs of all sheets, as the pairs of a lattice (unit 1) with the same columns and layers.
  CutLattice costs() const;
  /// The height, in layers, at which a sheet lies on attracting material in a column; nothing where it does not.
  /// @param below  the sheet's LeastCut::below in that column
  std::optional<double> layerAt(std::size_t column, int below) const;

 private:
  int at(std::size_t column, int layer) const {
    return layer < 0 || layer >= mDims.z ? 0 : mDraw[column * std::size_t(mDims.z) + std::size_t(layer)];
  }
  void favourMiddles(std::size_t column);

  glm::ivec3 mDims;
  glm::dvec3 mStep;
  double mRestLayer;
  std::vector<std::uint16_t> mDraw;  ///< [y][x][z]: attraction, on the scale of strengths
  int mMost = 0;
};

/// The sheet of least cost by attraction among all sheets that leave everything on the same sides as the sheet `least`;
/// where several cost the same, the one nearest to the rest plane. @throw Cancelled
LeastCut drawnCut(const CutLattice& lattice, const LeastCut& least, const Attraction& attraction, Progress& progress);

/// Narrows a corridor to the heights at which its sheet lies on attracting material. @param drawn  the sheet around
/// which the corridor runs
void leadTo(Corridor& corridor, const CutLattice& lattice, const LeastCut& drawn, const Attraction& attraction);

}  // namespace velum::membrane
