#include "session/membrane/LiveSheet.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "gpu/Loss.h"
#include "scene/Scene.h"

namespace velum::session {

namespace {

/// Voxels of the time steps whose kernels are kept, at one to three bytes; and the most time steps.
constexpr double kVoxelsKept = 2e8, kMostMakers = 64;
/// Only where so much must be cut can the sheet cut more than its plane.
constexpr double kShareToWatch = 0.6;

/// True when two membranes differ only in their pins, or in the kernels that hands have put in.
bool isHandsOnly(scene::Membrane a, scene::Membrane b) {
  bool isChanged = a.pins != b.pins || a.field.kernels != b.field.kernels;
  for (auto* membrane : {&a, &b}) {
    membrane->pins.clear();
    membrane->field.kernels.clear();
    membrane->shape = {};
  }
  return isChanged && a == b;
}

}  // namespace

DataKey dataKeyOf(const scene::Scene& scene) {
  const auto& [volume, labels, model] = std::tie(scene.volume, scene.labels, scene.model);
  return {volume.data.id(), labels.data.id(), model.data.id(),         volume.timeStep,
          volume.channel,   model.copies,     scene::modelFrame(scene)};
}

LiveSheet::LiveSheet(std::uint64_t id, const scene::Cut& cut, DataKey data, MembraneMover::Purpose purpose)
    : mId(id), mPurpose(purpose), mCut(cut), mData(data) {
  mAsked.isLook = isForEyes() && !isActive();
  if (isActive() && !cut.membrane->shape.places.empty()) adopt(cut.membrane->shape);
}

/// Takes a saved shape as where the sheet rests.
void LiveSheet::adopt(const scene::SheetShape& saved) {
  mWritten = saved;
  mPlace = placeOf(saved, mCut);
  mBegins = false;
  mMotion.end();
  // Saved before it had come to rest: it goes on.
  bool isOfNow = saved.timeStep < 0 || saved.timeStep == mData.timeStep;
  mAsked.isDue = mAsked.keepsSides = !haveSameFrame(mPlace.cut, mCut) || !isOfNow;
  mForces.reset();
  mFigures.reset();
  ++mAsked.wish;  // what is on its way is not for this
  ++mShown.count;
}

/// The data is another one: nothing that is known of the sheet holds any more.
void LiveSheet::forget() {
  mMakers.clear();
  mPlace.shape = {};
  mForces.reset();
  mBegins = false;
  mMotion.end();
  ++mShown.count;
}

void LiveSheet::follow(const scene::Cut& cut, DataKey data) {
  scene::Cut before = std::exchange(mCut, cut);
  const scene::Membrane &was = *before.membrane, &now = *mCut.membrane;
  bool isOtherVolume = mData.volume != data.volume || mData.model != data.model;
  bool sameData = std::exchange(mData, data) == data, sameFrame = haveSameFrame(before, mCut);
  bool wasActive = was.repositioning == scene::Repositioning::Active;
  if (!sameData) ++mAsked.dataChange;
  bool isUndone = sameData && now.shape != was.shape && now.shape != mWritten;
  // An undone step brings the shape back in which the sheet rested then; another document its own.
  if (isActive() && !now.shape.places.empty() && (isUndone || isOtherVolume)) return adopt(now.shape);
  if (isOtherVolume) forget();
  if (!sameFrame) ++mShown.count;
  mAsked.byHands = isForEyes() && sameData && sameFrame && !isActive() && (mAsked.byHands || isHandsOnly(was, now));
  if (!sameData || !sameFrame || was.field != now.field) {
    // Another curve protects other material: sides are found anew.
    mAsked.keepsSides = isActive() && was.field == now.field && (mAsked.keepsSides || !mAsked.isDue);
    mAsked.isDue = true;
    mAsked.isLook = isForEyes() && !isActive();
    ++mAsked.wish;
    mFigures.reset();
    return;
  }
  bool isOther = was.cloth != now.cloth || was.pins != now.pins || (wasActive && !isActive());
  if (!isOther) return;
  mFigures.reset();
  if (mForces)
    mBegins = true;
  else
    mAsked.isDue = true;
}

// Forces.

membrane::CurrentSheet LiveSheet::current() const {
  if (!mAsked.keepsSides || mCut.membrane->field.rule != scene::KernelRule::Sided) return {};
  return seenPlace().sidesIn(mCut);
}

void LiveSheet::takeForces(std::shared_ptr<const MadeForces> made, std::uint64_t wish) {
  mForces = std::move(made);
  mBegins = true;
  mAsked.error.clear();
  if (wish != mAsked.wish) return;
  // After a hand's preview it first settles, see advance(); after a look exact forces come at once.
  mAsked.isDue = mForces->forces.isPreview && !mAsked.byHands;
  mAsked.isLook = false;
}

void LiveSheet::failForces(const std::string& error) {
  mAsked.error = error;
  mAsked.isDue = false;
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

// Motion.

bool LiveSheet::isMoving() const { return mCut.enabled && (mBegins || !mMotion.isAtRest()); }

void LiveSheet::keepPlace() {
  mPlace = mMotion.fittedPlace(isActive());
  mMotion.noteKept();
}

/// Where a sheet starts: an active one, and one that hands drag or a look shows, from where it is; else flat.
void LiveSheet::begin() {
  if (mMotion.isInSight()) keepPlace();
  bool isPreview = mForces->forces.isPreview, isLook = isPreview && !mAsked.byHands;
  bool goesOn = isActive() || mAsked.byHands || isLook;
  bool hasPast = mAsked.byHands && (!mPlace.isFlat() || isPreview);
  bool isSeen = goesOn || mPlace.isFlat();
  using State = SheetMotion::State;
  mMotion.begin(mCut, *mForces, goesOn ? mPlace : SheetPlace{},
                hasPast  ? State::Dragged
                : isSeen ? State::Shown
                         : State::Unseen);
  mBegins = false;
}

/// From flat, unseen at first: a passive sheet rests where its scene says, whatever was dragged about before.
void LiveSheet::beginAgain() {
  keepPlace();
  mAsked.byHands = false;
  mAsked.isDue = mForces->forces.isPreview;
  if (mAsked.isDue) return mMotion.hold();  // it stays as it is until exact forces are there
  mMotion.end();
  mBegins = true;
}

bool LiveSheet::advance(double budgetMs) {
  if (!isMoving()) return false;
  try {
    move(budgetMs);
  } catch (const gpu::GpuError&) {
    if (!gpu::isContextLost()) failMotion();
    throw;
  }
  return true;
}

/// What is half made goes; the sheet starts anew, from where it lay last, when it is asked to move again.
void LiveSheet::failMotion() {
  mMotion.end();
  mMotion.releaseGpu();
  mBegins = mForces != nullptr;
  mShown.sheet.reset();
  ++mShown.count;
}

void LiveSheet::move(double budgetMs) {
  if (mBegins) begin();
  mMotion.advance(budgetMs);
  afterSteps();
}

void LiveSheet::afterSteps() {
  if (mMotion.state() != SheetMotion::State::Unseen) ++mShown.count;
  if (mMotion.state() == SheetMotion::State::Dragged && !mAsked.isDue && mMotion.isFinest())
    beginAgain();  // it has settled as far as the eye can follow
  else if (mMotion.isAtRest())
    keepPlace();
}

void LiveSheet::resume() {
  if (!mMotion.isInterrupted()) return;
  mMotion.resume();
  afterSteps();
}

void LiveSheet::reset() {
  mPlace.shape = {};
  mFigures.reset();
  ++mShown.count;
  mMotion.end();
  mAsked.byHands = mAsked.keepsSides = false;
  if (mForces && !isActive())
    mBegins = true;
  else
    mAsked.isDue = true, ++mAsked.wish;
}

void LiveSheet::releaseGpu() {
  mMotion.releaseGpu();
  mShown.sheet.reset();
  mShown.uploaded = 0;
}

// Figures.

bool LiveSheet::needsFigures(bool whole) const {
  bool isAtRest =
      mCut.enabled && !mAsked.isDue && !isMoving() && mAsked.error.empty() && mShown.indexed == mShown.count;
  if (!isAtRest) return false;
  if (mFigures) return whole && !mFigures->isWhole;
  return whole || (mForces && mForces->forces.corridor.leastShare > kShareToWatch);
}

void LiveSheet::takeFigures(SheetFigures figures, std::uint64_t wish) {
  if (wish != mAsked.wish || isMoving()) return;
  bool isWorse = membrane::isWorseThanFlat(figures.kept, mCut);
  mFigures = std::move(figures);
  if (!isWorse) return;
  mFigures->kept = membrane::figureOfFlat(mFigures->kept);
  mPlace = flatPlace(mCut, mPlace.isFlat() ? mCut.membrane->cloth.particles : mPlace.shape.particles, mPlace.timeStep);
  ++mShown.count;
}

}  // namespace velum::session
