// What a sheet tells of itself.
#include "session/membrane/LiveSheet.h"

namespace velum::session {

MembraneStatus LiveSheet::status(bool isPlaying, bool isComputing) const {
  using Phase = MembraneStatus::Phase;
  MembraneStatus status;
  if (mAsked.isDue || isComputing)
    status.phase = Phase::Computing;
  else if (isMoving())
    status.phase = isPlaying ? Phase::Settling : Phase::Paused;
  if (mForces) {
    status.kernels = mForces->forces.kernels;
    status.voxels = mForces->forces.voxels;
    status.forcesMs = mForces->forces.kernelsMs + mForces->forces.leastCutMs;
  }
  status.particles = mPlace.isFlat() ? mCut.membrane->cloth.particles : mPlace.shape.particles;
  if (mMotion.state() != SheetMotion::State::None && !mMotion.isInterrupted()) {
    const membrane::Simulation& simulation = mMotion.simulation();
    status.particles = simulation.particles();
    status.steps = simulation.steps();
    status.speed = simulation.speed();
  }
  status.stepMs = mMotion.stepMs();
  status.error = mAsked.error;
  if (!mFigures) return status;
  const membrane::KeptWhole& kept = mFigures->kept;
  status.isMeasured = true, status.keptWhole = kept.ratio;
  status.voxels = mFigures->voxels;
  status.fate = kept.fate;
  status.wantsAdvice = session::wantsAdvice(kept, mCut);
  status.advice = mFigures->advice;
  status.leftOut = mFigures->leftOut;
  status.shares = membrane::sharesOf(kept, mCut);
  status.planePairs = kept.cutAreaPlane, status.sheetPairs = kept.cutAreaMembrane;
  status.meanDistance = kept.meanDistance;
  return status;
}

MembraneReport LiveSheet::report() const {
  MembraneReport report{.cut = mCut.id, .name = mCut.name, .particles = shape().particles, .atRest = !isMoving()};
  if (mForces) {
    report.kernels = mForces->forces.kernels;
    report.voxels = mForces->forces.voxels;
    report.kernelsMs = mForces->forces.kernelsMs;
    report.leastCutMs = mForces->forces.leastCutMs;
    report.totalMs = mForces->ms + mMotion.ms();
  }
  if (mMotion.state() != SheetMotion::State::None) report.steps = mMotion.simulation().steps();
  if (report.steps > 0) report.stepMs = mMotion.ms() / report.steps;
  if (!mFigures || !mFigures->isWhole) return report;
  report.kept = mFigures->kept, report.voxels = mFigures->voxels;
  report.advice = mFigures->advice, report.leftOut = mFigures->leftOut;
  return report;
}

}  // namespace velum::session
