#pragma once
#include <cstddef>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/Task.h"
#include "membrane/forces/CoarseVoxels.h"
#include "membrane/forces/Kernels.h"
#include "membrane/forces/LeastCut.h"
#include "membrane/forces/PushField.h"
#include "scene/Cut.h"
#include "scene/Membrane.h"
#include "scene/SceneFwd.h"

namespace velum::membrane {

/// A place that the sheet must pass on one side. Frame-local.
struct Stake {
  glm::vec3 place{0.0f};
  bool isBelow = false;  ///< it belongs below the sheet
};

/// Where the sheet may hang so that it cuts nothing more than it must, column by column over the rest plane: between
/// what belongs below it and what belongs above it. Frame-local.
struct Corridor {
  glm::ivec2 dims{0};      ///< columns; {0, 0}: the sheet may hang anywhere
  glm::dvec2 origin{0.0};  ///< middle of column (0, 0)
  glm::dvec2 step{1.0};
  std::vector<glm::vec2> room;  ///< [y][x]: lowest, highest z
  std::vector<float> height;    ///< [y][x]: z of the least cut itself
  std::vector<Stake> stakes;    ///< between the middles of columns
  bool isDrawn = false;         ///< `height` is where the sheet is drawn to, not only where it may pass
  double leastShare = 0.0;      ///< pairs that its sheet cuts, by those that the rest plane does
};

/// Everything that acts on the sheet of one membrane in one place.
struct Forces {
  PushField field;
  Corridor corridor;
  bool isPreview = false;   ///< of ForceMaker::preview()
  std::size_t kernels = 0;  ///< of the whole volume
  double kernelsMs = 0;     ///< time from the data to the kernels; 0: they were there
  double leastCutMs = 0;    ///< time to the corridor; 0: it was there
};

/// z of a sheet over a place of its rest plane.
using HeightOver = std::function<double(glm::dvec2 local)>;

/// A sheet that is there already (active repositioning), in the frame that is wanted.
struct CurrentSheet {
  HeightOver height;  ///< empty: there is none
  int timeStep = -1;  ///< of the volume, in which it came to rest; -1: the one that is wanted
};

/// Makes forces from a scene's data; keeps what can be kept between edits and between places of the rest plane. One
/// thread at a time.
class ForceMaker {
 public:
  explicit ForceMaker(const scene::Scene& scene);

  const Potential& potential() const { return mPotential; }
  bool matches(const scene::Scene& scene) const { return mPotential.matches(scene); }

  /// By the paper's rule: kernels that push away from their centres ([IMC] eq. 2, 3). By the sided rule (Differs: not
  /// in the paper): the least cut over the rest plane says which protected material belongs below the sheet and which
  /// above; kernels push along the normal to the other side, and the corridor is what lies between. Where something has
  /// to be cut it is what is weaker. Within the corridor the sheet is drawn to what attracts (see Attraction).
  /// @param current  active repositioning: material stays on the side of this sheet instead. Has it come to rest in
  /// another time step, the material has moved since: then it is the least cut of those near the sheet. Differs: the
  /// paper knows no time
  /// @throw Cancelled
  Forces compute(const scene::Cut& cut, const CurrentSheet& current, Progress& progress);

  /// For a hand that drags, before exact forces are there: as compute() without a current sheet, but in large data
  /// (kLargeVoxels) by a coarse look at what is protected, and each kernel that repels is passed on the side of the
  /// data's own least cut rather than by another one. A few milliseconds where that, or the look, is known. @throw
  /// Cancelled
  Forces preview(const scene::Cut& cut, Progress& progress);
  /// In data of more voxels forces take long enough to be worth a preview.
  static constexpr double kLargeVoxels = 4e6;
  bool isLarge() const;

 private:
  // What takes `ms` writes to it how long it took, where it was not there.
  /// A corridor, and what it is of: see sidesPart().
  struct Sides {
    std::optional<scene::Cut> cut;
    Corridor corridor;
  };
  const std::vector<KernelGrid>& kernelsOf(const scene::ForceField& field, double& ms, Progress& progress);
  LeastCut cutByCurrent(const CutLattice& lattice, const scene::Cut& cut, const CurrentSheet& current,
                        Progress& progress) const;

  Corridor coarseCorridorOf(const scene::Cut& cut, double& ms, Progress& progress);
  const ProtectedVoxels& voxelsOf(const scene::Cut& cut, Progress& progress);
  Forces kernelForces(const scene::Cut& cut, bool isPreview, Progress& progress);
  Corridor corridorOf(const scene::Cut& cut, const CurrentSheet& current, double& ms, Progress& progress);

  Potential mPotential;
  int mTimeStep = 0, mTimeSteps = 1;
  std::optional<scene::ForceField> mField;  ///< that mKernels are of
  std::vector<KernelGrid> mKernels;         ///< from the field's level to that of previews
  std::optional<scene::Cut> mVoxelsCut;
  ProtectedVoxels mVoxels;  ///< of the data alone
  std::optional<scene::ForceField> mCoarseField;
  CoarseVoxels mCoarse;      ///< of the data alone, for previews
  Sides mDataSides, mSides;  ///< of the data alone; with the last kernels that were put in
};

/// The heights of a corridor's own sheet.
HeightOver heightOf(const Corridor& corridor);

/// Room for each particle of a sheet: of the columns that are nearer to it than to others. Where no height suits them
/// all, that of its nearest column. Empty without a corridor.
/// @param places  the particles of a sheet, frame-local
/// @param pitch  between particles
std::vector<glm::vec2> roomOf(const Corridor& corridor, std::span<const glm::vec3> places, glm::dvec2 pitch);

}  // namespace velum::membrane
