#include "gpu/Readback.h"

#include <algorithm>

#include "gpu/GpuError.h"

namespace velum::gpu {

namespace {
/// A driver that does not answer for so long has hung.
constexpr double kLongestWaitMs = 60e3;
}  // namespace

ReadbackRing::ReadbackRing(std::string_view label, int slots)
    : mLabel(label), mSlots(std::size_t(std::max(1, slots))) {}

/// A free slot with room for so many bytes, or none.
ReadbackRing::Slot* ReadbackRing::take(std::size_t bytes) {
  ++mTurn;
  auto free = std::find_if(mSlots.begin(), mSlots.end(), [](const Slot& slot) { return !slot.fence; });
  if (free == mSlots.end()) return nullptr;
  if (free->buffer.bytes() < bytes) {
    free->buffer = Buffer::makeReadable(mLabel, bytes);
    free->mapped = free->buffer.mapped();
  }
  free->count = bytes;
  return &*free;
}

void ReadbackRing::hasStarted(Slot& slot) {
  slot.turn = mTurn;
  slot.fence = Fence(mLabel);
}

bool ReadbackRing::start(const Buffer& source, std::size_t offset, std::size_t bytes) {
  Slot* slot = take(bytes);
  if (!slot) return false;
  source.copyTo(slot->buffer, 0, offset, bytes);
  hasStarted(*slot);
  return true;
}

bool ReadbackRing::start(const Texture& source, glm::ivec3 origin, glm::ivec3 size, int level) {
  std::size_t bytes = std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z) * texelBytes(source.format());
  Slot* slot = take(bytes);
  if (!slot) return false;
  source.copyTo(slot->buffer, origin, size, level);
  hasStarted(*slot);
  return true;
}

/// Hands out a slot's bytes, and frees it with all that were started before it.
std::optional<ReadbackRing::Arrived> ReadbackRing::arrivedOf(Slot& slot) {
  for (Slot& other : mSlots)
    if (other.turn <= slot.turn) other.fence = Fence();
  return Arrived{slot.mapped, slot.count, int(mTurn - slot.turn)};
}

std::optional<ReadbackRing::Arrived> ReadbackRing::poll() {
  Slot* newest = nullptr;
  for (Slot& slot : mSlots)
    if (slot.fence && (!newest || slot.turn > newest->turn) && slot.fence.isSignalled()) newest = &slot;
  return newest ? arrivedOf(*newest) : std::nullopt;
}

std::optional<ReadbackRing::Arrived> ReadbackRing::finish() {
  Slot* last = nullptr;
  for (Slot& slot : mSlots)
    if (slot.fence && (!last || slot.turn > last->turn)) last = &slot;
  if (!last) return std::nullopt;
  if (!last->fence.wait(kLongestWaitMs)) throw GpuError("the driver does not answer: update it, or restart");
  return arrivedOf(*last);
}

int ReadbackRing::inFlight() const {
  return int(std::count_if(mSlots.begin(), mSlots.end(), [](const Slot& slot) { return bool(slot.fence); }));
}

}  // namespace velum::gpu
