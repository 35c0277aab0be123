#include "render/Shortage.h"

#include <algorithm>
#include <utility>

#include "scene/Scene.h"

namespace velum::render {

namespace {

constexpr double kLeastBytes = 1 << 16;          // less than that is no picture of anything
constexpr double kVoxelBytes = 16;               // more than a voxel takes, with its gradient
constexpr double kMostBytes = 8.0 * (1u << 30);  // a quarter of that is as much as bricks are given unasked
constexpr double kBrickShare = 0.7;              // of all memory, that may be asked for for bricks

std::uint64_t volumeOf(const Frame& frame) { return frame.scene.volume.visible ? frame.scene.volume.data.id() : 0; }

/// The memory of a card of which the frame's volume takes as much as it can.
double mostBytes(const Frame& frame) {
  const scene::VolumeLayer& layer = frame.scene.volume;
  if (layer.data->finer) return frame.brickBytes > 0 ? frame.brickBytes / kBrickShare : kMostBytes;
  glm::dvec3 dims(layer.data->dims);
  return layer.smooth ? kMostBytes : kVoxelBytes * dims.x * dims.y * dims.z;
}

}  // namespace

gpu::Limits Shortage::limits() const {
  gpu::Limits limits = mDriver;
  if (mBytes > 0) limits.memoryBytes = mBytes;
  return limits;
}

bool Shortage::endsFor(const Frame& frame) {
  if (mBytes == 0 || volumeOf(frame) == mVolume) return false;
  takeRefusal();
  return true;
}

bool Shortage::yield(const Frame& frame, int framesBegun, const gpu::NoMemory& refusal) {
  if (framesBegun > 1) return true;
  mVolume = volumeOf(frame);
  double now = mBytes > 0 ? double(mBytes) : mVolume == 0 ? 0 : std::min(double(mDriver.memoryBytes), mostBytes(frame));
  if (now / 2 < kLeastBytes) return false;
  if (!mRefusal) mRefusal = refusal;
  mBytes = std::size_t(now / 2);
  return true;
}

std::optional<gpu::NoMemory> Shortage::takeRefusal() {
  mBytes = 0;
  return std::exchange(mRefusal, std::nullopt);
}

}  // namespace velum::render
