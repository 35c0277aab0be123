#include "gui/model/Equalizer.h"

#include <algorithm>
#include <cmath>

#include "core/Error.h"
#include "session/model/CountPictures.h"
#include "session/model/HandleSolver.h"
#include "session/model/ModelEdit.h"
#include "session/model/TargetSolver.h"
#include "session/model/TypesAt.h"

namespace velum::gui {

namespace {

bool isNone(const scene::Scene& scene, const session::TypeNumbers& types) {
  std::vector<bool> shown = session::visibleTypes(scene.model);
  return std::none_of(types.begin(), types.end(), [&](std::uint32_t type) { return shown[type]; });
}

std::string labelOf(const session::TypesAt& place) {
  bool isAll = place.path.find('.') == std::string::npos;
  return "Set number of " + (isAll ? std::string("all types") : std::string(session::shortName(place.path)));
}

}  // namespace

struct Equalizer::Held {
  session::TypesAt place;
  Handle handle = Handle::Drawn;
  scene::Scene before, from;                        ///< as it was; with what a handle needs
  std::vector<int> cuts;                            ///< that are set
  std::unique_ptr<session::HandleSolver> solver;    ///< of all cuts
  std::unique_ptr<session::RenderedSolver> ofCuts;  ///< of those alone, instead
  render::TypeCount start, now;
  std::uint64_t wanted = 0;
  bool isMoved = false;

