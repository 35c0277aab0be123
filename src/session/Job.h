#pragma once
#include <atomic>
#include <functional>
#include <string>
#include <thread>

#include "core/Task.h"

namespace velum::session {

/// How a piece of long work has ended.
struct JobOutcome {
  bool done = false;  ///< false: the work was cancelled, or has failed
  std::string error;  ///< one line for the user; empty when the work is done or was cancelled
};

/// Who waits for a piece of work. Background: nobody in particular, so the work gives way to the window. Hand: a hand
/// that is moving, so the work does not give way.
enum class Urgency { Background, Hand };

/// Long work in a thread of its own. A job reports its progress and can be cancelled; its destructor cancels the work
/// and waits for its end.
class Job {
 public:
  using Work = std::function<void(Progress&)>;
  using Ended = std::function<void(const JobOutcome&)>;

  /// Begins the work at once. @param progressed, ended  called from the job's thread
  Job(Work work, Progress::Listener progressed, Ended ended, Urgency urgency = Urgency::Background);
  ~Job();
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  void cancel() { mProgress.cancel(); }
  /// True when the work is over. The call of `ended` may still be running.
  bool hasEnded() const { return mHasEnded; }

 private:
  void run(const Work& work, const Ended& ended, Urgency urgency);

  Progress mProgress;
  std::atomic<bool> mHasEnded{false};
  std::thread mThread;
};

/// From now on the helper threads among which long work is shared out (core/Parallel.h) give way to the window's thread
/// and to the driver's, so that a view answers the hand while every core is busy. Call once, in the window's thread,
/// before the first work.
/// Linux only; elsewhere it does nothing.
void giveWayToTheWindow();

}  // namespace velum::session
