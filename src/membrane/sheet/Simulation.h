#pragma once
#include <memory>
#include <optional>
#include <string>

#include "membrane/forces/Forces.h"
#include "membrane/sheet/Solver.h"

namespace velum::membrane {

class Fairing;

/// A sheet on its way to rest. First it moves like cloth at the resolution that was asked for, and is shown meanwhile.
/// Then, by the sided rule, it is pulled tight with a particle for each column of the corridor, so that the sheet keeps
/// whole whatever the least cut keeps whole; this is done by sweeps over heights (Fairing), one a step. GL thread of
/// the current context.
class Simulation {
 public:
  Simulation();
  ~Simulation();

  /// Hangs the sheet of a cut into forces made for it.
  /// @param start  shape from which it starts, in the frame of `cut`; empty: flat
  void begin(const scene::Cut& cut, Forces forces, const scene::SheetShape& start);
  /// Puts the same sheet under other forces: it goes on from its present shape.
  void change(const scene::Cut& cut, Forces forces);
  /// Does at most so many steps. The shape at rest does not depend on how the steps are divided among calls.
  /// @return false when the sheet was at rest already: then nothing was done
  bool advance(int steps);
  bool isAtRest() const { return mPhase == Phase::Rest; }
  /// True once the sheet has the resolution at which it will rest.
  bool isFinest() const { return mPhase != Phase::Coarse; }

  glm::ivec2 particles() const;
  /// The particles' places on the GPU: a vec4 each, frame-local.
  const gpu::Buffer& places() const { return mFine.places.empty() ? mSolver->places() : mFinePlaces; }
  const Forces& forces() const { return mForces; }
  int steps() const { return mSteps; }
  /// Largest speed of a particle, length/s, as measured every eighth step.
  double speed() const { return mSpeed; }
  /// Where the particles are. Waits for the GPU.
  scene::SheetShape shape() const;

 private:
  enum class Phase { Coarse, Fine, Rest };
  void hang(glm::ivec2 particles, const scene::SheetShape& start);
  void look();
  void refine();
  void finish();
  void applyForces();
  bool isRaised() const;

  std::optional<Solver> mSolver;
  std::unique_ptr<Fairing> mFairing;  ///< while the sheet is refined
  scene::SheetShape mFine;            ///< the refined sheet, once it is ready
  gpu::Buffer mFinePlaces;
  scene::Cut mCut;
  Forces mForces;
  Phase mPhase = Phase::Rest;
  int mSteps = 0;
  double mSpeed = 0;
};

/// A sheet that hangs flat in the frame of a cut.
scene::SheetShape flatShape(const scene::Cut& cut, glm::ivec2 particles);
/// The heights of a shape over places of the rest plane, for a sheet whose particles stand in rows and columns (as they
/// do by the sided rule).
HeightOver heightOf(const scene::SheetShape& shape);
/// A shape of the frame of `from` as a shape of the frame of `to`, with its particles in the same places of the world.
/// Particles outside the new rest plane's box are put back onto its faces, and the border onto its rim (active
/// repositioning).
scene::SheetShape carryOver(const scene::SheetShape& shape, const scene::Cut& from, const scene::Cut& to);
/// The same for a shape that holds the frame in which it came to rest; a shape that holds none is taken to be in the
/// frame of `to`.
scene::SheetShape carryOver(const scene::SheetShape& shape, const scene::Cut& to);
/// Stores in a shape the frame (that of a cut) and the time step in which it has come to rest.
void anchor(scene::SheetShape& shape, const scene::Cut& cut, int timeStep);

}  // namespace velum::membrane
