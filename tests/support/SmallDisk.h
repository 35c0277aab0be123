#pragma once
#include <signal.h>
#include <sys/resource.h>

namespace velum {

/// While one lives, the system takes only so many bytes of a file: a disk that fills up.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : mHandler(::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &mLimit);
    rlimit small{bytes, mLimit.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &mLimit);
    ::signal(SIGXFSZ, mHandler);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  rlimit mLimit{};
  void (*mHandler)(int);
};

}  // namespace velum
