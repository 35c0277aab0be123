#include "render/passes/InstanceDraw.h"

#include <algorithm>
#include <utility>

#include "model/CopyBlocks.h"
#include "shared/instance.h"

namespace velum::render {

void InstanceDraw::add(WorkQueue& queue, WorkQueue::Run run) {
  queue.add(mPass, [this, run = std::move(run)] {
    mPace.handOver(0, 0);
    run();
  });
}

void InstanceDraw::addDepths(model::InstanceTarget& target, const shared::InstanceView& view, model::CullBy by,
                             WorkQueue& queue) {
  std::vector<std::uint32_t> blocks;
  if (hasWholes(view, by)) {
    shared::InstanceView sized = view;
    sized.size = target.size();
    blocks = model::blocksInView(sized).blocks;
  }
  auto rounds = model::copyRounds(int(blocks.size()), target.mostBlocks());
  add(queue,
      [this, &target, view, blocks = std::move(blocks)] { target.begin(view, mModel.copies().byDepth(view), blocks); });
  addPhase(target, by, Phase::SeenBefore, queue);
  if (!rounds.empty()) addPhase(target, by, Phase::SeenWholes, queue);
  addPyramid(target, queue);
  for (const auto& copies : model::copyRounds(view.copies)) addRound(target, by, copies, queue);
  for (const auto& round : rounds) addWholeRound(target, by, round, queue);
}

bool InstanceDraw::hasWholes(const shared::InstanceView& view, model::CullBy by) {
  return view.firstWhole != shared::kNoInstance && by != model::CullBy::Ghosts;
}

void InstanceDraw::addOwners(model::InstanceTarget& target, bool hasWholes, WorkQueue& queue) {
  addPhase(target, model::CullBy::Nearest, Phase::Nearest, queue);
  if (hasWholes) addPhase(target, model::CullBy::Nearest, Phase::NearestWholes, queue);
}

/// Draws what may show of some blocks of copies as wholes.
void InstanceDraw::addWholeRound(model::InstanceTarget& target, model::CullBy by, std::pair<int, int> blocks,
                                 WorkQueue& queue) {
  add(queue, [this, &target, blocks] {
    mRound = {blocks.second - blocks.first, 0};
    target.listBlocks(mModel.programs(), blocks.first, blocks.second);
  });
  addPhase(target, by, Phase::OtherWholes, queue);
  addPyramid(target, queue);
}

void InstanceDraw::addRound(model::InstanceTarget& target, model::CullBy by, std::pair<int, int> copies,
                            WorkQueue& queue) {
  add(queue, [this, &target, copies] {
    mRound = {};
    target.listCopies(mModel.programs(), copies.first, copies.second);
  });
  queue.addUntilDone(mPass, [this, &target, copies] { return listNext(target, copies.second - copies.first); });
  addPhase(target, by, Phase::Others, queue);
  addPyramid(target, queue);
}

/// Lists bundles of some copies more. @param copies  of the round @return true when they are the last
bool InstanceDraw::listNext(model::InstanceTarget& target, int copies) {
  // The only copy there is is always listed.
  if (mRound.copies < 0)
    mRound.copies = mModel.isSoftware() && mModel.instanceRoom().slots > 1 ? target.listedCopies() : copies;
  int atATime = std::max(1, int(mModel.atATime() / std::max(1u, target.bundlesOfCopy())));
  int end = std::min(mRound.copies, mRound.next + atATime);
  if (end > mRound.next) target.listBundles(mModel.programs(), mRound.next, end);
  mPace.handOver(0, 0);
  mRound.next = end;
  return end == mRound.copies;
}

void InstanceDraw::addPhase(model::InstanceTarget& target, model::CullBy by, Phase phase, WorkQueue& queue) {
  add(queue, [this] { mPlace = {}; });
  queue.addUntilDone(mPass, [this, &target, by, phase] { return drawNext(target, by, phase); });
}

/// Adds some of a phase's instances to the list.
void InstanceDraw::cullNext(model::InstanceTarget& target, model::CullBy by, Phase phase) {
  if (mPlace.culled == mPlace.listEnd) {
    target.openList();
    mPlace.listEnd = mPlace.culled + std::min(target.itemsOfList(phase), mPlace.items - mPlace.culled);
  }
  // Of words most are empty.
  std::uint32_t most = model::isOfOthers(phase) ? mModel.atATime() / std::uint32_t(shared::kBundle) : mModel.atATime();
  std::uint32_t end = mPlace.culled + std::min(std::max(1u, most), mPlace.listEnd - mPlace.culled);
  mStates.bind();
  target.cull(mModel.programs(), by, phase, mPlace.culled, end);
  mPlace.culled = end;
  if (end < mPlace.listEnd) return;
  target.closeList(mModel.programs());
  mPlace.isListed = true;
  mPlace.groups = {};
  mPlace.kind = 0;
  mPlace.next = 0;
}

/// The next piece of a phase. @return true when it was the last
bool InstanceDraw::drawNext(model::InstanceTarget& target, model::CullBy by, Phase phase) {
  bool isSoftware = mModel.isSoftware();
  if (!mPlace.isKnown) {
    if (phase == Phase::OtherWholes && isSoftware) mRound.copies = target.listedCopies();
    bool asks = phase == Phase::Others && isSoftware;
    mPlace.items = asks ? target.listedBundles() : target.itemsOf(phase, mRound.copies);
    mPlace.isKnown = true;
  }
  if (!mPlace.isListed) {
    if (mPlace.culled < mPlace.items) cullNext(target, by, phase);
    mPace.handOver(0, 0);
    return !mPlace.isListed && mPlace.culled == mPlace.items;
  }
  if (isSoftware && mPlace.kind == 0 && mPlace.next == 0) mPlace.groups = target.groupCounts();
  model::InstanceTarget::Draws draws = drawsOf(phase);
  std::uint32_t left = 0, count = 0;
  while (isSoftware && mPlace.kind < shared::kDrawLists &&
         (left = mPlace.groups[std::size_t(mPlace.kind)] - mPlace.next) == 0) {
    ++mPlace.kind;
    mPlace.next = 0;
  }
  draws.list = mPlace.kind;
  if (mPlace.kind < shared::kDrawLists) {
    if (isSoftware) {
      count = std::min(left, mPace.groupsOf(mPlace.kind));
      target.drawGroups(mModel.programs(), draws, mPlace.next, count);
    } else {
      target.drawList(mModel.programs(), draws);
    }
    gpu::barrier();
  }
  mPace.handOver(std::min(mPlace.kind, shared::kDrawLists - 1), count);
  mPlace.next += count;
  if (!isSoftware) ++mPlace.kind;
  mPlace.isListed = mPlace.kind < shared::kDrawLists;
  return !mPlace.isListed && mPlace.culled == mPlace.items;
}

model::InstanceTarget::Draws InstanceDraw::drawsOf(Phase phase) const {
  if (!model::isOfWholes(phase)) return {model::DrawOf::Molecules, phase};
  return {mModel.need().hasMembranes ? model::DrawOf::WholesWithMembranes : model::DrawOf::Wholes, phase};
}

void InstanceDraw::addPyramid(model::InstanceTarget& target, WorkQueue& queue) {
  add(queue, [this, &target] { target.makePyramid(mModel.programs()); });
}

}  // namespace velum::render
