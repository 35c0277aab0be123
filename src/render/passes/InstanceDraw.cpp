#include "render/passes/InstanceDraw.h"

#include <algorithm>
#include <utility>

#include "shared/instance.h"

namespace velum::render {

void InstanceDraw::add(WorkQueue& queue, WorkQueue::Run run) {
  queue.add(mPass, [this, run = std::move(run)] {
    mPace.handOver(0, 0);
    run();
  });
}

void InstanceDraw::addCull(model::InstanceTarget& target, model::CullBy by, Phase phase, WorkQueue& queue) {
  for (const auto& part : target.partsOf(phase, mModel.atATime()))
    add(queue, [this, &target, by, phase, part] {
      mStates.bind();
      target.cull(mModel.programs(), by, phase, part);
    });
  add(queue, [this, &target, phase] { target.closeLists(mModel.programs(), phase); });
}

void InstanceDraw::addDraws(model::InstanceTarget& target, Phase phase, bool owners, WorkQueue& queue) {
  if (mModel.isSoftware()) {
    add(queue, [this] { mPlace = {}; });
    queue.addUntilDone(mPass, [this, &target, phase, owners] { return drawNext(target, phase, owners); });
    return;
  }
  for (int list = 0; list < shared::kDrawLists; ++list)
    add(queue, [this, &target, phase, owners, list] {
      target.drawList(mModel.programs(), phase, list, owners);
      gpu::barrier();
    });
}

/// The next piece of what a software driver draws. @return true when it was the last
bool InstanceDraw::drawNext(model::InstanceTarget& target, Phase phase, bool owners) {
  if (!mPlace.isKnown) {
    mPlace.groups = target.groupCounts(phase);
    mPlace.isKnown = true;
  }
  while (mPlace.list < shared::kDrawLists && mPlace.next >= mPlace.groups[std::size_t(mPlace.list)]) {
    ++mPlace.list;
    mPlace.next = 0;
  }
  if (mPlace.list >= shared::kDrawLists) {
    mPace.handOver(0, 0);
    return true;
  }
  std::uint32_t left = mPlace.groups[std::size_t(mPlace.list)] - mPlace.next;
  std::uint32_t count = std::min(left, mPace.groupsOf(mPlace.list));
  target.drawGroups(mModel.programs(), phase, mPlace.list, owners, mPlace.next, count);
  gpu::barrier();
  mPace.handOver(mPlace.list, count);
  mPlace.next += count;
  return false;
}

void InstanceDraw::addPyramid(model::InstanceTarget& target, WorkQueue& queue) {
  add(queue, [this, &target] { target.makePyramid(mModel.programs()); });
}

}  // namespace velum::render
