#pragma once
#include <cxxabi.h>
#include <pybind11/pybind11.h>
#include <unistd.h>

#include <optional>

/// Python's lock, in threads that may be there still when Python ends (daemon threads). Python ends a thread that asks
/// for its lock then by unwinding the stack, through destructors that must not throw and past work that is not done,
/// which aborts the program. Such a thread rests until the process ends, as in Python 3.14.
namespace velum::python {

namespace detail {

template <class Ask>
void orRest(Ask ask) {
  try {
    ask();
  } catch (const abi::__forced_unwind&) {
    for (;;) ::pause();
  }
}

}  // namespace detail

/// Has the lock, while it lives. Any thread.
class Locked {
 public:
  Locked() {
    detail::orRest([this] { mLock.emplace(); });
  }

 private:
  std::optional<pybind11::gil_scoped_acquire> mLock;
};

/// Gives the lock, which the thread has, to other threads, while it lives.
class Unlocked {
 public:
  Unlocked() : mThread(PyEval_SaveThread()) {}
  ~Unlocked() {
    detail::orRest([this] { PyEval_RestoreThread(mThread); });
  }
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;

 private:
  PyThreadState* mThread;
};

}  // namespace velum::python
