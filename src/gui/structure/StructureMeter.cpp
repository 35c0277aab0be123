#include "gui/structure/StructureMeter.h"

#include <memory>

#include "scene/GreyWindows.h"
#include "scene/Scene.h"

namespace velum::gui {

namespace {

constexpr int kQuietMs = 200;  // labels that grow are not counted on their way

}  // namespace

StructureMeter::StructureMeter(QObject* parent)
    : QObject(parent), mCounting(kQuietMs, this), mMeasuring(kQuietMs, this) {}

void StructureMeter::measure(const Shared<LabelVolume>& labels) {
  if (labels == mLabels) return;
  mLabels = labels;
  mSizes.clear();
  if (!labels) return mCounting.stop();
  auto sizes = std::make_shared<std::map<int, session::StructureSize>>();
  mCounting.want(
      [labels, sizes]() -> Job::Work {
        return [=](Progress& progress) { *sizes = session::measureStructures(*labels, progress); };
      },
      [this, sizes] {
        mSizes = std::move(*sizes);
        emit measured();
      });
}

const session::StructureSize* StructureMeter::find(int id) const {
  auto found = mSizes.find(id);
  return found == mSizes.end() ? nullptr : &found->second;
}

void StructureMeter::measureValues(const scene::Scene& scene) {
  const scene::VolumeLayer& layer = scene.volume;
  Measured wanted{scene.labels.data, layer.data, layer.channel, layer.timeStep};
  if (wanted == mMeasured) return;
  mMeasured = wanted;
  mValues.clear();
  bool hasValues = wanted.labels && wanted.scan && !wanted.scan->isColor;
  mValueUnit = hasValues ? QString::fromStdString(scene::valueUnit(*wanted.scan)) : QString();
  if (!hasValues) {
    mMeasuring.stop();
    return emit valuesMeasured();
  }
  auto values = std::make_shared<std::map<int, session::StructureValues>>();
  mMeasuring.want(
      [wanted, values]() -> Job::Work {
        return [=](Progress& progress) {
          *values = session::measureValues(*wanted.labels, *wanted.scan, wanted.channel, wanted.timeStep, progress);
        };
      },
      [this, values] {
        mValues = std::move(*values);
        emit valuesMeasured();
      });
}

const session::StructureValues* StructureMeter::findValues(int id) const {
  auto found = mValues.find(id);
  return found == mValues.end() ? nullptr : &found->second;
}

}  // namespace velum::gui
