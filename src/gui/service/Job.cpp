#include "gui/service/Job.h"

#include <chrono>

#include "gui/kit/CoreWords.h"
#include "gui/service/CallLater.h"

namespace velum::gui {

Progress::Listener throttled(std::function<void(double fraction, const QString& what)> listener) {
  using Clock = std::chrono::steady_clock;
  return
      [listener = std::move(listener), last = Clock::time_point{}](double fraction, const std::string& what) mutable {
        auto now = Clock::now();
        if (now - last < std::chrono::milliseconds(33)) return;
        last = now;
        listener(fraction, QString::fromStdString(what));
      };
}

Job::Job(Work work, QObject* parent, session::Urgency urgency)
    : QObject(parent), mWork(std::move(work)), mUrgency(urgency) {}

Job::~Job() {
  mJob.reset();  // cancels and waits, while there is somebody to hear it
}

void Job::start() {
  mJob = std::make_unique<session::Job>(
      std::move(mWork), throttled([this](double fraction, const QString& what) {
        callLater(this, [this, fraction, what] { emit progressed(fraction, what); });
      }),
      [this](const session::JobOutcome& outcome) {
        callLater(this, [this, outcome] { emit finished(outcome.done, inWords(outcome.error)); });
      },
      mUrgency);
}

void Job::cancel() {
  if (mJob) mJob->cancel();
}

}  // namespace velum::gui
