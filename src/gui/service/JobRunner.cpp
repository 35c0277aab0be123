#include "gui/service/JobRunner.h"
#include "gui/kit/CoreWords.h"

#include "core/Memory.h"
#include "gui/service/CallLater.h"
#include "gui/service/Job.h"

namespace velum::gui {

namespace {

constexpr double kAtOnceMs = 200.0;  // after longer the user wonders what has become of the click

}  // namespace

JobRunner::JobRunner(session::Session& session, ProgressStrip& strip, MessageBar& messages, QObject* parent)
    : QObject(parent), mSession(session), mStrip(strip), mMessages(messages) {
  connect(&strip, &ProgressStrip::cancelled, this, &JobRunner::cancel);
}

void JobRunner::start(const QString& what, session::Job::Work work, std::function<void()> whenDone) {
  if (!isBusy()) mMessages.hide();
  begin(what, std::move(work), std::move(whenDone));
}

void JobRunner::startShort(const QString& what, session::Job::Work work, std::function<void()> whenDone) {
  bool wasBusy = isBusy();
  begin(what, std::move(work), std::move(whenDone));
  if (!wasBusy) mSession.awaitJob(kAtOnceMs);
}

void JobRunner::run(const session::Call& call, bool merge) {
  mLastError.clear();
  try {
    if (!call.command().act && session::isLong(mSession.shown(), call)) return runLong(call, merge);
    Progress progress;
    auto told = session::run(mSession, call, progress, merge);
    if (!told.empty()) mMessages.showNote({}, told);
  } catch (const std::exception& error) {
    setError(QString::fromUtf8(error.what()));
  }
}

void JobRunner::runLong(const session::Call& call, bool merge) {
  auto make = [call](const scene::Scene& scene, Progress& progress) { return session::editOf(scene, call, progress); };
  auto commit = [this, call, merge](const session::Edit& edit) {
    session::commit(mSession.document(), edit, call, merge);
    if (!edit.told.empty()) mMessages.showNote({}, edit.told);
  };
  edit(QString::fromStdString(call.command().step(mSession.shown(), call.arguments())),
       {Beside::Ground::Scene, make, commit, true});
}

void JobRunner::edit(const QString& what, const Beside& beside) {
  auto edit = std::make_shared<session::Edit>();
  auto work = [edit, make = beside.make, scene = mSession.shown()](Progress& progress) {
    *edit = make(scene, progress);
  };
  auto done = [this, edit, what, beside] {
    const scene::Scene &now = mSession.shown(), &before = edit->before;
    bool isOfCuts = beside.ground == Beside::Ground::Cuts;
    if (isOfCuts ? now.cuts != before.cuts || now.model.data != before.model.data
                 : now.volume.data != before.volume.data)
      return;
    if (!isOfCuts && now != before) return this->edit(what, beside);
    beside.commit(*edit);
  };
  beside.isShort ? startShort(what, work, done) : start(what, work, done);
}

void JobRunner::begin(const QString& what, session::Job::Work work, std::function<void()> whenDone) {
  if (isBusy()) return mMessages.showNote(tr("Still busy: wait, or cancel what is running first."));
  mLastError.clear();
  mStrip.begin(what);
  auto report = [this](double fraction, const QString& part) {
    callLater(this, [this, fraction, part] { mStrip.setProgress(fraction, part); });
  };
  auto workAndTidy = [work = std::move(work)](Progress& progress) {
    work(progress);
    releaseFreeMemory();
  };
  mSession.startJob(std::move(workAndTidy), throttled(report),
                    [this, whenDone = std::move(whenDone)](const session::JobOutcome& outcome) {
                      mStrip.hide();
                      emit busyChanged(false);
                      setError(QString::fromStdString(outcome.error));
                      if (outcome.done) whenDone();
                      emit ended();
                    });
  emit busyChanged(true);
}

void JobRunner::cancel() {
  if (!isBusy()) return;
  mSession.cancelJob();
  mStrip.setProgress(0.0, tr("stopping"));
  emit cancelled();
}

void JobRunner::setError(const QString& error) {
  mLastError = error;
  if (!error.isEmpty()) mMessages.showError(inWords(error));
}

}  // namespace velum::gui
