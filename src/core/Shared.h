#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>
#include "core/Assert.h"

namespace velum {

namespace detail {
inline std::uint64_t nextPayloadId() {
  static std::atomic<std::uint64_t> next{1};
  return next++;
}
}  // namespace detail

/// An immutable payload that copies share: cheap to copy; two are equal when they hold the same payload. The id is
/// never used twice (an address may be), so it is the key of every cache. Empty by default, with id 0. Any thread.
template <class T>
class Shared {
 public:
  Shared() = default;
  Shared(T value) : mValue(std::make_shared<const T>(std::move(value))), mId(detail::nextPayloadId()) {}

  explicit operator bool() const { return bool(mValue); }
  const T& operator*() const { return *operator->(); }
  const T* operator->() const {
    VELUM_ASSERT(mValue, "there is a payload");
    return mValue.get();
  }
  std::uint64_t id() const { return mId; }
  bool operator==(const Shared& other) const { return mId == other.mId; }

 private:
  std::shared_ptr<const T> mValue;
  std::uint64_t mId = 0;
};

}  // namespace velum
