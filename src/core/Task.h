#pragma once
#include <atomic>
#include <functional>
#include <string>

#include "core/Error.h"

namespace velum {

/// Connects long work with whoever waits for it: the worker calls `report` as it goes on; anybody may call `cancel`. A
/// default-made Progress listens to nobody and is never cancelled. Any thread.
class Progress {
 public:
  using Listener = std::function<void(double fraction, const std::string& what)>;

  Progress() = default;
  explicit Progress(Listener listener) : mListener(std::move(listener)) {}

  /// @param fraction  done so far, 0..1
  /// @throw Cancelled when cancel() was called
  void report(double fraction, const std::string& what) {
    throwIfCancelled();
    if (mListener) mListener(fraction, what);
  }
  void throwIfCancelled() const {
    if (mCancelled) throw Cancelled();
  }
  void cancel() { mCancelled = true; }
  bool isCancelled() const { return mCancelled; }

 private:
  Listener mListener;
  std::atomic<bool> mCancelled{false};
};

}  // namespace velum
