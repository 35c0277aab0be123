#include "StructureMeter.h"

namespace velum::gui {

void StructureMeter::measure(const Shared<LabelVolume>& labels) {
  if (labels == mLabels) return;
  mJob.reset();  // cancels and waits: the counter looks after each layer of bricks
  mLabels = labels;
  mSizes.clear();
  if (!labels) return;
  auto sizes = std::make_shared<std::map<int, session::StructureSize>>();
  mJob = std::make_unique<Job>(
      [labels, sizes](Progress& progress) { *sizes = session::measureStructures(*labels, progress); }, nullptr);
  connect(mJob.get(), &Job::finished, this, [this, sizes, id = labels.id()](bool done, const QString&) {
    if (!done || mLabels.id() != id) return;
    mSizes = std::move(*sizes);
    mJob.release()->deleteLater();
    emit measured();
  });
  mJob->start();
}

const session::StructureSize* StructureMeter::find(int id) const {
  auto found = mSizes.find(id);
  return found == mSizes.end() ? nullptr : &found->second;
}

}  // namespace velum::gui
