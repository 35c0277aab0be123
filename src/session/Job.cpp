#include "session/Job.h"

#if defined(__linux__)
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

#include <new>

#include "core/Error.h"
#include "core/Parallel.h"

namespace velum::session {

namespace {

/// A tenth of the share of a thread of normal priority, when both want the same core; all of it otherwise.
constexpr int kNice = 10;

/// For the calling thread.
void giveWay() {
#if defined(__linux__)
  // Linux keeps a niceness for each thread, whatever POSIX says. It cannot be taken back, nor need it.
  setpriority(PRIO_PROCESS, id_t(syscall(SYS_gettid)), kNice);
#endif
}

}  // namespace

void giveWayToTheWindow() { onHelpers(giveWay); }

Job::Job(Work work, Progress::Listener progressed, Ended ended, Urgency urgency) : mProgress(std::move(progressed)) {
  mThread =
      std::thread([this, work = std::move(work), ended = std::move(ended), urgency] { run(work, ended, urgency); });
}

Job::~Job() {
  cancel();
  if (mThread.joinable()) mThread.join();
}

void Job::run(const Work& work, const Ended& ended, Urgency urgency) {
  if (urgency == Urgency::Background) giveWay();
  JobOutcome outcome;
  try {
    work(mProgress);
    outcome.done = true;
  } catch (const Cancelled&) {
  } catch (const std::bad_alloc&) {
    outcome.error = "The machine has no memory left for this; use a smaller volume or picture.";
  } catch (const std::exception& error) {
    outcome.error = error.what();
  }
  mHasEnded = true;
  if (ended) ended(outcome);
}

}  // namespace velum::session
