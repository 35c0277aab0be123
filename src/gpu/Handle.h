#pragma once
#include <utility>

namespace velum::gpu {

/// Owner of one GL name: empty by default, move-only, destroyed by its destructor. Needs the context current.
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
