#pragma once
#include <cstdint>
#include <optional>

#include "membrane/forces/Forces.h"
#include "membrane/sheet/Simulation.h"
#include "session/membrane/SheetPlace.h"

namespace velum::session {

/// Forces, the cut for whose frame they were made, and the time step whose data they are of.
struct MadeForces {
  membrane::Forces forces;
  scene::Cut cut;
  int timeStep = 0;
  double ms = 0.0;  ///< that making them took
};

/// The motion of one sheet: its simulation, in whose frame the simulation runs, and whether the sheet is seen where the
/// simulation is. GL thread.
class SheetMotion {
 public:
  enum class State {
    None,     ///< There is none.
    Unseen,   ///< It has begun from flat, and lies too nearly flat yet to be shown.
    Shown,    ///< It is what is shown.
    Dragged,  ///< So, and where it rests depends on how it came there: a passive sheet will start from flat once more.
  };

  /// @param cut    the membrane as it is wanted; the frame is that of the forces
  /// @param start  where the sheet starts, in the world; flat: it starts flat
  void begin(const scene::Cut& cut, const MadeForces& made, const SheetPlace& start, State as);
  /// Steps for about so long, one at least.
  void advance(double budgetMs);
  /// It is no longer what is shown, wherever it is.
  void end() { mState = State::None; }
  /// It is what is shown, and stays where it is.
  void hold() { mState = State::Shown; }
  void releaseGpu();

  State state() const { return mState; }
  bool isAtRest() const { return mState == State::None || mSimulation->isAtRest(); }
  /// The sheet moves, and is shown where the simulation is.
  bool isInSight() const { return mState != State::Unseen && !isAtRest(); }
  /// It has the resolution that it will rest at.
  bool isFinest() const { return mSimulation->isFinest(); }
  const scene::Cut& cut() const { return mCut; }
  const membrane::Simulation& simulation() const { return *mSimulation; }

  /// Where the simulation is. Waits for the GPU.
  SheetPlace place() const { return {mSimulation->shape(), mCut, mTimeStep}; }
  /// As drawing would fit it, so that a shape that has been written down is the one that was drawn.
  /// @param isAnchored  the shape says in which frame, and under the forces of which time step, it lies
  SheetPlace fittedPlace(bool isAnchored) const;

  double stepMs() const { return mStepMs; }  ///< that a step takes, lately
  double ms() const { return mMs; }          ///< that all steps took since it began

 private:
  std::optional<membrane::Simulation> mSimulation{std::in_place};
  State mState = State::None;
  scene::Cut mCut;
  int mTimeStep = 0;
  double mStepMs = 0.0, mMs = 0.0;
};

}  // namespace velum::session
