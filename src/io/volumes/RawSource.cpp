#include "io/volumes/RawSource.h"

#include <algorithm>
#include <bit>

#include "io/read/Placement.h"
#include "io/read/SampleBytes.h"

namespace velum::io {

namespace {

constexpr std::size_t kMostOpenFiles = 16;

}  // namespace

int rowsOfBrick(glm::ivec3 dims, int unit, std::size_t voxelBytes) {
  std::size_t unitBytes = std::size_t(dims.x) * std::size_t(unit) * voxelBytes;
  std::size_t units = std::bit_floor(std::max<std::size_t>(1, kSlabBytes / unitBytes));
  return int(std::min(std::size_t(dims.y), units * std::size_t(unit)));
}

int planesOfBrick(int planes, std::size_t planeBytes) {
  std::size_t most = std::bit_floor(std::max<std::size_t>(1, kSlabBytes / planeBytes));
  return int(std::min(std::size_t(planes), most));
}

RawSource::RawSource(UnreadVolume unread) : mUnread(std::move(unread)) {
  const Volume& head = mUnread.head;
  const Layout& layout = mUnread.layout;
  mPartBytes = layoutBytes(layout, mUnread.header) / mUnread.parts.size();
  bool isTogether = layout.channelOrder == ChannelOrder::Together || head.channels == 1;
  // Where each axis steps to in the file, from the fastest to the slowest.
  std::uint64_t step = sampleSize(head.type);
  auto take = [&](std::uint64_t& axis, int count) {
    axis = step;
    step *= std::uint64_t(count);
  };
  if (isTogether) take(mSteps.channel, head.channels);
  take(mSteps.x, head.dims.x);
  take(mSteps.y, head.dims.y);
  if (!isTogether && layout.channelOrder == ChannelOrder::Planes) take(mSteps.channel, head.channels);
  take(mSteps.z, head.dims.z);
  take(mSteps.timeStep, head.timeSteps);
  if (!isTogether && layout.channelOrder == ChannelOrder::Volumes) take(mSteps.channel, head.channels);
  // Bricks: stretches of the file of about a megabyte.
  VoxelLevel level;
  level.dims = head.dims;
  level.worldFromVoxel = head.worldFromVoxel;
  level.brickChannels = isTogether ? head.channels : 1;
  std::size_t voxel = mSteps.x, rowVoxels = std::max<std::size_t>(1, kSlabBytes / voxel);
  level.brickSize.x = int(std::min(std::size_t(head.dims.x), rowVoxels));
  if (level.brickSize.x == head.dims.x) level.brickSize.y = rowsOfBrick(head.dims, 1, voxel);
  if (level.brickSize.y == head.dims.y && level.brickSize.x == head.dims.x)
    level.brickSize.z = planesOfBrick(head.dims.z, mSteps.y * std::size_t(head.dims.y));
  mLevels = {level};
  if (mUnread.parts.size() > kMostOpenFiles) return;
  for (const Payload& part : mUnread.parts) mFiles.push_back(std::make_unique<FileBytes>(part.file));
}

void RawSource::read(const BrickAddress& address, const SampleTarget& target) const {
  BrickBox box = boxOf(*this, address);
  glm::ivec3 dims = mUnread.head.dims;
  std::size_t sample = sampleSize(mUnread.head.type);
  std::size_t row = std::size_t(box.size.x) * mSteps.x, plane = row * std::size_t(box.size.y);
  // Read what lies together at once.
  thread_local Bytes samples;
  samples.resize(plane * std::size_t(box.size.z));
  bool hasWholeRows = box.size.x == dims.x;
  bool hasWholePlanes = hasWholeRows && box.size.y == dims.y && mSteps.z == plane;
  std::size_t run = hasWholePlanes ? samples.size() : hasWholeRows ? plane : row;
  std::uint64_t first = std::uint64_t(box.origin.x) * mSteps.x + std::uint64_t(box.channel) * mSteps.channel +
                        std::uint64_t(box.timeStep) * mSteps.timeStep;
  for (std::size_t done = 0; done < samples.size(); done += run) {
    std::uint64_t z = std::uint64_t(box.origin.z) + done / plane, y = std::uint64_t(box.origin.y) + done % plane / row;
    readAt(first + z * mSteps.z + y * mSteps.y, std::span(samples).subspan(done, run));
  }
  toMachineOrder(samples, sample, mUnread.layout.bigEndian);
  // Put them where they belong.
  SampleTarget from;
  from.first = samples.data();
  from.x = std::ptrdiff_t(mSteps.x);
  from.y = std::ptrdiff_t(row);
  from.z = std::ptrdiff_t(plane);
  from.channel = std::ptrdiff_t(mSteps.channel);  // within a voxel, or of one channel alone
  copySamples(box, sample, from, target);
}

/// @param at  a byte of all samples, as if the parts were one
void RawSource::readAt(std::uint64_t at, std::span<std::byte> to) const {
  while (!to.empty()) {
    std::size_t number = std::size_t(at / mPartBytes);
    const Payload& part = mUnread.parts[number];
    std::uint64_t inPart = at % mPartBytes;
    auto piece = to.first(std::size_t(std::min<std::uint64_t>(to.size(), mPartBytes - inPart)));
    if (mFiles.empty())
      FileBytes(part.file).read(part.offset + part.skip + inPart, piece);
    else
      mFiles[number]->read(part.offset + part.skip + inPart, piece);
    to = to.subspan(piece.size());
    at += piece.size();
  }
}

std::string RawSource::identity() const {
  std::string stamps = stampOf(mUnread.header);
  for (const Payload& part : mUnread.parts) stamps += "\n" + stampOf(part.file);
  return stamps;
}

std::unique_ptr<VoxelSource> openSamples(UnreadVolume unread, const scene::Source& source) {
  bool isWide = unread.layout.type == StoredType::Int64 || unread.layout.type == StoredType::UInt64;
  bool isPlain = std::all_of(unread.parts.begin(), unread.parts.end(),
                             [](const Payload& part) { return part.packing == Packing::Raw; });
  if (isWide || !isPlain) return nullptr;
  // Parts that are cut off are told of now, not in the middle of the work.
  std::uint64_t each = layoutBytes(unread.layout, unread.header) / unread.parts.size();
  for (const Payload& part : unread.parts) {
    std::uint64_t size = sizeOfFile(part.file), have = size - std::min(size, part.offset + part.skip);
    if (have < each) refuse(part.file, "is cut off: " + std::to_string(each - have) + " bytes of data are missing");
  }
  completeHead(unread.head, source);
  return std::make_unique<RawSource>(std::move(unread));
}

}  // namespace velum::io
