#pragma once
#include <string_view>

namespace velum::gpu {

/// A mark among the GPU's commands: signalled when all commands that were handed over before the mark are done.
/// Move-only, empty by default. GL thread of its context.
class Fence {
 public:
  Fence() = default;
  /// Places the mark behind all commands given so far.
  explicit Fence(std::string_view label);
  Fence(Fence&& other) noexcept;
  Fence& operator=(Fence&& other) noexcept;
  ~Fence();

  explicit operator bool() const { return mSync != nullptr; }
  /// Whether the fence is signalled, without waiting. Hands the commands over to the GPU, so that asking again and
  /// again comes to an end. An empty fence is signalled.
  bool isSignalled() const { return wait(0.0); }
  /// Waits until the fence is signalled, `timeoutMs` at most. @return whether the fence is signalled
  bool wait(double timeoutMs) const;

 private:
  void* mSync = nullptr;  ///< GLsync
  unsigned mContext = 0;  ///< in which it is; gone with it
};

}  // namespace velum::gpu
