// A press on a streamed volume whose voxels are still on the disk.
#include "gui/extrusion/PullTool.h"
#include "session/extrusion/MaterialRange.h"

namespace velum::gui {

/// Where the voxels that decide are still on the disk it begins when they have come: nobody waits for that. What the
/// pointer has done by then is done at once.
bool PullTool::beginWhenRead(const Target& target, const ViewPoint& at, bool goesOn, bool isPart) {
  giveUpReading();
  const scene::VolumeLayer& layer = mDocument.shown().volume;
  bool isKnown = target.structure != 0 && !isPart;
  if (isKnown || session::isInMemoryAround(layer, target.world)) return begin(target, at, goesOn, isPart);
  mParts.messages.showNote(tr("Reading the voxels there; hold the button"));
  mIsReleased = false;
  mPointer = at.place();
  mReading = new Job([layer, target](Progress&) { session::bringAround(layer, target.world); }, this);
  auto go = [this, target, layer, view = &at.view(), place = at.place(), goesOn, isPart] {
    mReading = nullptr;
    const scene::Scene& scene = mDocument.shown();
    if (scene.volume.data != layer.data || !scene::findCut(scene, target.cuts.front())) return;
    begin(target, ViewPoint(*view, scene, place), goesOn, isPart);
    if (mPointer != place) pullTo(ViewPoint(*view, scene, mPointer));
    if (mIsReleased) endDrag();
    mToolbox.repaint(*view);
  };
  connect(mReading, &Job::finished, this, go);
  connect(mReading, &Job::finished, mReading, &QObject::deleteLater);
  mReading->start();
  return true;
}

/// It reads on by itself: whoever deletes a job waits for it, and here that would be for a disk.
void PullTool::giveUpReading() {
  if (mReading) disconnect(mReading, &Job::finished, this, nullptr);
  mReading = nullptr;
}

}  // namespace velum::gui
