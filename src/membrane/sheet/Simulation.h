#pragma once
#include <memory>
#include <optional>
#include <string>

#include "membrane/forces/Forces.h"
#include "membrane/sheet/Solver.h"

namespace velum::membrane {

class Fairing;

/// A sheet on its way to rest: first at the resolution that was asked for, which moves like cloth and is shown while
/// it does; then, by the sided rule, drawn tight with a particle for each column of the corridor, so that what the
/// least cut keeps whole the sheet keeps whole: by sweeps over heights (Fairing), a step each. GL thread of the current
/// context.
class Simulation {
 public:
  Simulation();
  ~Simulation();

  /// Hangs the sheet of a cut into forces made for it.
  /// @param start  where it starts, in the frame of `cut`; empty: flat
  void begin(const scene::Cut& cut, Forces forces, const scene::SheetShape& start);
  /// The same sheet under other forces: goes on from where it is.
  void change(const scene::Cut& cut, Forces forces);
  /// At most so many steps. Where the sheet comes to rest does not depend on how they are shared out to calls.
  /// @return false when it has come to rest: then nothing happened
  bool advance(int steps);
  bool isAtRest() const { return mPhase == Phase::Rest; }
  /// True once it has the resolution that it will rest at.
  bool isFinest() const { return mPhase != Phase::Coarse; }

  glm::ivec2 particles() const;
  /// vec4 a particle: its place, frame-local.
  const gpu::Buffer& places() const { return mFine.places.empty() ? mSolver->places() : mFinePlaces; }
  const Forces& forces() const { return mForces; }
  int steps() const { return mSteps; }
  /// Largest speed when it was last looked at (every eighth step), length/s.
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
  std::unique_ptr<Fairing> mFairing;  ///< while it is refined
  scene::SheetShape mFine;            ///< once it is
  gpu::Buffer mFinePlaces;
  scene::Cut mCut;
  Forces mForces;
  Phase mPhase = Phase::Rest;
  int mSteps = 0;
  double mSpeed = 0;
};

/// A sheet that hangs flat in the frame of a cut.
scene::SheetShape flatShape(const scene::Cut& cut, glm::ivec2 particles);
/// z over places of the rest plane, for a sheet whose particles stand in rows and columns (as they do by the sided
/// rule).
HeightOver heightOf(const scene::SheetShape& shape);
/// The same sheet in another frame, its particles where they were in the world; what left the new rest plane's box is
/// put back to its faces, and the border to its rim (active repositioning).
scene::SheetShape carryOver(const scene::SheetShape& shape, const scene::Cut& from, const scene::Cut& to);
/// The same for a shape that says in which frame it came to rest; one that does not is in the frame of `to`.
scene::SheetShape carryOver(const scene::SheetShape& shape, const scene::Cut& to);
/// Notes in a shape that it has come to rest in the frame of a cut, under the forces of a time step.
void anchor(scene::SheetShape& shape, const scene::Cut& cut, int timeStep);

}  // namespace velum::membrane
