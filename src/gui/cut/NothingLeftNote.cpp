#include "gui/cut/NothingLeftNote.h"

#include <memory>

#include "gui/kit/Words.h"
#include "session/cut/NothingLeft.h"

namespace velum::gui {

namespace {

constexpr int kPauseMs = 250;

/// True when two scenes agree in all that decides how much cuts leave.
bool leavesTheSame(const scene::Scene& a, const scene::Scene& b) {
  return a.cuts == b.cuts && a.volume == b.volume && a.labels == b.labels && a.model == b.model &&
         a.surfaces == b.surfaces && a.rayCast == b.rayCast;
}

}  // namespace

NothingLeftNote::NothingLeftNote(session::Session& session, MessageBar& messages, QObject* parent)
    : QObject(parent), mSession(session), mMessages(messages), mLook(kPauseMs, this) {}

void NothingLeftNote::refresh() {
  const scene::Scene& scene = mSession.shown();
  if (leavesTheSame(scene, mLooked)) return;
  mLooked = scene;
  if (scene.cuts.empty()) {
    mLook.stop();
    return tell(false);
  }
  auto isNothingLeft = std::make_shared<bool>(false);
  mLook.want(
      [this, isNothingLeft]() -> Job::Work {
        return [isNothingLeft, scene = mSession.membranes().withShapes(mLooked)](Progress& progress) {
          *isNothingLeft = session::cutsTakeAll(scene, progress);
        };
      },
      [this, isNothingLeft] { tell(*isNothingLeft); });
}

void NothingLeftNote::tell(bool isNothingLeft) {
  QString text = wordsOf(session::kNothingLeft);
  if (isNothingLeft) return mMessages.showNote(text);
  if (mMessages.text() == text) mMessages.hide();
}

}  // namespace velum::gui
