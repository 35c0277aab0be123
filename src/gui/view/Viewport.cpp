#include "gui/view/Viewport.h"

#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/Memory.h"
#include "gpu/Loss.h"
#include "gui/view/CoarseScale.h"
#include "gui/view/PreparingVeil.h"
#include "scene/Crowd.h"
#include "scene/Navigate.h"
#include "scene/Project.h"
#include "scene/VisibleFrame.h"

namespace velum::gui {

namespace {

constexpr double kWorkMs = 8.0;         // a sixth of the 50 ms in which every view answers
constexpr double kCoarseWorkMs = 28.0;  // a coarse picture in one piece: what waits is that picture
constexpr int kStillMs = 140;           // a hand that pauses in a drag for less does not start a full picture
constexpr int kShowMs = 150;            // how often a growing picture is shown: showing costs a pass over it

/// While a tool drags something that wants the machine the picture stands, and the tool paints over it what changes.
bool holdsPicture(const Toolbox& toolbox) { return toolbox.active() && toolbox.active()->pausesOtherViews(); }

}  // namespace

Viewport::Viewport(session::Session& session, Toolbox& toolbox, QWidget* parent)
    : QWidget(parent), mSession(session), mDocument(session.document()), mToolbox(toolbox) {
  mToolbox.addView(*this);
  mVeil = new PreparingVeil(*this);  // below what tools draw
  mSurface = ViewSurface::make(*this, listener());
  setAccessibleName(tr("3D view"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(240, 180);
  mSectionTimer.setInterval(0);
  connect(&mSectionTimer, &QTimer::timeout, this, &Viewport::section);
  mRestTimer.setSingleShot(true);
  mRestTimer.setInterval(kStillMs);
  connect(&mRestTimer, &QTimer::timeout, this, [this] {
    if (holdsPicture(mToolbox)) return;
    bool hasBegun = tries([this] { begin(mCoarseScale > 2.5 ? Stage::Half : Stage::Full); });
    if (hasBegun && !mPauseTimer.isActive()) mSectionTimer.start();
  });
  mPauseTimer.setSingleShot(true);
  connect(&mPauseTimer, &QTimer::timeout, this, [this] { mSectionTimer.start(); });
  connect(&mToolbox, &Toolbox::activeChanged, this, &Viewport::sceneChanged);
  mLevelTimer.setSingleShot(true);
  connect(&mLevelTimer, &QTimer::timeout, this, [this] {
    if (mStage == Stage::Idle) tellProgress();
  });
  mPickTimer.setSingleShot(true);
  mPickTimer.setInterval(80);
  connect(&mPickTimer, &QTimer::timeout, this, &Viewport::pickUnderPointer);
}

Viewport::~Viewport() { release(); }

void Viewport::pause(int ms) {
  mSectionTimer.stop();
  mPauseTimer.start(ms);
}

glm::ivec2 Viewport::deviceSize() const {
  double ratio = devicePixelRatioF();
  return glm::max(glm::ivec2(std::lround(width() * ratio), std::lround(height() * ratio)), glm::ivec2(1));
}

void Viewport::sceneChanged() {
  if (std::exchange(mHasGivenUp, false)) noteLoss();
  wakeSheets();
  scene::Scene wanted = drawnScene();
  bool isSameFrame = marksOverlaps() == mFrame.marksOverlaps && mFrame.brickBytes == memoryBudget().gpuBrickBytes;
  bool isSameSize = mSurface->size() == deviceSize();
  if (wanted == mWanted && isSameFrame && isSameSize) return;
  mWanted = std::move(wanted);
  startAnew();
}

bool Viewport::marksOverlaps() const { return mToolbox.active() && mToolbox.active()->marksOverlaps(); }

/// The scene as it is drawn. The sheets themselves tell where they rest.
scene::Scene Viewport::drawnScene() const {
  scene::Scene scene = scene::pictureScene(mDocument.shown());
  for (auto& cut : scene.cuts)
    if (cut.membrane) cut.membrane->shape = {};
  return scene;
}

void Viewport::startAnew() {
  mPending = true;
  mRestTimer.stop();
  mToolbox.repaint(*this);
  if (mRenderer) {
    mVeil->await(mDocument.shown());
    if (mToldStage == Stage::Idle && isVisible()) {
      mToldStage = Stage::Coarse;
      mSinceTold.start();
      emit refined(0.0, tr("Preparing"));
    }
  }
  if (mRenderer && !mSectionTimer.isActive() && !mPauseTimer.isActive()) mSectionTimer.start();
}

void Viewport::begin(Stage stage) {
  mStage = stage;
  if (stage == Stage::Idle) return;
  ++mPictureNumber;
  mPending = mHasPicture = false;
  double scale = stage == Stage::Coarse ? mCoarseScale : stage == Stage::Half ? 2.0 : 1.0;
  mFrame = mSession.frame(glm::max(glm::ivec2(glm::round(glm::dvec2(deviceSize()) / scale)), glm::ivec2(1)));
  mFrame.scene = drawnScene();
  mFrame.marksOverlaps = marksOverlaps();
  mSheetsShown = mSession.shownCount();
  mFrame.scene.background.transparent = false;  // a window has something behind; pictures need not
  mFrame.countsInstances = stage != Stage::Half && scene::isCounted(mFrame.scene.model);  // half of it tells nothing
  if (stage == Stage::Full && mAwaitsCounts) mRenderer->bits(true);  // of a coarse one that was as large
  mAwaitsCounts = mFrame.countsInstances;
  if (stage != Stage::Full) mFrame.scene.rayCast.samplesPerPixel = 1;
  if (stage == Stage::Coarse) {
    mFrame.stepFactor = 2.0;
    mFrame.isPreview = true;
  }
}

void Viewport::section() {
  if (mVeil->awaitsPaint()) return;
  bool goesOn = tries([this] {
    bool moving = driveSheets();
    bool drawing = isVisible() && drawSome();
    bool hearing = hearCounts();
    if (!moving && !drawing && !hearing) mSectionTimer.stop();
  });
  if (!goesOn) mSectionTimer.stop();
  if (mSurface->context() && !mIsLost) tellProgress();
}

/// Works on the picture for a while. @return false when there is nothing to do until something happens
bool Viewport::drawSome() {
  if (mHasPicture && holdsPicture(mToolbox)) return false;
  if (mSurface->size() == glm::ivec2(0)) resizePicture();  // there was no memory for it
  if (mSurface->size() == glm::ivec2(0)) {
    mStage = Stage::Idle;
    mPending = false;
    return false;
  }
  bool otherData = mFrame.scene.volume.data != mDocument.shown().volume.data;
  // A coarse picture on its way is finished first: a steady drag would otherwise never show one.
  if (mPending && (mStage != Stage::Coarse || otherData)) begin(Stage::Coarse);
  if (mStage == Stage::Idle || mRestTimer.isActive()) return false;
  double budgetMs = mStage == Stage::Coarse ? kCoarseWorkMs : kWorkMs;
  QElapsedTimer clock;
  clock.start();
  bool done = mRenderer->work(mFrame, budgetMs);
  // Pause before a long piece of work: the picture that it will replace is dimmed first.
  if (!done && double(clock.nsecsElapsed()) * 1e-6 < budgetMs) mVeil->awaitLong();
  bool grown = mStage == Stage::Full && mRenderer->stats().samples > 0 && mSinceShown.elapsed() > kShowMs;
  if (done || grown) show();
  return !done || finishStage();
}

void Viewport::show() {
  if (mSurface->size() == glm::ivec2(0)) return;
  mSurface->take(*mRenderer);
  mHasPicture = mIsFresh = true;
  if (std::exchange(mTellsLoss, false)) emit drawnAnew();
  mSinceShown.restart();
  mVeil->lift(mFrame.scene);
  if (mPending) mVeil->await(mDocument.shown());
}

/// @return true when the next stage has begun; a coarse picture is looked at for a while first
bool Viewport::finishStage() {
  adaptCoarseScale();
  if (mPending || mStage == Stage::Half) {
    begin(mPending ? Stage::Coarse : Stage::Full);
    return true;
  }
  if (mStage == Stage::Coarse) {
    mRestTimer.start();
    return false;
  }
  mStage = Stage::Idle;
  mLosses = 0;
  pickUnderPointer();
  return false;
}

/// Tells the counts that have arrived. @return false when there are none to wait for
bool Viewport::hearCounts() {
  if (!mAwaitsCounts || !mRenderer || !isVisible()) return false;
  if (auto bits = mRenderer->bits()) {
    bool isOfFrame = bits->pictureSize == mFrame.pictureSize;
    mAwaitsCounts = !isOfFrame;
    if (mDocument.shown().model.data == mFrame.scene.model.data)
      emit counted(*bits, isOfFrame && !mPending && mStage != Stage::Coarse);
  }
  return mAwaitsCounts;
}

void Viewport::adaptCoarseScale() {
  if (mStage != Stage::Coarse) return;
  // Much of what instances take is for finding who shows, which is the same at any size: they are left three times as
  // long.
  const auto& passes = mRenderer->stats().passesMs;
  double ms = 0.0;
  for (auto [name, share] : {std::pair("RayCast", 1.0), {"Instances", 1.0 / 3.0}})
    if (auto found = passes.find(name); found != passes.end()) ms += share * found->second;
  if (ms > 0.0) mCoarseScale = adaptedScale(mCoarseScale, ms);
}

scene::Camera Viewport::frame(const scene::Scene& scene, scene::StandardView view) const {
  return scene::frameVisible(scene, view, logicalSize().x / logicalSize().y);
}

void Viewport::lookFrom(scene::StandardView view) {
  mDocument.view([camera = frame(mDocument.shown(), view)](scene::Scene& scene) { scene.camera = camera; });
}

void Viewport::toggleProjection() {
  mDocument.view([](scene::Scene& scene) {
    bool isPerspective = scene.camera.projection == scene::Projection::Perspective;
    scene.camera = scene::withProjection(
        scene.camera, isPerspective ? scene::Projection::Orthographic : scene::Projection::Perspective);
  });
}

std::optional<render::Pick> Viewport::pickAt(QPointF place) {
  if (!mHasPicture) return std::nullopt;
  glm::dvec2 share = glm::dvec2(place.x(), place.y()) / logicalSize();
  std::optional<render::Pick> pick;
  tries([&] { pick = mRenderer->pick(glm::ivec2(glm::floor(share * glm::dvec2(mFrame.pictureSize)))); });
  return pick;
}

Viewport::PixelIds Viewport::idsOfPixels(bool withDistances) {
  PixelIds ids;
  if (mHasPicture) tries([&] { ids = {mRenderer->idsOfPixels(withDistances), mFrame.pictureSize}; });
  return ids;
}

void Viewport::pickUnderPointer() {
  if (!underMouse() || mDrag != Drag::None) return;
  auto pick = pickAt(mPointer);
  if (pick && pick->hit)
    emit pointedAt(*pick);
  else if (pick)
    emit pointedAtNothing();
}

}  // namespace velum::gui
