#pragma once
#include <cstdint>
#include <optional>

#include "membrane/forces/Forces.h"
#include "membrane/sheet/Simulation.h"
#include "session/membrane/SheetPlace.h"

namespace velum::session {

/// Forces, the cut for whose frame they were made, and the time step of the data from which they were made.
struct MadeForces {
  membrane::Forces forces;
  scene::Cut cut;
  int timeStep = 0;
  double ms = 0.0;  ///< time that it took to make them
};

/// The motion of one sheet: its simulation, the frame in which the simulation runs, and whether the sheet is seen where
/// the simulation is. GL thread.
class SheetMotion {
 public:
  enum class State {
    None,     ///< There is no motion.
    Unseen,   ///< The motion has begun from flat, and the sheet lies too nearly flat yet to be shown.
    Shown,    ///< The simulation is what is shown.
    Dragged,  ///< As Shown, but where the sheet rests depends on how it came there: a passive sheet will start from
              ///< flat once more.
  };

  /// @param cut    the membrane as it is wanted; the frame is that of the forces
  /// @param start  where the sheet starts, in the world; a flat place: the sheet starts flat
  void begin(const scene::Cut& cut, const MadeForces& made, const SheetPlace& start, State as);
  /// Steps for about so many milliseconds, at least one step. Waits for the GPU. @throw gpu::ContextLost
  void advance(double budgetMs);
  /// Ends the motion: the simulation is no longer what is shown, wherever it is.
  void end() {
    mState = State::None;
    mInterrupted.reset();
  }
  /// The simulation is what is shown, and stays where it is.
  void hold() { mState = State::Shown; }
  /// Says that whoever asked for place() has kept where the simulation is now.
  void noteKept() { mIsKept = true; }
  /// Gives up what is on the GPU, which may be lost already. Unless it has come to rest, and where was kept, the
  /// simulation is where it was after resume().
  void releaseGpu();
  /// Makes a motion that releaseGpu() has interrupted anew: from its start as many steps.
  void resume();
  bool isInterrupted() const { return mInterrupted.has_value(); }

  State state() const { return mState; }
  bool isAtRest() const { return mState == State::None || (!isInterrupted() && mSimulation->isAtRest()); }
  /// The sheet moves, and is shown where the simulation is.
  bool isInSight() const { return mState != State::Unseen && !isAtRest(); }
  /// True when the sheet has the resolution at which it will rest.
  bool isFinest() const { return mSimulation->isFinest(); }
  const scene::Cut& cut() const { return mCut; }
  const membrane::Simulation& simulation() const { return *mSimulation; }

  /// Where the simulation is. Waits for the GPU. @throw gpu::ContextLost
  SheetPlace place() const;
  /// Where the simulation is, fitted as drawing would fit it, so that a shape that is written down is the one that was
  /// drawn.
  /// @param isAnchored  the shape says in which frame it lies, and under the forces of which time step
  SheetPlace fittedPlace(bool isAnchored) const;

  double stepMs() const { return mStepMs; }  ///< time of a step, a mean of the last ones
  double ms() const { return mMs; }          ///< time of all steps since begin()

 private:
  /// What resume() makes a motion of.
  struct Interrupted {
    membrane::Forces forces;
    int steps = 0;
  };
  void see();
  std::optional<membrane::Simulation> mSimulation{std::in_place};
  scene::SheetShape mStart;  ///< in the frame of mCut
  bool mIsKept = false;
  std::optional<Interrupted> mInterrupted;
  State mState = State::None;
  scene::Cut mCut;
  int mTimeStep = 0;
  double mStepMs = 0.0, mMs = 0.0;
};

}  // namespace velum::session
