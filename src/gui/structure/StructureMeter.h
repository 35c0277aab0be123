#pragma once
#include <QObject>
#include <QString>
#include <map>

#include "core/LabelVolume.h"
#include "core/Shared.h"
#include "core/Volume.h"
#include "gui/service/NewestJob.h"
#include "scene/SceneFwd.h"
#include "session/structure/StructureSizes.h"
#include "session/structure/StructureValues.h"

namespace velum::gui {

/// Counts the voxels of every structure in the background, once for each label volume, and measures the scan's values
/// in every structure, once for each scan, channel and time step.
class StructureMeter : public QObject {
  Q_OBJECT
 public:
  explicit StructureMeter(QObject* parent = nullptr);

  /// Starts to count if the label data has changed. Cheap otherwise.
  void measure(const Shared<LabelVolume>& labels);
  bool isMeasuring() const { return mCounting.isBusy(); }
  /// True for a structure that no voxel has, although the table of labels may list it. False while the counts are not
  /// known.
  bool isAbsent(int id) const { return mLabels && !mCounting.isBusy() && mSizes.count(id) == 0; }
  /// The size of a structure; null while it is not known, and for structures without voxels.
  const session::StructureSize* find(int id) const;
  const Shared<LabelVolume>& labels() const { return mLabels; }

  /// Starts to measure the scan's values in the structures if the scan, channel, time step or labels have changed.
  /// Cheap otherwise.
  void measureValues(const scene::Scene& scene);
  bool isMeasuringValues() const { return mMeasuring.isBusy(); }
  /// The scan's values in a structure; null while they are not known, and for structures in which no voxel of the scan
  /// lies.
  const session::StructureValues* findValues(int id) const;
  /// The unit of the scan's values; empty: not known.
  const QString& valueUnit() const { return mValueUnit; }

 signals:
  void measured();
  void valuesMeasured();

 private:
  Shared<LabelVolume> mLabels;
  std::map<int, session::StructureSize> mSizes;
  NewestJob mCounting;
  /// What mValues was measured in.
  struct Measured {
    Shared<LabelVolume> labels;
    Shared<Volume> scan;
    int channel = 0, timeStep = 0;
    bool operator==(const Measured&) const = default;
  };
  Measured mMeasured;
  QString mValueUnit;
  std::map<int, session::StructureValues> mValues;
  NewestJob mMeasuring;
};

}  // namespace velum::gui