  session::Solved solve(double drawn) {
    if (ofCuts) return ofCuts->solve(drawn);
    session::Solved solved = solver->solve(drawn);
    cuts = solver->cuts();
    return solved;
  }
  std::uint64_t total() const { return (ofCuts ? ofCuts->range() : solver->range()).total; }
};

Equalizer::Equalizer(session::Session& session, Viewport& viewport, JobRunner& jobs, QObject* parent)
    : QObject(parent), mSession(session), mViewport(viewport), mJobs(jobs) {
  connect(&viewport, &Viewport::counted, this, &Equalizer::hear);
}

Equalizer::~Equalizer() = default;

void Equalizer::hear(const render::InstanceBits& bits, bool isComplete) {
  const auto& model = mSession.scene().model.data;
  if (!model || bits.count % std::max<std::uint64_t>(1, model->instances.size()) != 0) return;
  mCounts.take(model, bits, isComplete);
  if (isComplete) mToldPath.clear();
  emit counted();
}

void Equalizer::refresh() {
  const scene::ModelLayer& layer = mSession.scene().model;
  if (mCounts.model() == layer.data && layer.visible) return;
  mToldPath.clear();
  if (!mCounts.model()) return;
  mCounts.clear();
  emit counted();
}

void Equalizer::setCuts(std::vector<int> ids) { mChosen = std::move(ids); }

std::vector<int> Equalizer::cuts() const {
  std::vector<int> enabled = session::enabledCuts(mSession.scene()), chosen;
  for (int id : enabled)
    if (std::find(mChosen.begin(), mChosen.end(), id) != mChosen.end()) chosen.push_back(id);
  return chosen.empty() ? enabled : chosen;
}

render::TypeCount Equalizer::countOf(const std::string& path) const {
  render::TypeCount sum;
  if (!mCounts.model()) return sum;
  for (std::uint32_t type : session::typesAt(*mCounts.model(), path).types) sum += mCounts.types()[type];
  return sum;
}

void Equalizer::take(const std::string& path, Handle handle) {
  const scene::Scene& scene = mSession.scene();
  if (!scene.model.data) return;
  auto held = std::make_unique<Held>();
  held->place = session::typesAt(*scene.model.data, path);
  held->handle = handle;
  held->before = held->from = scene;
  held->cuts = cuts();
  // Who asks for more of what is hidden wants to see it.
  if (isNone(held->from, held->place.types)) session::setTypesVisible(held->from, held->place.types, true);
  bool isForView = handle == Handle::Seen && session::isCleared(held->from, held->cuts, held->place.types);
  double aspect = double(mViewport.width()) / std::max(1, mViewport.height());
  auto field = isForView ? session::DialField::ViewShare : session::DialField::Share;
  const std::string& whole = held->place.path;
  render::SheetIndices sheets = mSession.membranes().indices();
  if (isForView || !mChosen.empty())
    held->ofCuts = std::make_unique<session::RenderedSolver>(held->from, held->cuts, whole, sheets, aspect, field);
  else
    held->solver = std::make_unique<session::HandleSolver>(held->from, whole, sheets, aspect);
  held->start = held->now = held->place.path == mToldPath ? mToldCount : countOf(path);
  mToldPath.clear();
  mHeld = std::move(held);
}

void Equalizer::moveTo(double count) {
  if (!mHeld) return;
  Held& held = *mHeld;
  held.wanted = std::uint64_t(std::llround(std::max(0.0, count)));
  double drawn = count;
  if (held.handle == Handle::Seen) {
    // As many more are drawn as of those that were drawn are seen.
    double visible = double(held.start.visible), rendered = double(held.start.rendered());
    drawn = visible > 0.0 ? count * rendered / visible : rendered + count;
  }
  session::Solved solved = held.solve(drawn);
  held.isMoved = true;
  double seen = held.start.rendered() > 0 ? double(held.start.visible) / double(held.start.rendered()) : 1.0;
  held.now.visible = std::min(solved.reached, std::uint64_t(std::llround(double(solved.reached) * seen)));
  held.now.hidden = solved.reached - held.now.visible;
  held.now.clipped = held.total() - solved.reached;
  mSession.document().edit(
      labelOf(held.place),
      [&](scene::Scene& scene) {
        scene.cuts = std::move(solved.scene.cuts);
        scene.model.types = solved.scene.model.types;
      },
      true);
  emit counted();
  emit told(QString::fromStdString(solved.words));
}

void Equalizer::letGo() {
  if (!mHeld) return;
  std::unique_ptr<Held> held = std::move(mHeld);
  if (held->isMoved) mToldPath = held->place.path, mToldCount = held->now;
  if (held->isMoved && held->handle == Handle::Seen) return findSeen(std::move(held));
  mSession.document().endMerge();
}

void Equalizer::giveUp() {
  if (!mHeld) return;
  std::unique_ptr<Held> held = std::move(mHeld);
  if (held->isMoved)
    mSession.document().edit(
        labelOf(held->place),
        [&](scene::Scene& scene) {
          scene.cuts = held->before.cuts;
          scene.model.types = held->before.model.types;
        },
        true);
  mSession.document().endMerge();
  emit counted();
}

/// Pictures tell how many are seen: a job beside the window, into the step that the handle has begun.
void Equalizer::findSeen(std::unique_ptr<Held> held) {
  struct Search {
    std::unique_ptr<Held> held;
    session::Solved solved;
    std::vector<scene::Cut> cuts;  // as the handle left them
  };
  auto search = std::make_shared<Search>();
  search->cuts = mSession.scene().cuts;
  search->held = std::move(held);
  double ratio = mViewport.devicePixelRatioF();
  glm::ivec2 size(std::lround(mViewport.width() * ratio), std::lround(mViewport.height() * ratio));
  scene::Scene from = mSession.scene();
  auto work = [search, from, size](Progress& progress) {
    const Held& of = *search->held;
    search->solved = session::findVisible(from, of.cuts, of.place.path, double(of.wanted), glm::max(size, 1), progress);
  };
  auto done = [this, search] {
    session::Document& document = mSession.document();
    if (document.scene().cuts != search->cuts) return;  // somebody has gone on
    document.edit(
        labelOf(search->held->place), [&](scene::Scene& scene) { scene.cuts = std::move(search->solved.scene.cuts); },
        true);
    emit told(QString::fromStdString(search->solved.words));
  };
  // One that cannot begin, is cancelled or fails leaves what the handle has come to.
  if (mJobs.isBusy()) mSession.document().endMerge();
  connect(
      &mJobs, &JobRunner::ended, this, [this] { mSession.document().endMerge(); }, Qt::SingleShotConnection);
  mJobs.start(tr("Finding how many are to be drawn for %1 to be seen").arg(search->held->wanted), work, done);
}

std::string Equalizer::heldPath() const { return mHeld ? mHeld->place.path : mToldPath; }

render::TypeCount Equalizer::heldCount() const { return mHeld ? mHeld->now : mToldCount; }

void Equalizer::set(const std::string& path, Handle handle, double count) {
  take(path, handle);
  moveTo(count);
  letGo();
}

}  // namespace velum::gui
