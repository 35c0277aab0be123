#pragma once
#include <string_view>

namespace velum::gpu {

/// A mark among the GPU's commands: signalled when all that were handed over before it are done. Move-only, empty by
/// default. GL thread of its context.
class Fence {
 public:
  Fence() = default;
  /// Placed behind all commands so far.
  explicit Fence(std::string_view label);
  Fence(Fence&& other) noexcept;
  Fence& operator=(Fence&& other) noexcept;
  ~Fence();

  explicit operator bool() const { return mSync != nullptr; }
  /// Asks without waiting, and hands the commands over, so that asking again ends. An empty fence is signalled.
  bool isSignalled() const { return wait(0.0); }
  /// Waits until the fence is signalled, `timeoutMs` at most. @return whether it is
  bool wait(double timeoutMs) const;

 private:
  void* mSync = nullptr;  ///< GLsync
};

}  // namespace velum::gpu
