#include "Job.h"

#include <chrono>

#include "Courtesy.h"
#include "velum/core/Error.h"

namespace velum::gui {

namespace {

/// Passes on at most thirty reports a second, so that a fast reader does not flood the event queue.
Progress::Listener throttled(Job* job) {
  using Clock = std::chrono::steady_clock;
  return [job, last = Clock::time_point{}](double fraction, const std::string& what) mutable {
    auto now = Clock::now();
    if (now - last < std::chrono::milliseconds(33)) return;
    last = now;
    emit job->progressed(fraction, QString::fromStdString(what));
  };
}

}  // namespace

Job::Job(Work work, QObject* parent) : QObject(parent), mWork(std::move(work)), mProgress(throttled(this)) {}

Job::~Job() {
  cancel();
  if (mThread.joinable()) mThread.join();
}

void Job::start() { mThread = std::thread(&Job::run, this); }

void Job::run() {
  giveWay();
  try {
    mWork(mProgress);
    emit finished(true, {});
  } catch (const Cancelled&) {
    emit finished(false, {});
  } catch (const std::bad_alloc&) {
    emit finished(false, tr("The machine has no memory left for this; use a smaller volume or picture."));
  } catch (const std::exception& error) {
    emit finished(false, QString::fromUtf8(error.what()));
  }
}

}  // namespace velum::gui
