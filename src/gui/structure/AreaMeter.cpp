#include "gui/structure/AreaMeter.h"

#include <algorithm>
#include <cmath>

#include "gpu/Context.h"
#include "gui/kit/CoreWords.h"
#include "render/Renderer.h"
#include "session/extrusion/AreaSolver.h"
#include "session/model/PictureCounter.h"
#include "session/structure/StructureEdit.h"

namespace velum::gui {

namespace {

constexpr int kPatienceMs = 300;  // a hand that moves on is not measured on its way
constexpr int kWidth = 320;       // of the picture that is counted in: a pixel of a bar is less than one in a hundred

}  // namespace

AreaMeter::AreaMeter(session::Session& session, Viewport& viewport, QObject* parent)
    : QObject(parent), mSession(session), mViewport(viewport), mCounting(kPatienceMs, this), mBar(session.document()) {}

void AreaMeter::setOn(bool on) {
  mIsOn = on;
  if (on) return refresh();
  mCounting.stop();
  mMeasured = {};
  mResult = {};
}

void AreaMeter::refresh() {
  if (!mIsOn || isHeld() || mSession.shown() == mMeasured) return;
  mMeasured = mSession.shown();
  if (!mMeasured.labels.data) {
    mCounting.stop();
    mResult = {};
    emit measured();
    return;
  }
  measure();
}

/// Where there is no picture to count in, as for want of memory, there are no bars rather than those of another scene.
void AreaMeter::measure() {
  auto result = std::make_shared<Result>();
  mCounting.want([this, result] { return counting(result); },
                 [this, result] {
                   mResult = std::move(*result);
                   emit measured();
                 },
                 [this](const QString& why) {
                   mResult = {};
                   emit measured();
                   emit failed(why);
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

const Counts* AreaMeter::find(int id) const {
  if (isHeld() && mHeldId == id) return &mBar.now();
  auto found = std::find_if(mResult.areas.begin(), mResult.areas.end(),
                            [id](const session::StructureArea& area) { return area.structure == id; });
  return found == mResult.areas.end() ? nullptr : &found->count;
}

bool AreaMeter::take(int id) {
  const Counts* area = find(id);
  if (!area || isMeasuring()) return false;
  if (mResult.cuts.empty()) {
    emit told(tr("There is no cut out of which it could be pulled: add one first (C)"));
    return false;
  }
  const scene::Scene& scene = mSession.shown();
  session::AreaSolver solver(scene, mResult.cuts, id, mResult.hits);
  mBar.take({session::structureLabel(scene, "Pull out", {id}), session::Bar::Handle::Left, *area, area->total(),
             [solver = std::move(solver)](double pixels) { return solver.solve(pixels); }});
  mHeldId = id;
  return true;
}

void AreaMeter::moveTo(double pixels) {
  if (!isHeld()) return;
  std::string words = mBar.moveTo(pixels);
  emit measured();
  emit told(inWords(words));
}

void AreaMeter::letGo() {
  if (!isHeld()) return;
  mBar.letGo();
  refresh();
}

void AreaMeter::giveUp() {
  if (!isHeld()) return;
  mBar.giveUp();
  emit measured();
}

}  // namespace velum::gui
