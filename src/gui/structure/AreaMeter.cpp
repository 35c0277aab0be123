#include "gui/structure/AreaMeter.h"

#include <algorithm>
#include <cmath>

#include "gpu/Context.h"
#include "render/Renderer.h"
#include "session/model/PictureCounter.h"
#include "session/structure/StructureEdit.h"

namespace velum::gui {

namespace {

constexpr int kPatienceMs = 300;  // a hand that moves on is not measured on its way
constexpr int kWidth = 320;       // of the picture that is counted in: a pixel of a bar is less than one in a hundred

}  // namespace

struct AreaMeter::Held {
  scene::Scene before;
  session::AreaSolver solver;
  session::StructureArea start, now;
  bool isMoved = false;
};

AreaMeter::AreaMeter(session::Session& session, Viewport& viewport, QObject* parent)
    : QObject(parent), mSession(session), mViewport(viewport), mCounting(kPatienceMs, this) {}

AreaMeter::~AreaMeter() = default;

void AreaMeter::setOn(bool on) {
  mIsOn = on;
  if (on) return refresh();
  mCounting.stop();
  mMeasured = {};
  mResult = {};
}

void AreaMeter::refresh() {
  if (!mIsOn || mHeld || mSession.scene() == mMeasured) return;
  mMeasured = mSession.scene();
  if (!mMeasured.labels.data) {
    mCounting.stop();
    mResult = {};
    emit measured();
    return;
  }
  measure();
}

// Without a driver for pictures in the background there are no bars: the error has no place in the window.
void AreaMeter::measure() {
  auto result = std::make_shared<Result>();
  mCounting.want([this, result] { return counting(result); },
                 [this, result] {
                   mResult = std::move(*result);
                   emit measured();
                 });
}

Job::Work AreaMeter::counting(const std::shared_ptr<Result>& result) const {
  int height = std::max(1, int(std::lround(double(kWidth) * mViewport.height() / std::max(1, mViewport.width()))));
  return [result, scene = mMeasured, sheets = mSession.membranes().indices(),
          size = glm::ivec2(kWidth, height)](Progress& progress) {
    result->cuts = session::cutsToPullFrom(scene);
    result->hits = render::structureHits(scene, size, result->cuts, progress, sheets);
    auto context = gpu::Context::create(gpu::ContextKind::Auto);
    render::Renderer renderer(*context);
    session::PictureCounter counter(renderer, size, context->limits(), progress);
    result->areas = session::structureAreas(scene, result->hits, counter.structures(scene));
  };
}

const session::StructureArea* AreaMeter::find(int id) const {
  if (mHeld && mHeld->now.structure == id) return &mHeld->now;
  auto found = std::find_if(mResult.areas.begin(), mResult.areas.end(),
                            [id](const session::StructureArea& area) { return area.structure == id; });
  return found == mResult.areas.end() ? nullptr : &*found;
}

bool AreaMeter::take(int id) {
  const session::StructureArea* area = find(id);
  if (!area || isMeasuring()) return false;
  if (mResult.cuts.empty()) {
    emit told(tr("There is no cut out of which it could be pulled: add one first (C)"));
    return false;
  }
  const scene::Scene& scene = mSession.scene();
  mHeld.reset(new Held{scene, session::AreaSolver(scene, mResult.cuts, id, mResult.hits), *area, *area, false});
  return true;
}

void AreaMeter::moveTo(double pixels) {
  if (!mHeld) return;
  Held& held = *mHeld;
  session::SolvedArea solved = held.solver.solve(pixels);
  held.isMoved = true;
  double seen = held.start.left() > 0 ? double(held.start.visible) / double(held.start.left()) : 1.0;
  held.now.visible = std::min(solved.reached, std::uint64_t(std::llround(double(solved.reached) * seen)));
  held.now.hidden = solved.reached - held.now.visible;
  held.now.clipped = held.start.total() - std::min(held.start.total(), solved.reached);
  std::string label = session::structureLabel(held.before, "Pull out", {held.start.structure});
  mSession.document().edit(
      label, [&](scene::Scene& scene) { scene.cuts = std::move(solved.scene.cuts); }, true);
  emit measured();
  emit told(QString::fromStdString(solved.words));
}

void AreaMeter::letGo() {
  if (!mHeld) return;
  mHeld.reset();
  mSession.document().endMerge();
  refresh();
}

void AreaMeter::giveUp() {
  if (!mHeld) return;
  std::unique_ptr<Held> held = std::move(mHeld);
  if (held->isMoved) {
    std::string label = session::structureLabel(held->before, "Pull out", {held->start.structure});
    mSession.document().edit(
        label, [&](scene::Scene& scene) { scene.cuts = held->before.cuts; }, true);
  }
  mSession.document().endMerge();
  emit measured();
}

}  // namespace velum::gui
