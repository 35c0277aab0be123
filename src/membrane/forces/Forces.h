#pragma once
#include <cstddef>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
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
  bool isBelow = false;  ///< the place must lie below the sheet, not above
};

/// The room in which the sheet cuts no more than it must, column by column over the rest plane: between the protected
/// material that belongs below the sheet and that which belongs above. Frame-local.
struct Corridor {
  glm::ivec2 dims{0};      ///< columns; {0, 0}: the sheet may hang anywhere
  glm::dvec2 origin{0.0};  ///< middle of column (0, 0)
  glm::dvec2 step{1.0};
  std::vector<glm::vec2> room;  ///< [y][x]: lowest, highest z
  std::vector<float> height;    ///< [y][x]: z of the least cut itself
  std::vector<Stake> stakes;    ///< between the middles of columns
  bool isDrawn = false;  ///< `height` is where attracting material draws the sheet, not only where the sheet may pass
  double leastShare = 0.0;  ///< pairs that the least cut separates, divided by the pairs that the rest plane separates
};

/// Which voxels forces, and figures of a sheet, come from.
struct ForceVoxels {
  int level = 0;        ///< of a streamed volume: which of its levels they are of
  double volume = 0.0;  ///< of one of them, world
};
ForceVoxels voxelsOf(const Potential& potential);

/// Everything that acts on the sheet of one membrane in one place.
struct Forces {
  PushField field;
  Corridor corridor;
  bool isPreview = false;   ///< made by ForceMaker::preview()
  ForceVoxels voxels;       ///< that they come from
  std::size_t kernels = 0;  ///< of the whole volume
  double kernelsMs = 0;     ///< time to make the kernels from the data; 0: they were kept from before
  double leastCutMs = 0;    ///< time to make the corridor; 0: it was kept from before
};

/// Gives the height z of a sheet over a place (x, y) of its rest plane, frame-local.
using HeightOver = std::function<double(glm::dvec2 local)>;

/// The present sheet (active repositioning), given in the frame for which forces are wanted.
struct CurrentSheet {
  HeightOver height;  ///< empty: there is none
  int timeStep = -1;  ///< time step at which the sheet came to rest; -1: the one for which forces are wanted
};

/// Makes forces from a scene's data; keeps intermediate results between edits and between places of the rest plane. One
/// thread at a time.
class ForceMaker {
 public:
  explicit ForceMaker(const scene::Scene& scene);
  ~ForceMaker();

  /// Of the data in memory: of a streamed volume its coarse level.
  const Potential& potential() const { return mPotential; }
  /// Of the voxels from which exact forces of a membrane come: of a streamed volume those of a finer level in the
  /// sheet's reach (finerBoxOf()), which are read first. Stays until the next call that makes something.
  /// @throw InputError when bricks cannot be read; Cancelled
  const Potential& potentialFor(const scene::Cut& cut, Progress& progress);
  bool matches(const scene::Scene& scene) const { return mPotential.matches(scene); }

  /// By the paper's rule: kernels that push away from their centres ([IMC] eq. 2, 3). By the sided rule (Differs: not
  /// in the paper): the least cut over the rest plane says which protected material belongs below the sheet and which
  /// above; kernels push the sheet along the normal away from that side, and the corridor is the room between the two.
  /// Where some material has to be cut, weaker material is cut rather than stronger. Within the corridor the sheet is
  /// drawn to attracting material (see Attraction).
  /// @param current  active repositioning: material stays on the side of this sheet on which it is. If the sheet came
  /// to rest at another time step, the material has moved since: then the least cut among the sheets near this one is
  /// used. Differs: the paper knows no time
  /// Of a streamed volume they come from a finer level, see potentialFor().
  /// @throw InputError when bricks cannot be read; Cancelled
  Forces compute(const scene::Cut& cut, const CurrentSheet& current, Progress& progress);

  /// Forces for a hand that drags, until the exact ones are ready. As compute() without a current sheet, except that a
  /// streamed volume is looked at in the level that is in memory,
  /// large data (kLargeVoxels) are looked at coarsely, and each repelling kernel put in by hand is passed on the side
  /// given by the least cut of the data alone, without another least cut. Takes a few milliseconds where that least
  /// cut, or the coarse look, is kept from before. @throw Cancelled
  Forces preview(const scene::Cut& cut, Progress& progress);
  /// With more voxels than this forces take long enough to be worth a preview.
  static constexpr double kLargeVoxels = 4e6;
  bool isLarge() const;

 private:
  ForceMaker(Potential potential, int timeStep, int timeSteps);
  ForceMaker* finerFor(const scene::Cut& cut, Progress& progress);
  Forces computeHere(const scene::Cut& cut, const CurrentSheet& current, Progress& progress);
  Forces previewHere(const scene::Cut& cut, Progress& progress);
  // Functions that take `ms` write to it how long they took, unless the result was kept from before.
  /// A corridor, and the parts of the cut that it was made for: see sidesPart().
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
  bool mIsFiner = false;                    ///< a box of a streamed volume
  std::optional<scene::ForceField> mField;  ///< the field that mKernels were made from
  std::vector<KernelGrid> mKernels;         ///< from the field's level to that of previews
  std::optional<scene::Cut> mVoxelsCut;
  ProtectedVoxels mVoxels;  ///< of the data alone
  std::optional<scene::ForceField> mCoarseField;
  CoarseVoxels mCoarse;  ///< of the data alone, for previews
  struct Finer;
  std::unique_ptr<Finer> mFiner;  ///< of the last membrane over a streamed volume
  Sides mDataSides, mSides;       ///< mDataSides: of the data alone; mSides: with the kernels put in by hand last
};

/// The heights of the sheet around which a corridor runs: Corridor::height.
HeightOver heightOf(const Corridor& corridor);

/// The room (lowest and highest z) of each particle of a sheet: heights within the room of all columns that are nearer
/// to this particle than to others. Where no height suits all of these, the room of its nearest column. Empty without a
/// corridor.
/// @param places  the particles of a sheet, frame-local
/// @param pitch  distance from particle to particle
std::vector<glm::vec2> roomOf(const Corridor& corridor, std::span<const glm::vec3> places, glm::dvec2 pitch);

}  // namespace velum::membrane
