#include "gui/model/Equalizer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "gui/kit/CoreWords.h"
#include "scene/Crowd.h"
#include "session/command/Command.h"
#include "session/command/CutCommands.h"
#include "session/command/ModelCommands.h"
#include "session/model/CountPictures.h"
#include "session/model/ModelEdit.h"
#include "session/model/RenderedSolver.h"
#include "session/model/TargetSolver.h"
#include "session/model/TypesAt.h"

namespace velum::gui {

namespace {

bool isNone(const scene::Scene& scene, const session::TypeNumbers& types) {
  std::vector<bool> shown = session::visibleTypes(scene.model);
  return std::none_of(types.begin(), types.end(), [&](std::uint32_t type) { return shown[type]; });
}

std::string labelOf(const scene::Scene& scene, const session::TypesAt& place) {
  bool isAll = place.path.find('.') == std::string::npos;
  return "Set number of " + (isAll ? std::string("all types") : session::nameAt(scene, place.path));
}

}  // namespace

Equalizer::Equalizer(session::Session& session, Viewport& viewport, JobRunner& jobs, QObject* parent)
    : QObject(parent), mSession(session), mViewport(viewport), mJobs(jobs), mBar(session.document()) {
  connect(&viewport, &Viewport::counted, this, &Equalizer::hear);
}

void Equalizer::hear(const render::InstanceBits& bits, bool isComplete) {
  const auto& model = mSession.shown().model.data;
  if (!model || bits.count % std::max<std::uint64_t>(1, model->instances.size()) != 0) return;
  mCounts.take(model, bits, isComplete);
  if (isComplete && !isHeld()) mHeldPath.clear();
  emit counted();
}

void Equalizer::refresh() {
  const scene::ModelLayer& layer = mSession.shown().model;
  if (mCounts.model() == layer.data && scene::isCounted(layer)) return;
  if (!isHeld()) mHeldPath.clear();
  if (!mCounts.model()) return;
  mCounts.clear();
  emit counted();
}

void Equalizer::setCuts(std::vector<int> ids) { mChosen = std::move(ids); }

std::vector<int> Equalizer::cuts() const {
  std::vector<int> enabled = session::enabledCuts(mSession.shown()), chosen;
  for (int id : enabled)
    if (std::find(mChosen.begin(), mChosen.end(), id) != mChosen.end()) chosen.push_back(id);
  return chosen.empty() ? enabled : chosen;
}

Counts Equalizer::countOf(const std::string& path) const {
  Counts sum;
  if (!mCounts.model()) return sum;
  for (std::uint32_t type : session::typesAt(*mCounts.model(), path).types) sum += mCounts.types()[type];
  return sum;
}

void Equalizer::take(const std::string& path, Handle handle) {
  scene::Scene from = mSession.shown();
  if (!from.model.data) return;
  session::TypesAt place = session::typesAt(*from.model.data, path);
  // A user who asks for more instances of hidden types wants to see them.
  if (isNone(from, place.types)) session::setTypesVisible(from, place.types, true);
  bool isForView = handle == Handle::Seen && session::isCleared(from, cuts(), place.types);
  double aspect = double(mViewport.width()) / std::max(1, mViewport.height());
  auto field = isForView ? session::DialField::ViewShare : session::DialField::Share;
  render::SheetIndices sheets = mSession.membranes().indices();
  auto solver = std::make_shared<session::RenderedSolver>(
      isForView || !mChosen.empty() ? session::RenderedSolver(from, cuts(), place.path, sheets, aspect, field)
                                    : session::RenderedSolver::ofAllCuts(from, place.path, sheets, aspect));
  mBar.take({labelOf(mSession.shown(), place), handle, place.path == mHeldPath ? mBar.now() : countOf(path),
             solver->range().total, [solver, handle](double drawn) {
               session::Solved solved = solver->solve(drawn);
               if (handle == Handle::Left)
                 session::holdDrawn(solved.scene, solver->path(), double(solved.reached));
               else
                 session::setVisibleTarget(solved.scene, solver->path(), std::nullopt);
               return solved;
             }});
  mHeldPath = place.path;
}

void Equalizer::moveTo(double count) {
  if (!isHeld()) return;
  std::string words = mBar.moveTo(count);
  emit counted();
  emit told(inWords(words));
}

void Equalizer::letGo() {
  if (!isHeld()) return;
  if (!mBar.isMoved()) mHeldPath.clear();
  if (auto wish = mBar.letGo()) findSeen(*wish);
}

void Equalizer::giveUp() {
  if (!isHeld()) return;
  mHeldPath.clear();
  mBar.giveUp();
  emit counted();
}

/// A job in the background draws pictures to find how many instances are seen; its edit joins the undo step that the
/// handle has begun.
void Equalizer::findSeen(const session::Bar::Wish& wish) {
  double ratio = mViewport.devicePixelRatioF();
  glm::ivec2 size(std::lround(mViewport.width() * ratio), std::lround(mViewport.height() * ratio));
  std::vector<std::string> cuts;
  for (int id : mChosen.empty() ? std::vector<int>() : wish.cuts) cuts.push_back(session::cutKey(mSession.shown(), id));
  session::Call call = session::LetSee{mHeldPath, fmt::format("{}", wish.seen), cuts,
                                       fmt::format("{}x{}", std::max(size.x, 1), std::max(size.y, 1))};
  auto make = [call, step = wish.label](const scene::Scene& scene, Progress& progress) {
    session::Edit edit = session::editOf(scene, call, progress);
    edit.step = step;
    return edit;
  };
  // The step began with what the hand dragged, cuts that it has added among it: a script says it by fields.
  auto commit = [this](const session::Edit& edit) {
    session::editByHand(
        mSession.document(), edit.step,
        [&](scene::Scene& scene) {
          scene.cuts = edit.after.cuts;
          scene.model.targets = edit.after.model.targets;
        },
        true);
    emit told(QString::fromStdString(edit.told.front()));
  };
  // A job that cannot begin, is cancelled or fails leaves the cuts as the handle has set them.
  if (mJobs.isBusy()) mSession.document().endMerge();
  connect(
      &mJobs, &JobRunner::ended, this, [this] { mSession.document().endMerge(); }, Qt::SingleShotConnection);
  mJobs.edit(tr("Finding how many are to be drawn for %1 to be seen").arg(wish.seen),
             {JobRunner::Beside::Ground::Cuts, make, commit});
}

void Equalizer::set(const std::string& path, Handle handle, double count) {
  take(path, handle);
  moveTo(count);
  letGo();
}

}  // namespace velum::gui
