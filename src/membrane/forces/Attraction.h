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

/// What draws a sheet to it, over the columns of a lattice, as a cost of sheets: each column in which a sheet lies off
/// what attracts costs the strongest attraction that there is, in which it lies on it that less its own; each step from
/// column to column costs by its area, as does each layer from the rest plane a little. So a sheet goes to what
/// attracts where that is worth its walls.
///
/// Differs: not in [IMC], whose attracting kernels pull at particles nearby (eq. 3 with c < 0); by the sided rule the
/// sheet is pulled back too strongly for that, and a horizon is followed as a surface: an optimal one, by a minimum
/// cut.
class Attraction {
 public:
  /// @param strengths  of the voxels of the box, [z][y][x]: those below 0 attract
  Attraction(const CutLattice& lattice, std::span<const float> strengths, const ProtectedVoxels& grid,
             const scene::Cut& cut);

  bool isAnywhere() const { return mMost > 0; }
  /// The costs of all sheets, as those of a lattice (unit 1) of the same columns and layers.
  CutLattice costs() const;
  /// The height in layers at which a sheet lies on what attracts; nothing where it does not.
  /// @param below  as LeastCut::below of the column
  std::optional<double> layerAt(std::size_t column, int below) const;

 private:
  int at(std::size_t column, int layer) const {
    return layer < 0 || layer >= mDims.z ? 0 : mDraw[column * std::size_t(mDims.z) + std::size_t(layer)];
  }
  void favourMiddles(std::size_t column);

  glm::ivec3 mDims;
  glm::dvec3 mStep;
  double mRestLayer;
  std::vector<std::uint16_t> mDraw;  ///< [y][x][z]: attraction, as strengths are
  int mMost = 0;
};

/// The sheet of least cost by attraction among those that leave on their sides what another one does, which is nearest
/// to the rest plane where several cost the same. @throw Cancelled
LeastCut drawnCut(const CutLattice& lattice, const LeastCut& least, const Attraction& attraction, Progress& progress);

/// Leads a corridor to where its sheet lies on what attracts. @param drawn  the sheet that the corridor is around
void leadTo(Corridor& corridor, const CutLattice& lattice, const LeastCut& drawn, const Attraction& attraction);

}  // namespace velum::membrane
