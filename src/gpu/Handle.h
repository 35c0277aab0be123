#pragma once
#include <utility>

namespace velum::gpu {

/// Owner of one GL object by its name (a number): empty by default, move-only; its destructor deletes the object. The
/// context must be current then.
template <void (*Destroy)(unsigned)>
class Handle {
 public:
  Handle() = default;
  explicit Handle(unsigned id) : mId(id) {}
  Handle(Handle&& other) noexcept : mId(std::exchange(other.mId, 0u)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(mId, other.mId);
    return *this;
  }
  ~Handle() {
    if (mId) Destroy(mId);
  }
  unsigned id() const { return mId; }
  explicit operator bool() const { return mId != 0; }

 private:
  unsigned mId = 0;
};

}  // namespace velum::gpu
