#include "Courtesy.h"

#include <tbb/task_scheduler_observer.h>

#if defined(__linux__)
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace velum::gui {

namespace {

/// A tenth of the share of a thread of normal priority, when both want the same core; all of it otherwise.
constexpr int kNice = 10;

class Observer : public tbb::task_scheduler_observer {
 public:
  Observer() { observe(true); }
  void on_scheduler_entry(bool isWorker) override {
    if (isWorker) giveWay();
  }
};

}  // namespace

void giveWay() {
#if defined(__linux__)
  // Linux keeps a niceness for each thread, whatever POSIX says. It cannot be taken back, nor need it.
  setpriority(PRIO_PROCESS, id_t(syscall(SYS_gettid)), kNice);
#endif
}

void giveWayToTheWindow() { static Observer observer; }

}  // namespace velum::gui
