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

/// Moves bytes from the GPU to the processor; Readback<T> is made of this. GL thread.
class ReadbackRing {
 public:
  struct Arrived {
    const std::byte* bytes = nullptr;  ///< Valid until the next call of the ring.
    std::size_t count = 0;
    int age = 0;
  };

  /// @param slots  how many reads may be on their way at the same time
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
    const std::byte* mapped = nullptr;  ///< The buffer's bytes; valid as long as the buffer lives.
    std::size_t count = 0;
    long turn = 0;  ///< Number of the start() call that the slot was taken for.
  };
  Slot* take(std::size_t bytes);
  void hasStarted(Slot& slot);
  std::optional<Arrived> arrivedOf(Slot& slot);

  std::string mLabel;
  std::vector<Slot> mSlots;
  long mTurn = 0;  ///< Counts calls of start().
};

/// The values that poll() and finish() of a Readback return.
template <class T>
struct ReadbackResult {
  std::vector<T> values;
  int age = 0;  ///< How many times start() has been called after the call that asked for these values; 0: they are
                ///< those asked for last.
};

/// Reads from the GPU without making the processor wait: start() asks for values, poll() in a later frame returns the
/// newest values that have arrived. Several reads may be on their way at the same time. Where shaders wrote the values,
/// gpu::barrier() must be called before start(). GL thread.
template <class T>
class Readback {
 public:
  static_assert(std::is_trivially_copyable_v<T>);
  explicit Readback(std::string_view label, int slots = 3) : mRing(label, slots) {}

  /// Asks for `count` values from value `first` on. They are the buffer's contents at this point among the GPU's
  /// commands, whatever is written into the buffer afterwards.
  /// @return false when reads are on their way in all slots already: then this call does nothing
  bool start(const Buffer& source, std::size_t first, std::size_t count) {
    return mRing.start(source, first * sizeof(T), count * sizeof(T));
  }
  /// Asks for a box of texels of a level, tightly packed, x fastest; T must have the size of a texel.
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
