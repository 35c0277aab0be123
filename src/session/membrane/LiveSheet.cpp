#include "session/membrane/LiveSheet.h"

#include <algorithm>
#include <utility>

#include "core/Clock.h"
#include "gpu/Program.h"

namespace velum::session {

namespace {

/// A passive sheet that starts anew is shown from this step on: until then it lies nearly flat, and a drag would
/// flicker.
constexpr int kWarmSteps = 40;
/// Most steps at a time: without asking the GPU nobody knows how long it takes.
constexpr int kMostSteps = 20;
/// Voxels of the time steps whose kernels are kept, at one to three bytes; and the most time steps.
constexpr double kVoxelsKept = 2e8, kMostMakers = 64;

scene::Cut withFrameOf(scene::Cut cut, const scene::Cut& frame) {
  cut.centre = frame.centre;
  cut.axis = frame.axis;
  cut.spinDeg = frame.spinDeg;
  cut.size = frame.size;
  return cut;
}

/// Only pins, or kernels that hands have put in, are others.
bool isHandsOnly(scene::Membrane a, scene::Membrane b) {
  bool isChanged = a.pins != b.pins || a.field.kernels != b.field.kernels;
  for (auto* membrane : {&a, &b}) {
    membrane->pins.clear();
    membrane->field.kernels.clear();
    membrane->shape = {};
  }
  return isChanged && a == b;
}

scene::SheetShape carried(const scene::SheetShape& shape, const scene::Cut& from, const scene::Cut& to) {
  if (shape.places.empty() || haveSameFrame(from, to)) return shape;
  return membrane::fitShape(membrane::carryOver(shape, from, to), shape.particles, to.size);
}

}  // namespace

DataKey dataKeyOf(const scene::Scene& scene) {
  return {.volume = scene.volume.data.id(),
          .labels = scene.labels.data.id(),
          .model = scene.model.data.id(),
          .timeStep = scene.volume.timeStep,
          .channel = scene.volume.channel,
          .copies = scene.model.copies};
}

bool haveSameFrame(const scene::Cut& a, const scene::Cut& b) {
  return a.centre == b.centre && a.axis == b.axis && a.spinDeg == b.spinDeg && a.size == b.size;
}

LiveSheet::LiveSheet(std::uint64_t id, const scene::Cut& cut, DataKey data) : mId(id), mCut(cut), mData(data) {
  mWantsLook = !isActive();
  if (isActive() && !cut.membrane->shape.places.empty()) adopt(cut.membrane->shape);
}

/// Takes a shape as where the sheet rests.
void LiveSheet::adopt(const scene::SheetShape& shape) {
  mWritten = shape;
  mKept = membrane::fitShape(shape, mCut.membrane->cloth.particles, mCut.size);
  mKeptCut = mCut;
  if (glm::length(shape.axis) > 0.0) {
    mKeptCut.centre = mKept.centre = shape.centre;
    mKeptCut.axis = mKept.axis = shape.axis;
    mKeptCut.spinDeg = mKept.spinDeg = shape.spinDeg;
  }
  mBegin = false;
  mMotion = Motion::None;
  // Saved before it had come to rest: it goes on.
  bool isOfNow = shape.timeStep < 0 || shape.timeStep == mData.timeStep;
  mKept.timeStep = mKeptStep = shape.timeStep;
  mNeedsForces = mKeepSides = !haveSameFrame(mKeptCut, mCut) || !isOfNow;
  mForces.reset();
  mFigures.reset();
  ++mWish;  // what is on its way is not for this
  ++mShown;
}

void LiveSheet::follow(const scene::Cut& cut, DataKey data) {
  scene::Cut before = std::exchange(mCut, cut);
  const scene::Membrane &was = *before.membrane, &now = *mCut.membrane;
  bool isOtherVolume = mData.volume != data.volume || mData.model != data.model;
  bool sameData = std::exchange(mData, data) == data, sameFrame = haveSameFrame(before, mCut);
  bool wasActive = was.repositioning == scene::Repositioning::Active;
  if (!sameData) ++mDataChange;
  bool isUndone = sameData && now.shape != was.shape && now.shape != mWritten;
  // An undone step brings the shape back in which the sheet rested then; another document its own.
  if (isActive() && !now.shape.places.empty() && (isUndone || isOtherVolume)) return adopt(now.shape);
  if (isOtherVolume) {
    mMakers.clear();
    mKept = {};
    mForces.reset();
    mBegin = false;
    mMotion = Motion::None;
    ++mShown;
  }
  if (!sameFrame) ++mShown;
  mGoesOn = sameData && sameFrame && !isActive() && (mGoesOn || isHandsOnly(was, now));
  if (!sameData || !sameFrame || was.field != now.field) {
    // Another curve protects other material: sides are found anew.
    mKeepSides = isActive() && was.field == now.field && (mKeepSides || !mNeedsForces);
    mNeedsForces = true;
    mWantsLook = !isActive();
    ++mWish;
    mFigures.reset();
    return;
  }
  bool isOther = was.cloth != now.cloth || was.pins != now.pins || (wasActive && !isActive());
  if (!isOther) return;
  mFigures.reset();
  if (mForces)
    mBegin = true;
  else
    mNeedsForces = true;
}

membrane::CurrentSheet LiveSheet::current() const {
  if (!mKeepSides || mCut.membrane->field.rule != scene::KernelRule::Sided) return {};
  scene::SheetShape now = shape();
  if (now.places.empty()) return {};
  return {membrane::heightOf(now), movesInSight() ? mMovingStep : mKeptStep};
}

void LiveSheet::takeForces(std::shared_ptr<const MadeForces> made, std::uint64_t wish) {
  mForces = std::move(made);
  mBegin = true;
  mError.clear();
  if (wish != mWish) return;
  // After a hand's preview it first settles, see advance(); after a look exact forces come at once.
  mNeedsForces = mForces->forces.isPreview && !mGoesOn;
  mWantsLook = false;
}

std::shared_ptr<membrane::ForceMaker> LiveSheet::makerOf(const scene::Scene& scene) const {
  auto found = std::find_if(mMakers.begin(), mMakers.end(), [&](const auto& maker) { return maker->matches(scene); });
  return found == mMakers.end() ? nullptr : *found;
}

void LiveSheet::keepMaker(std::shared_ptr<membrane::ForceMaker> maker) {
  glm::dvec3 n(maker->potential().dims());
  auto most = std::size_t(std::clamp(kVoxelsKept / std::max(n.x * n.y * n.z, 1.0), 1.0, kMostMakers));
  std::erase(mMakers, maker);
  mMakers.insert(mMakers.begin(), std::move(maker));
  if (mMakers.size() > most) mMakers.resize(most);
}

void LiveSheet::failForces(const std::string& error) {
  mError = error;
  mNeedsForces = false;
}

bool LiveSheet::isMoving() const { return mCut.enabled && (mBegin || !isAtRest()); }

/// Where the sheet was when it was last looked at. Asks the GPU where it moves, once for each place: what is held can
/// be exported from a menu, where the context is not current.
scene::SheetShape LiveSheet::known() const {
  if (!movesInSight()) return mKept;
  if (std::exchange(mReadAt, mShown) != mShown) mRead = mSimulation->shape();
  return mRead;
}

scene::SheetShape LiveSheet::shape() const { return carried(known(), movesInSight() ? mMovingCut : mKeptCut, mCut); }

void LiveSheet::keepShape() {
  // As drawing would fit it, so that a shape that has been written down is the one that was drawn.
  mKept = membrane::fitShape(mSimulation->shape(), mMovingCut.membrane->cloth.particles, mMovingCut.size);
  mKeptStep = mMovingStep;
  if (isActive()) membrane::anchor(mKept, mMovingCut, mMovingStep);
  mKeptCut = mMovingCut;
}

void LiveSheet::begin() {
  mBegin = false;
  if (movesInSight()) keepShape();
  scene::Cut moving = withFrameOf(mCut, mForces->cut);
  moving.membrane->field.rule = mForces->cut.membrane->field.rule;
  scene::SheetShape start;
  bool isLook = mForces->forces.isPreview && !mGoesOn;
  if (isActive() || mGoesOn || isLook) start = carried(mKept, mKeptCut, moving);
  mSimulation->begin(moving, mForces->forces, start);
  mMovingCut = moving;
  mMovingStep = mForces->timeStep;
  bool hasPast = mGoesOn && (!start.places.empty() || mForces->forces.isPreview);
  bool isSeen = isActive() || mGoesOn || isLook || mKept.places.empty();
  mMotion = hasPast ? Motion::Dragged : isSeen ? Motion::Shown : Motion::Unseen;
}

/// From flat, unseen at first: a passive sheet rests where its scene says, whatever was dragged about before.
void LiveSheet::beginAgain() {
  keepShape();
  mGoesOn = false;
  mMotion = Motion::Shown;
  mNeedsForces = mForces->forces.isPreview;
  if (mNeedsForces) return;  // it stays as it is until exact ones are there
  mMotion = Motion::None;
  mBegin = true;
}

bool LiveSheet::advance(double budgetMs) {
  if (!isMoving()) return false;
  if (mBegin) begin();
  auto start = Clock::now();
  int steps = 0;
  do mSimulation->advance(1);
  while (++steps < kMostSteps && !mSimulation->isAtRest() && msSince(start) < budgetMs);
  gpu::finish();
  double stepMs = msSince(start) / steps;
  mStepMs = mStepMs > 0 ? 0.8 * mStepMs + 0.2 * stepMs : stepMs;
  if (mMotion == Motion::Unseen && (mSimulation->steps() >= kWarmSteps || mSimulation->isAtRest()))
    mMotion = Motion::Shown;
  if (mMotion != Motion::Unseen) ++mShown;
  if (mMotion == Motion::Dragged && !mNeedsForces && mSimulation->isFinest())
    beginAgain();  // it has settled as far as the eye can follow
  else if (mSimulation->isAtRest())
    keepShape();
  return true;
}

void LiveSheet::reset() {
  mKept = {};
  mFigures.reset();
  ++mShown;
  mMotion = Motion::None;
  mGoesOn = mKeepSides = false;
  if (mForces && !isActive())
    mBegin = true;
  else
    mNeedsForces = true, ++mWish;
}

bool LiveSheet::needsFigures() const {
  return mCut.enabled && !mNeedsForces && !isMoving() && !mFigures && mError.empty() && mIndexed == mShown;
}

void LiveSheet::takeFigures(const membrane::KeptWhole& figures, std::vector<Advice> advice,
                            const membrane::LeftOut& leftOut, std::uint64_t wish) {
  if (wish != mWish || isMoving()) return;
  mFigures = figures;
  mAdvice = std::move(advice);
  mLeftOut = leftOut;
  if (!membrane::isWorseThanFlat(figures, mCut)) return;
  mFigures = membrane::figureOfFlat(figures);
  glm::ivec2 particles = mKept.places.empty() ? mCut.membrane->cloth.particles : mKept.particles;
  mKept = membrane::flatShape(mCut, particles);
  if (isActive()) membrane::anchor(mKept, mCut, mKeptStep);
  mKeptCut = mCut;
  ++mShown;
}

MembraneStatus LiveSheet::status(bool isPlaying, bool isComputing) const {
  using Phase = MembraneStatus::Phase;
  MembraneStatus status;
  if (mNeedsForces || isComputing)
    status.phase = Phase::Computing;
  else if (isMoving())
    status.phase = isPlaying ? Phase::Settling : Phase::Paused;
  if (mForces) {
    status.kernels = mForces->forces.kernels;
    status.forcesMs = mForces->forces.kernelsMs + mForces->forces.leastCutMs;
  }
  status.particles = mCut.membrane->cloth.particles;
  if (!mKept.places.empty()) status.particles = mKept.particles;
  if (mMotion != Motion::None) {
    status.particles = mSimulation->particles();
    status.steps = mSimulation->steps();
    status.speed = mSimulation->speed();
  }
  status.stepMs = mStepMs;
  status.error = mError;
  if (!mFigures) return status;
  status.isMeasured = true;
  status.keptWhole = mFigures->ratio;
  status.fate = mFigures->fate;
  status.wantsAdvice = session::wantsAdvice(*mFigures, mCut);
  status.advice = mAdvice;
  status.leftOut = mLeftOut;
  status.shares = membrane::sharesOf(*mFigures, mCut);
  status.planePairs = mFigures->cutAreaPlane;
  status.sheetPairs = mFigures->cutAreaMembrane;
  status.meanDistance = mFigures->meanDistance;
  return status;
}

render::FrameSheet LiveSheet::frameSheet() {
  bool isLive = movesInSight() && haveSameFrame(mMovingCut, mCut);
  if (mUploaded != mShown || !mSheet) {
    glm::ivec2 flat = glm::max(mCut.membrane->cloth.particles, glm::ivec2(3));
    glm::ivec2 count = isLive ? mSimulation->particles() : glm::ivec2(0);
    bool fits = mSheet && mSheet->particles() == count && mSheet->size() == mCut.size;
    if (isLive && fits) {
      // From the solver to the picture without a detour.
      mSimulation->places().copyTo(mSheet->rows(), 0);
      gpu::barrier();
      mSheet->index();
    } else if (mSheet) {
      mSheet->setShape(shape(), flat, mCut.size);
    } else {
      mSheet = std::make_shared<membrane::Sheet>(shape(), flat, mCut.size);
    }
    if (isAtRest()) mSheet->grow();
    mUploaded = mShown;
  }
  return {mSheet, mSheet->revision()};
}

void LiveSheet::makeIndex() {
  glm::ivec2 flat = glm::max(mCut.membrane->cloth.particles, glm::ivec2(3));
  mIndex = std::make_shared<const membrane::SheetIndex>(membrane::makeSheetIndex(shape(), flat, mCut.size));
  mIndexed = mShown;
}

bool LiveSheet::hasRest() const {
  if (!isActive() || !mCut.enabled || mNeedsForces || isMoving() || mKept.places.empty()) return false;
  return haveSameFrame(mKeptCut, mCut) && mKept != mWritten;
}

std::optional<scene::SheetShape> LiveSheet::takeRest() {
  if (!hasRest()) return std::nullopt;
  mWritten = mKept;
  return mWritten;
}

void LiveSheet::releaseGpu() {
  bool wasMoving = isMoving();
  if (movesInSight()) keepShape();
  mSimulation.emplace();
  mMotion = Motion::None;
  mBegin = wasMoving && mForces;
  mSheet.reset();
  mUploaded = 0;
}

}  // namespace velum::session
