#pragma once
#include <atomic>
#include <functional>
#include <string>
#include <thread>

#include "core/Task.h"

namespace velum::session {

/// How long work ended.
struct JobOutcome {
  bool done = false;  ///< false: it was cancelled, or has failed
  std::string error;  ///< one line for the user; empty when it is done or was cancelled
};

/// Who waits for work: nobody in particular, so that it gives way to the window, or a hand that is moving.
enum class Urgency { Background, Hand };

/// Long work in a thread of its own: it tells how far it is, can be cancelled, and is cancelled and awaited when the
/// object goes.
class Job {
 public:
  using Work = std::function<void(Progress&)>;
  using Ended = std::function<void(const JobOutcome&)>;

  /// Begins at once. @param progressed, ended  called from the job's thread
  Job(Work work, Progress::Listener progressed, Ended ended, Urgency urgency = Urgency::Background);
  ~Job();
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  void cancel() { mProgress.cancel(); }
  /// It is over, and has told so.
  bool hasEnded() const { return mHasEnded; }

 private:
  void run(const Work& work, const Ended& ended, Urgency urgency);

  Progress mProgress;
  std::atomic<bool> mHasEnded{false};
  std::thread mThread;
};

/// From now on the threads that share out long work give way to the window's own and to the driver's, so that a view
/// answers the hand while every core is busy. Call once, in the window's thread, before the first work.
/// Linux only; elsewhere it does nothing.
void giveWayToTheWindow();

}  // namespace velum::session
