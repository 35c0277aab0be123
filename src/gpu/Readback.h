#pragma once
#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "gpu/Buffer.h"
#include "gpu/Fence.h"
#include "gpu/Texture.h"

namespace velum::gpu {

/// Bytes on their way from the GPU to the processor: what Readback<T> is made of. GL thread.
class ReadbackRing {
 public:
  struct Arrived {
    const std::byte* bytes = nullptr;  ///< Until the next call of the ring.
    std::size_t count = 0;
    int age = 0;
  };

  /// @param slots  how many reads may be on their way at a time
  ReadbackRing(std::string_view label, int slots);
  /// @return false when all slots are on their way
  bool start(const Buffer& source, std::size_t offset, std::size_t bytes);
  bool start(const Texture& source, glm::ivec3 origin, glm::ivec3 size, int level);
  std::optional<Arrived> poll();
  std::optional<Arrived> finish();
  int inFlight() const;

 private:
  struct Slot {
    Buffer buffer;
    Fence fence;                        ///< Empty while the slot is free.
    const std::byte* mapped = nullptr;  ///< The buffer's bytes, for as long as it lives.
    std::size_t count = 0;
    long turn = 0;  ///< Of the start() that it was taken for.
  };
  Slot* take(std::size_t bytes);
  void hasStarted(Slot& slot);
  std::optional<Arrived> arrivedOf(Slot& slot);

  std::string mLabel;
  std::vector<Slot> mSlots;
  long mTurn = 0;  ///< Counts calls of start().
};

/// What poll() and finish() of a Readback give.
template <class T>
struct ReadbackResult {
  std::vector<T> values;
  int age = 0;  ///< How many times start() has been called since: 0 is the last thing asked for.
};

/// Reads from the GPU without making the processor wait: start() asks for values, poll() in a later frame takes the
/// newest that have arrived. Several may be on their way at a time. What shaders wrote needs gpu::barrier() before
/// start(). GL thread.
template <class T>
class Readback {
 public:
  static_assert(std::is_trivially_copyable_v<T>);
  explicit Readback(std::string_view label, int slots = 3) : mRing(label, slots) {}

  /// Asks for `count` values from the `first` on. What is written into the buffer afterwards is not in them.
  /// @return false when as many reads as there are slots are on their way already: this one is left out
  bool start(const Buffer& source, std::size_t first, std::size_t count) {
    return mRing.start(source, first * sizeof(T), count * sizeof(T));
  }
  /// Asks for a box of texels of a level, tightly packed, x fastest; T as large as a texel.
  bool start(const Texture& source, glm::ivec3 origin, glm::ivec3 size, int level = 0) {
    return mRing.start(source, origin, size, level);
  }
  /// The newest values that have arrived since the last call, if any; older ones are dropped. Never waits.
  std::optional<ReadbackResult<T>> poll() { return resultOf(mRing.poll()); }
  /// Waits for the values asked for last; nothing when none are on their way.
  std::optional<ReadbackResult<T>> finish() { return resultOf(mRing.finish()); }
  int inFlight() const { return mRing.inFlight(); }

 private:
  static std::optional<ReadbackResult<T>> resultOf(const std::optional<ReadbackRing::Arrived>& arrived) {
    if (!arrived) return std::nullopt;
    const T* values = reinterpret_cast<const T*>(arrived->bytes);
    return ReadbackResult<T>{{values, values + arrived->count / sizeof(T)}, arrived->age};
  }
  ReadbackRing mRing;
};

}  // namespace velum::gpu
