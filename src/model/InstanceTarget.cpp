#include "model/InstanceTarget.h"

#include <algorithm>
#include <string>

#include "gpu/Strided.h"
#include "shared/bindings.h"
#include "shared/draw.h"
#include "shared/instance.h"

namespace velum::model {

namespace {

constexpr std::size_t kCountBytes = sizeof(std::uint32_t) * shared::kDrawLists;
constexpr std::size_t kCommandBytes = sizeof(shared::DispatchCommand) * shared::kDrawLists;

constexpr std::uint32_t kWord = 32;  // instances
constexpr int kFirstRound = 8;       // copies
constexpr std::size_t kBundleHead = 4 * sizeof(std::uint32_t);

int groupsOf(std::uint32_t threads) { return int((threads + 63) / 64); }

}  // namespace

std::vector<InstancePart> instanceParts(std::uint32_t instances, int copies, std::uint32_t most) {
  std::vector<InstancePart> parts;
  // A thread an instance along x, a copy a row of groups.
  most = std::min(most, std::uint32_t(gpu::kMostGroups * shared::kInstanceGroup));
  int atATime = std::clamp(int(most / std::max(1u, instances)), 1, std::min(copies, gpu::kMostGroups));
  for (int copy = 0; copy < copies; copy += atATime)
    for (std::uint32_t first = 0; first < instances; first += std::min(most, instances - first))
      parts.push_back({first, std::min(instances, first + most), copy, std::min(atATime, copies - copy)});
  return parts;
}

std::vector<std::pair<int, int>> copyRounds(int copies, int most) {
  std::vector<std::pair<int, int>> rounds;
  for (int first = 0, count = kFirstRound; first < copies;
       first = rounds.back().second, count = std::min(2 * count, most))
    rounds.emplace_back(first, std::min(copies, first + count));
  return rounds;
}

std::uint32_t InstanceTarget::bundlesOfCopy() const {
  return (mInstances.instances + std::uint32_t(shared::kBundle) - 1) / std::uint32_t(shared::kBundle);
}

void InstanceTarget::resize(glm::ivec2 size, const InstanceRoom& instances, std::uint32_t room) {
  std::uint32_t count = instances.count();
  if (size != mSize) {
    mSize = size;
    std::size_t bytes = std::size_t(size.x) * std::size_t(size.y) * sizeof(std::uint32_t);
    mDepths = gpu::Buffer("depths of instances", bytes);
    mDepthTexels = gpu::Texture::makeOfBuffer("depths of instances", gpu::Format::R32ui, mDepths);
    if (mHasOwners) {
      mOwners = gpu::Buffer("instances of pixels", bytes);
      mBalls = gpu::Buffer("balls of pixels", bytes);
    }
    mTiles = (size + shared::kPyramidTile - 1) / shared::kPyramidTile;
    mPyramid = gpu::Texture::make2d("farthest depths", gpu::Format::R32f, mTiles, gpu::Filter::Nearest,
                                    gpu::levelCountOf({mTiles, 1}));
  }
  constexpr auto kWhole = std::uint32_t(shared::kBundle);
  room = std::max(std::min(room, count + kWhole - 1) / kWhole * kWhole, kWhole);
  if (room != mRoom) {
    mRoom = room;
    mDraws = gpu::Buffer("draws", std::size_t(room) * shared::kDrawRooms * sizeof(shared::DrawRow));
    mDrawTexels = gpu::Texture::makeOfBuffer("draws", gpu::Format::Rg32ui, mDraws);
  }
  if (!mCounts) mCounts = gpu::Buffer("counts of draws", kCountBytes + kCommandBytes);
  if (mSeen && instances == mInstances) return;
  mInstances = instances;
  mBundles =
      gpu::Buffer("bundles that may show", kBundleHead + std::size_t(bundlesOfCopy()) * std::size_t(instances.slots) *
                                                             sizeof(shared::BundleRow));
  mOrder = gpu::Buffer("copies", 2 * std::size_t(instances.slots) * sizeof(std::uint32_t));
  mBlocks = {};
  mSeen = gpu::Buffer("instances seen", (std::size_t(count) + 31) / 32 * sizeof(std::uint32_t) + sizeof(std::uint32_t));
  mNearest = gpu::Buffer("instances that are nearest", mSeen.bytes());
  forget();
}

void InstanceTarget::forget() {
  if (mSeen) mSeen.clear();
  if (mNearest) mNearest.clear();
}

void InstanceTarget::begin(const shared::InstanceView& view, const std::vector<std::uint32_t>& slots,
                           const std::vector<std::uint32_t>& blocks) {
  shared::InstanceView whole = view;
  whole.size = mSize;
  whole.tilesX = mTiles.x;
  whole.tilesY = mTiles.y;
  whole.levelCount = mPyramid.levelCount();
  whole.drawRoom = int(mRoom);
  if (!mView) mView = gpu::Buffer(mLabel, sizeof(whole));
  mView.write(0, sizeof(whole), &whole);
  mDepths.fill(shared::kNoDepth);
  if (mHasOwners) {
    mOwners.fill(shared::kNoInstance);
    mBalls.fill(shared::kNoInstance);
  }
  mSlots = int(slots.size());
  if (mSlots > 0) mOrder.write(0, slots.size() * sizeof(slots[0]), slots.data());
  mBlockCount = int(blocks.size());
  std::size_t bytes = blocks.size() * sizeof(std::uint32_t);
  if (mBlocks.bytes() < 2 * bytes) mBlocks = gpu::Buffer("blocks of copies", 2 * bytes);
  if (mBlockCount > 0) mBlocks.write(0, bytes, blocks.data());
  if (!mHasOwners) std::swap(mSeen, mNearest);
  mNearest.clear();
}

void InstanceTarget::bindView(unsigned binding) const { mView.bindUniform(binding); }

void InstanceTarget::bindOwners() const {
  mOwners.bindStorage(shared::kOwnerBinding);
  mBalls.bindStorage(shared::kBallBinding);
}

void InstanceTarget::bindCounts() const {
  bindView(shared::kInstanceViewBinding);
  mCounts.bindStorage(shared::kCountBinding);
}

/// Empties the lists of copies, or blocks, and of bundles.
void InstanceTarget::emptyBundles() {
  std::array<std::uint32_t, kBundleHead / sizeof(std::uint32_t)> none{};
  mBundles.write(0, kBundleHead, none.data());
}

/// Looks at some of what may be listed.
void InstanceTarget::look(InstancePrograms& programs, ListOf of, glm::ivec2 groups, int first, int end) const {
  bindView(shared::kInstanceViewBinding);
  mBundles.bindStorage(shared::kBundleBinding);
  (of == ListOf::Blocks ? mBlocks : mOrder).bindStorage(shared::kCopyBinding);
  mPyramid.bindSampler(shared::kPyramidUnit);
  bindDepths(shared::kDepthUnit);
  const gpu::Program& program = programs.bundles(of);
  program.set(0, first);
  program.set(1, end);
  program.set(2, of == ListOf::Blocks ? mBlockCount : mInstances.slots);
  gpu::dispatch(program, {groups, 1});
  gpu::barrier();
}

void InstanceTarget::listCopies(InstancePrograms& programs, int first, int end) {
  emptyBundles();
  look(programs, ListOf::Copies, {groupsOf(std::uint32_t(end - first)), 1}, first, end);
}

void InstanceTarget::listBlocks(InstancePrograms& programs, int first, int end) {
  emptyBundles();
  look(programs, ListOf::Blocks, {groupsOf(std::uint32_t(end - first)), 1}, first, end);
}

int InstanceTarget::listedCopies() const {
  std::uint32_t count = 0;
  mBundles.read(0, sizeof(count), &count);
  return int(count);
}

void InstanceTarget::listBundles(InstancePrograms& programs, int first, int end) {
  look(programs, ListOf::Bundles, {groupsOf(bundlesOfCopy()), end - first}, first, end);
}

std::uint32_t InstanceTarget::listedBundles() const {
  std::uint32_t count = 0;
  mBundles.read(sizeof(count), sizeof(count), &count);
  return count;
}

std::uint32_t InstanceTarget::itemsOf(CullPhase phase, int listed) const {
  if (phase == CullPhase::Others) return bundlesOfCopy() * std::uint32_t(listed);
  if (phase == CullPhase::OtherWholes) return std::uint32_t(listed);
  std::uint32_t instances =
      isOfWholes(phase) ? std::uint32_t(mInstances.wholes) : mInstances.instances * std::uint32_t(mSlots);
  return (instances + kWord - 1) / kWord;
}

std::uint32_t InstanceTarget::itemsOfList(CullPhase phase) const {
  return mRoom / (isOfOthers(phase) ? std::uint32_t(shared::kBundle) : kWord);
}

void InstanceTarget::openList() { mCounts.clear(); }

void InstanceTarget::cull(InstancePrograms& programs, CullBy by, CullPhase phase, std::uint32_t first,
                          std::uint32_t end) {
  bindCounts();
  mDrawTexels.bindImage(shared::kDrawImage, gpu::Access::Write);
  (isOfNearest(phase) ? mNearest : mSeen).bindStorage(shared::kSeenBinding);
  mBundles.bindStorage(shared::kBundleBinding);
  mPyramid.bindSampler(shared::kPyramidUnit);
  bindDepths(shared::kDepthUnit);
  bool isOfWords = !isOfOthers(phase);
  const gpu::Program& program = isOfWholes(phase) ? programs.cullWholes(isOfWords)
                                                  : programs.cull(isOfNearest(phase) ? CullBy::Nearest : by, isOfWords);
  std::uint32_t from = isOfWholes(phase) && isOfWords ? mInstances.firstWhole() / kWord : 0;
  program.set(0, int(from + first));
  program.set(1, int(from + end));
  if (phase == CullPhase::OtherWholes) {
    mBlocks.bindStorage(shared::kCopyBinding);
    program.set(2, mBlockCount);
  }
  gpu::dispatchLine(program, isOfWords ? std::uint32_t(groupsOf(end - first)) : end - first);
}

void InstanceTarget::closeList(InstancePrograms& programs) {
  gpu::barrier();
  bindCounts();
  gpu::dispatch(programs.arguments(), {1, 1, 1});
  gpu::barrier();
}

std::array<std::uint32_t, 4> InstanceTarget::groupCounts() const {
  std::array<shared::DispatchCommand, shared::kDrawLists> commands;
  mCounts.read(kCountBytes, kCommandBytes, commands.data());
  std::array<std::uint32_t, 4> groups;
  for (std::size_t i = 0; i < groups.size(); ++i) groups[i] = commands[i].groupsX * commands[i].groupsY;
  return groups;
}

const gpu::Program& InstanceTarget::bindDraws(InstancePrograms& programs, const Draws& draws,
                                              std::uint32_t first) const {
  bindCounts();
  mDrawTexels.bindSampler(shared::kDrawUnit);
  mDepths.bindStorage(shared::kDepthBinding);
  mNearest.bindStorage(shared::kSeenBinding);
  bindDepths(shared::kDepthUnit);
  mPyramid.bindSampler(shared::kPyramidUnit);
  if (mHasOwners) bindOwners();
  const gpu::Program& program = programs.splat(draws.of, draws.list == shared::kDrawLarge);
  program.set(0, draws.list);
  program.set(1, isOfNearest(draws.phase) ? 1 : 0);
  program.set(2, int(first));
  program.set(3, isOfSeen(draws.phase) ? 0 : 1);
  return program;
}

void InstanceTarget::drawList(InstancePrograms& programs, const Draws& draws) {
  const gpu::Program& program = bindDraws(programs, draws, 0);
  program.set(4, glm::ivec2(0));
  gpu::dispatchIndirect(program, mCounts, draws.list + int(kCountBytes / sizeof(shared::DispatchCommand)));
}

void InstanceTarget::drawGroups(InstancePrograms& programs, const Draws& draws, std::uint32_t first,
                                std::uint32_t count) {
  const gpu::Program& program = bindDraws(programs, draws, first);
  // Some groups of the next piece may be drawn twice, which changes nothing.
  gpu::Strided order = gpu::stridedGroups(int(count));
  program.set(4, glm::ivec2(order.count, order.stride));
  gpu::dispatchLine(program, std::uint32_t(order.count), draws.list == shared::kDrawLarge ? shared::kLargeParts : 1);
}

void InstanceTarget::makePyramid(InstancePrograms& programs) {
  gpu::barrier();
  bindView(shared::kInstanceViewBinding);
  bindDepths(shared::kDepthUnit);
  mPyramid.bindSampler(shared::kPyramidUnit);
  const gpu::Program& program = programs.pyramid();
  for (int level = 0; level < mPyramid.levelCount(); ++level) {
    glm::ivec2 size(mPyramid.size(level));
    mPyramid.bindImage(shared::kPyramidImage, gpu::Access::Write, level);
    program.set(0, level);
    gpu::dispatch(program, {(size.x + 7) / 8, (size.y + 7) / 8, 1});
    gpu::barrier();
  }
}

void InstanceTarget::noteSeen(InstancePrograms& programs) {
  gpu::barrier();
  mSeen.clear();
  bindOwners();
  mSeen.bindStorage(shared::kSeenBinding);
  const gpu::Program& program = programs.seen();
  program.set(0, mSize.x * mSize.y);
  gpu::dispatchLine(program, std::uint32_t(groupsOf(std::uint32_t(mSize.x) * std::uint32_t(mSize.y))));
  gpu::barrier();
}

}  // namespace velum::model
