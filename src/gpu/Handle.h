#pragma once
#include <utility>

#include "core/Assert.h"
#include "gpu/Loss.h"

namespace velum::gpu {

/// Owner of one GL object by its name (a number): empty by default, move-only; its destructor deletes the object. The
/// context must be current then; where that is gone, or was lost and made anew, the object has gone with it.
template <void (*Destroy)(unsigned)>
class Handle {
 public:
  Handle() = default;
  explicit Handle(unsigned id) : mId(id), mContext(contextNumber()) {}
  Handle(Handle&& other) noexcept : mId(std::exchange(other.mId, 0u)), mContext(other.mContext) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(mId, other.mId);
    std::swap(mContext, other.mContext);
    return *this;
  }
  ~Handle() {
    if (mId && mContext == contextNumber()) Destroy(mId);
  }
  unsigned id() const {
    VELUM_ASSERT(!mId || mContext == contextNumber(), "an object is used in its own context");
    return mId;
  }
  explicit operator bool() const { return mId != 0; }

 private:
  unsigned mId = 0, mContext = 0;
};

}  // namespace velum::gpu
