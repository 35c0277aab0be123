#include "gui/window/QuitSignals.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>

#include "core/Assert.h"

namespace velum::gui {

namespace {

constexpr int kSignals[] = {SIGTERM, SIGINT, SIGHUP};

std::atomic<int> gPipe{-1};  // for the signal handler alone

/// The signal handler; does only what a handler may do.
void onSignal(int number) {
  int error = errno;
  for (int one : kSignals) std::signal(one, SIG_DFL);
  char byte = char(number);
  if (::write(gPipe, &byte, 1) != 1) ::raise(number);
  errno = error;
}

}  // namespace

QuitSignals::QuitSignals() {
  VELUM_ASSERT(gPipe < 0, "a process has one of these");
  if (::pipe2(mPipe, O_CLOEXEC | O_NONBLOCK) != 0) return;  // then they end the process, as they would without this
  gPipe = mPipe[1];
  mNotifier = new QSocketNotifier(mPipe[0], QSocketNotifier::Read, this);
  connect(mNotifier, &QSocketNotifier::activated, this, &QuitSignals::read);
  for (int number : kSignals)
    if (std::signal(number, onSignal) == SIG_IGN) std::signal(number, SIG_IGN);
}

QuitSignals::~QuitSignals() {
  for (int number : kSignals)
    if (std::signal(number, SIG_DFL) == SIG_IGN) std::signal(number, SIG_IGN);
  gPipe = -1;
  delete mNotifier;  // before what it listens to
  for (int end : mPipe)
    if (end >= 0) ::close(end);
}

void QuitSignals::read() {
  char number = 0;
  if (::read(mPipe[0], &number, 1) == 1) emit asked(128 + number);
}

}  // namespace velum::gui
