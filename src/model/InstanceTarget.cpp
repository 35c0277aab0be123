#include "model/InstanceTarget.h"

#include <algorithm>
#include <span>
#include <string>

#include "shared/bindings.h"
#include "shared/draw.h"
#include "shared/instance.h"

namespace velum::model {

namespace {

constexpr std::size_t kCountBytes = sizeof(std::uint32_t) * shared::kDrawLists;
constexpr std::size_t kCommandBytes = sizeof(shared::DispatchCommand) * shared::kDrawLists;

const gpu::Program& made(gpu::Program& program, std::string_view file, const gpu::Defines& defines = {}) {
  if (!program) program = gpu::Program({file}, defines);
  return program;
}

/// Whether the pyramid is of depths of this frame when a list is drawn.
int hasPyramid(CullPhase phase, bool owners) { return owners || phase == CullPhase::Others ? 1 : 0; }

int groupsOf(std::uint32_t threads) { return int((threads + 63) / 64); }

}  // namespace

gpu::Defines cullDefines(CullBy by, bool isOfSeen) {
  gpu::Defines defines;
  if (by == CullBy::Membranes) defines.emplace_back("MEMBRANES", "1");
  if (by == CullBy::States) defines.emplace_back("STATES", "1");
  if (by == CullBy::Ghosts) defines.emplace_back("GHOSTS", "1");
  if (isOfSeen) defines.emplace_back("SEEN", "1");
  return defines;
}

gpu::Defines focusDefines(bool hasMembranes, bool isOfOccluders) {
  gpu::Defines defines;
  if (hasMembranes) defines.emplace_back("MEMBRANES", "1");
  if (isOfOccluders) defines.emplace_back("OCCLUDERS", "1");
  return defines;
}

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

const gpu::Program& InstancePrograms::cull(CullBy by, bool isOfSeen) {
  return made(mCull[{by, isOfSeen}], "model/cull.comp", cullDefines(by, isOfSeen));
}
const gpu::Program& InstancePrograms::clip(bool hasMembranes) {
  return made(mClip[hasMembranes], "model/clip.comp", focusDefines(hasMembranes, false));
}
const gpu::Program& InstancePrograms::focus(bool hasMembranes, bool isOfOccluders) {
  return made(mFocus[{hasMembranes, isOfOccluders}], "model/focus.comp", focusDefines(hasMembranes, isOfOccluders));
}
const gpu::Program& InstancePrograms::flood() { return made(mFlood, "model/flood.comp"); }
const gpu::Program& InstancePrograms::shown() { return made(mShown, "model/shown.comp"); }
const gpu::Program& InstancePrograms::splat(bool isLarge) {
  return made(mSplat[isLarge], "model/splat.comp", isLarge ? gpu::Defines{{"LARGE", "1"}} : gpu::Defines{});
}
const gpu::Program& InstancePrograms::arguments() { return made(mArguments, "model/arguments.comp"); }
const gpu::Program& InstancePrograms::pyramid() { return made(mPyramid, "model/pyramid.comp"); }
const gpu::Program& InstancePrograms::seen() { return made(mSeen, "model/seen.comp"); }

bool InstancePrograms::compile(const Need& need) {
  std::vector<const gpu::Program*> needed{
      &cull(need.by, true), &cull(need.by, false), &splat(false), &splat(true), &arguments(), &pyramid(), &seen()};
  if (need.by == CullBy::States) needed.insert(needed.end(), {&clip(need.hasMembranes), &shown()});
  if (need.hasFocus)
    needed.insert(needed.end(), {&focus(need.hasMembranes, false), &focus(need.hasMembranes, true), &flood()});
  if (need.hasGhosts) needed.push_back(&cull(CullBy::Ghosts, false));
  return std::all_of(needed.begin(), needed.end(), [](const gpu::Program* program) { return program->isReady(); });
}

void InstanceTarget::resize(glm::ivec2 size, std::uint32_t instances, int copies) {
  std::uint32_t count = instances * std::uint32_t(copies);
  if (instances != mInstances) forget();
  mInstances = instances;
  mCopies = copies;
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
  if (count != mCount) {
    mCount = count;
    // Who owns no pixels is drawn in one phase.
    for (Lists& lists : std::span(mLists).first(mHasOwners ? 2 : 1)) {
      lists.draws =
          gpu::Buffer("draws", std::max<std::size_t>(1, count) * shared::kDrawRooms * sizeof(shared::DrawRow));
      lists.drawTexels = gpu::Texture::makeOfBuffer("draws", gpu::Format::Rg32ui, lists.draws);
      lists.counts = gpu::Buffer("counts of draws", kCountBytes + kCommandBytes);
    }
    mSeen =
        gpu::Buffer("instances seen", (std::size_t(count) + 31) / 32 * sizeof(std::uint32_t) + sizeof(std::uint32_t));
    mNearest = gpu::Buffer("instances that are nearest", mSeen.bytes());
    forget();
  }
}

void InstanceTarget::forget() {
  if (mSeen) mSeen.clear();
}

void InstanceTarget::begin(const shared::InstanceView& view) {
  shared::InstanceView whole = view;
  whole.size = mSize;
  whole.tilesX = mTiles.x;
  whole.tilesY = mTiles.y;
  whole.levelCount = mPyramid.levelCount();
  if (!mView) mView = gpu::Buffer(mLabel, sizeof(whole));
  mView.write(0, sizeof(whole), &whole);
  mDepths.fill(shared::kNoDepth);
  if (mHasOwners) {
    mOwners.fill(shared::kNoInstance);
    mBalls.fill(shared::kNoInstance);
  }
  for (Lists& lists : mLists)
    if (lists.counts) lists.counts.clear();
  mNearest.clear();
}

void InstanceTarget::bindView(unsigned binding) const { mView.bindUniform(binding); }

void InstanceTarget::bindOwners() const {
  mOwners.bindStorage(shared::kOwnerBinding);
  mBalls.bindStorage(shared::kBallBinding);
}

void InstanceTarget::bindLists(const Lists& lists) const {
  bindView(shared::kInstanceViewBinding);
  lists.counts.bindStorage(shared::kCountBinding);
}

std::vector<InstancePart> InstanceTarget::partsOf(CullPhase phase, std::uint32_t most) const {
  if (phase == CullPhase::SeenBefore) return instanceParts((mCount + 31) / 32, 1, most);
  return instanceParts(mInstances, mCopies, most);
}

void InstanceTarget::cull(InstancePrograms& programs, CullBy by, CullPhase phase, const InstancePart& part) {
  const Lists& lists = listsOf(phase);
  bindLists(lists);
  lists.drawTexels.bindImage(shared::kDrawImage, gpu::Access::Write);
  mSeen.bindStorage(shared::kSeenBinding);
  mPyramid.bindSampler(shared::kPyramidUnit);
  bindDepths(shared::kDepthUnit);
  const gpu::Program& program = programs.cull(by, phase == CullPhase::SeenBefore);
  program.set(0, static_cast<int>(phase));
  program.set(1, int(part.first));
  program.set(2, int(part.end));
  if (phase != CullPhase::SeenBefore) program.set(3, part.firstCopy);
  gpu::dispatch(program, {groupsOf(part.end - part.first), part.copies, 1});
}

void InstanceTarget::closeLists(InstancePrograms& programs, CullPhase phase) {
  gpu::barrier();
  bindLists(listsOf(phase));
  gpu::dispatch(programs.arguments(), {1, 1, 1});
  gpu::barrier();
}

std::array<std::uint32_t, 4> InstanceTarget::groupCounts(CullPhase phase) const {
  std::array<shared::DispatchCommand, shared::kDrawLists> commands;
  listsOf(phase).counts.read(kCountBytes, kCommandBytes, commands.data());
  std::array<std::uint32_t, 4> groups;
  for (std::size_t i = 0; i < groups.size(); ++i) groups[i] = commands[i].groupsX * commands[i].groupsY;
  return groups;
}

void InstanceTarget::drawList(InstancePrograms& programs, CullPhase phase, int list, bool owners) {
  const Lists& lists = listsOf(phase);
  bindLists(lists);
  lists.drawTexels.bindSampler(shared::kDrawUnit);
  mDepths.bindStorage(shared::kDepthBinding);
  mNearest.bindStorage(shared::kSeenBinding);
  bindDepths(shared::kDepthUnit);
  mPyramid.bindSampler(shared::kPyramidUnit);
  if (mHasOwners) bindOwners();
  const gpu::Program& program = programs.splat(list == shared::kDrawLarge);
  program.set(0, list);
  program.set(1, owners ? 1 : 0);
  program.set(2, 0);
  program.set(3, hasPyramid(phase, owners));
  gpu::dispatchIndirect(program, lists.counts, list + int(kCountBytes / sizeof(shared::DispatchCommand)));
}

void InstanceTarget::drawGroups(InstancePrograms& programs, CullPhase phase, int list, bool owners, std::uint32_t first,
                                std::uint32_t count) {
  const Lists& lists = listsOf(phase);
  bindLists(lists);
  lists.drawTexels.bindSampler(shared::kDrawUnit);
  mDepths.bindStorage(shared::kDepthBinding);
  mNearest.bindStorage(shared::kSeenBinding);
  bindDepths(shared::kDepthUnit);
  mPyramid.bindSampler(shared::kPyramidUnit);
  if (mHasOwners) bindOwners();
  const gpu::Program& program = programs.splat(list == shared::kDrawLarge);
  program.set(0, list);
  program.set(1, owners ? 1 : 0);
  program.set(2, int(first));
  program.set(3, hasPyramid(phase, owners));
  int parts = list == shared::kDrawLarge ? shared::kLargeParts : 1;
  gpu::dispatchLine(program, count, parts);
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
