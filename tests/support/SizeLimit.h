#pragma once
#include <sys/resource.h>

#include <cstdint>

#include "velum/core/GuardWrites.h"

namespace velum {

/// Stands in for a disk that is full: no file of this process grows beyond so many bytes while it lives.
class SizeLimit {
 public:
  explicit SizeLimit(std::uintmax_t bytes) {
    guardWrites();
    ::getrlimit(RLIMIT_FSIZE, &mBefore);
    rlimit now{rlim_t(bytes), mBefore.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &now);
  }
  ~SizeLimit() { ::setrlimit(RLIMIT_FSIZE, &mBefore); }
  SizeLimit(const SizeLimit&) = delete;
  SizeLimit& operator=(const SizeLimit&) = delete;

 private:
  rlimit mBefore{};
};

}  // namespace velum
