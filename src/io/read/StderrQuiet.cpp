#include "io/read/StderrQuiet.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <mutex>

namespace velum::io {

namespace {

std::mutex gMutex;
int gUsers = 0;  // guarded by gMutex
int gKept = -1;  // the standard error as it was

}  // namespace

StderrQuiet::StderrQuiet() {
  std::lock_guard lock(gMutex);
  if (gUsers++ > 0) return;
  std::cerr.flush();
  std::fflush(stderr);
  gKept = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
  int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (gKept >= 0 && nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
  if (nowhere >= 0) ::close(nowhere);
}

StderrQuiet::~StderrQuiet() {
  std::lock_guard lock(gMutex);
  if (--gUsers > 0 || gKept < 0) return;
  std::cerr.flush();
  std::fflush(stderr);
  ::dup2(gKept, STDERR_FILENO);
  ::close(gKept);
  gKept = -1;
}

}  // namespace velum::io
