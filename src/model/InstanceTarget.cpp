#include "model/InstanceTarget.h"

#include <algorithm>
#include <numeric>
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

/// The copies of a view, the nearest first.
std::vector<std::uint32_t> copiesByDepth(const shared::InstanceView& view) {
  std::vector<std::uint32_t> order(std::size_t(view.copies));
  std::iota(order.begin(), order.end(), 0u);
  std::vector<float> depths;
  for (int copy = 0; copy < view.copies; ++copy) {
    int line = copy / view.copiesX;
    glm::vec3 at(copy % view.copiesX, line % view.copiesY, line / view.copiesY);
    glm::vec3 q = glm::vec3(view.copySphere) + at * glm::vec3(view.copyStep) - glm::vec3(view.eye);
    depths.push_back(view.isOrthographic != 0 ? glm::dot(q, glm::vec3(view.forward)) : glm::length(q));
  }
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return depths[a] < depths[b]; });
  return order;
}

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

std::vector<std::pair<int, int>> copyRounds(int copies) {
  std::vector<std::pair<int, int>> rounds;
  for (int first = 0, count = kFirstRound; first < copies; first = rounds.back().second, count *= 2)
    rounds.emplace_back(first, std::min(copies, first + count));
  return rounds;
}

std::uint32_t InstanceTarget::bundlesOfCopy() const {
  return (mInstances + std::uint32_t(shared::kBundle) - 1) / std::uint32_t(shared::kBundle);
}

void InstanceTarget::resize(glm::ivec2 size, std::uint32_t instances, int copies, std::uint32_t room) {
  std::uint32_t count = instances * std::uint32_t(copies);
  if (instances != mInstances) forget();
  mInstances = instances;
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
  if (count != mCount || copies != mCopies) {
    mCount = count;
    mCopies = copies;
    mBundles = gpu::Buffer("bundles that may show", kBundleHead + std::size_t(bundlesOfCopy()) * std::size_t(copies) *
                                                                      sizeof(shared::BundleRow));
    mOrder = gpu::Buffer("copies", 2 * std::size_t(copies) * sizeof(std::uint32_t));
    mSeen =
        gpu::Buffer("instances seen", (std::size_t(count) + 31) / 32 * sizeof(std::uint32_t) + sizeof(std::uint32_t));
    mNearest = gpu::Buffer("instances that are nearest", mSeen.bytes());
    forget();
  }
}

void InstanceTarget::forget() {
  if (mSeen) mSeen.clear();
  if (mNearest) mNearest.clear();
}

void InstanceTarget::begin(const shared::InstanceView& view) {
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
  auto order = copiesByDepth(view);
  mOrder.write(0, order.size() * sizeof(order[0]), order.data());
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

const gpu::Program& InstanceTarget::bindBundles(InstancePrograms& programs, bool isOfCopies) const {
  bindView(shared::kInstanceViewBinding);
  mBundles.bindStorage(shared::kBundleBinding);
  mOrder.bindStorage(shared::kCopyBinding);
  mPyramid.bindSampler(shared::kPyramidUnit);
  bindDepths(shared::kDepthUnit);
  return programs.bundles(isOfCopies);
}

void InstanceTarget::listCopies(InstancePrograms& programs, int first, int end) {
  std::array<std::uint32_t, kBundleHead / sizeof(std::uint32_t)> none{};
  mBundles.write(0, kBundleHead, none.data());
  const gpu::Program& program = bindBundles(programs, true);
  program.set(0, first);
  program.set(1, end);
  gpu::dispatch(program, {groupsOf(std::uint32_t(end - first)), 1, 1});
  gpu::barrier();
}

int InstanceTarget::listedCopies() const {
  std::uint32_t count = 0;
  mBundles.read(0, sizeof(count), &count);
  return int(count);
}

void InstanceTarget::listBundles(InstancePrograms& programs, int first, int end) {
  const gpu::Program& program = bindBundles(programs, false);
  program.set(0, first);
  program.set(1, end);
  gpu::dispatch(program, {groupsOf(bundlesOfCopy()), end - first, 1});
  gpu::barrier();
}

std::uint32_t InstanceTarget::listedBundles() const {
  std::uint32_t count = 0;
  mBundles.read(sizeof(count), sizeof(count), &count);
  return count;
}

std::uint32_t InstanceTarget::itemsOf(CullPhase phase, int listedCopies) const {
  return phase == CullPhase::Others ? bundlesOfCopy() * std::uint32_t(listedCopies) : (mCount + kWord - 1) / kWord;
}

std::uint32_t InstanceTarget::itemsOfList(CullPhase phase) const {
  return mRoom / (phase == CullPhase::Others ? std::uint32_t(shared::kBundle) : kWord);
}

void InstanceTarget::openList() { mCounts.clear(); }

void InstanceTarget::cull(InstancePrograms& programs, CullBy by, CullPhase phase, std::uint32_t first,
                          std::uint32_t end) {
  bindCounts();
  mDrawTexels.bindImage(shared::kDrawImage, gpu::Access::Write);
  (phase == CullPhase::Nearest ? mNearest : mSeen).bindStorage(shared::kSeenBinding);
  mBundles.bindStorage(shared::kBundleBinding);
  mPyramid.bindSampler(shared::kPyramidUnit);
  bindDepths(shared::kDepthUnit);
  bool isOfWords = phase != CullPhase::Others;
  const gpu::Program& program = programs.cull(phase == CullPhase::Nearest ? CullBy::Nearest : by, isOfWords);
  program.set(0, int(first));
  program.set(1, int(end));
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

const gpu::Program& InstanceTarget::bindDraws(InstancePrograms& programs, CullPhase phase, int list,
                                              std::uint32_t first) const {
  bindCounts();
  mDrawTexels.bindSampler(shared::kDrawUnit);
  mDepths.bindStorage(shared::kDepthBinding);
  mNearest.bindStorage(shared::kSeenBinding);
  bindDepths(shared::kDepthUnit);
  mPyramid.bindSampler(shared::kPyramidUnit);
  if (mHasOwners) bindOwners();
  const gpu::Program& program = programs.splat(list == shared::kDrawLarge);
  program.set(0, list);
  program.set(1, phase == CullPhase::Nearest ? 1 : 0);
  program.set(2, int(first));
  program.set(3, phase == CullPhase::SeenBefore ? 0 : 1);
  return program;
}

void InstanceTarget::drawList(InstancePrograms& programs, CullPhase phase, int list) {
  const gpu::Program& program = bindDraws(programs, phase, list, 0);
  program.set(4, glm::ivec2(0));
  gpu::dispatchIndirect(program, mCounts, list + int(kCountBytes / sizeof(shared::DispatchCommand)));
}

void InstanceTarget::drawGroups(InstancePrograms& programs, CullPhase phase, int list, std::uint32_t first,
                                std::uint32_t count) {
  const gpu::Program& program = bindDraws(programs, phase, list, first);
  // Some groups of the next piece may be drawn twice, which changes nothing.
  gpu::Strided order = gpu::stridedGroups(int(count));
  program.set(4, glm::ivec2(order.count, order.stride));
  gpu::dispatchLine(program, std::uint32_t(order.count), list == shared::kDrawLarge ? shared::kLargeParts : 1);
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
