#include "StructureMeter.h"

#include "velum/scene/GreyWindows.h"

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

void StructureMeter::measureValues(const scene::Scene& scene) {
  const scene::VolumeLayer& layer = scene.volume;
  Measured wanted{scene.labels.data, layer.data, layer.channel, layer.timeStep};
  if (wanted == mMeasured) return;
  mValueJob.reset();  // cancels and waits: a few planes
  mMeasured = wanted;
  mValues.clear();
  bool hasValues = wanted.labels && wanted.scan && !wanted.scan->isColor;
  mValueUnit = hasValues ? QString::fromStdString(scene::valueUnit(*wanted.scan)) : QString();
  if (!hasValues) return emit valuesMeasured();
  auto values = std::make_shared<std::map<int, session::StructureValues>>();
  mValueJob = std::make_unique<Job>(
      [wanted, values](Progress& progress) {
        *values = session::measureValues(*wanted.labels, *wanted.scan, wanted.channel, wanted.timeStep, progress);
      },
      nullptr);
  connect(mValueJob.get(), &Job::finished, this, [this, values, wanted](bool done, const QString&) {
    if (!done || !(mMeasured == wanted)) return;
    mValues = std::move(*values);
    mValueJob.release()->deleteLater();
    emit valuesMeasured();
  });
  mValueJob->start();
}

const session::StructureValues* StructureMeter::findValues(int id) const {
  auto found = mValues.find(id);
  return found == mValues.end() ? nullptr : &found->second;
}

}  // namespace velum::gui
