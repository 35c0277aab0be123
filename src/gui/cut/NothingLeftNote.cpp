#include "NothingLeftNote.h"

#include "velum/session/cut/NothingLeft.h"

namespace velum::gui {

namespace {

constexpr int kPauseMs = 250;

/// What decides how much is left.
bool leavesTheSame(const scene::Scene& a, const scene::Scene& b) {
  return a.cuts == b.cuts && a.volume == b.volume && a.labels == b.labels && a.model == b.model &&
         a.surfaces == b.surfaces && a.rayCast == b.rayCast;
}

}  // namespace

NothingLeftNote::NothingLeftNote(session::Session& session, MessageBar& messages, QObject* parent)
    : QObject(parent), mSession(session), mMessages(messages) {
  mPause.setSingleShot(true);
  mPause.setInterval(kPauseMs);
  connect(&mPause, &QTimer::timeout, this, &NothingLeftNote::look);
}

NothingLeftNote::~NothingLeftNote() = default;

void NothingLeftNote::refresh() {
  const scene::Scene& scene = mSession.scene();
  if (leavesTheSame(scene, mLooked)) return;
  mLooked = scene;
  mJob.reset();  // what it would say is old
  if (scene.cuts.empty()) {
    mPause.stop();
    return tell(false);
  }
  mPause.start();
}

void NothingLeftNote::look() {
  auto isNothingLeft = std::make_shared<bool>(false);
  mJob = std::make_unique<Job>([isNothingLeft, scene = mSession.membranes().withShapes(mLooked)](
                                   Progress& progress) { *isNothingLeft = session::cutsTakeAll(scene, progress); },
                               nullptr);
  connect(mJob.get(), &Job::finished, this, [this, isNothingLeft](bool done, const QString&) {
    if (done) tell(*isNothingLeft);
  });
  mJob->start();
}

void NothingLeftNote::tell(bool isNothingLeft) {
  QString text = tr(session::kNothingLeft);
  if (isNothingLeft) return mMessages.showNote(text);
  if (mMessages.text() == text) mMessages.hide();
}

}  // namespace velum::gui
