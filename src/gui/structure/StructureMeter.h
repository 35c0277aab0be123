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

/// Counts the voxels of every structure in the background, once for a label volume, and what the scan measured in it,
/// once for each scan, channel and time step.
class StructureMeter : public QObject {
  Q_OBJECT
 public:
  explicit StructureMeter(QObject* parent = nullptr);

  /// Starts to count where the data is another one. Cheap otherwise.
  void measure(const Shared<LabelVolume>& labels);
  bool isMeasuring() const { return mCounting.isBusy(); }
  /// Its table has it, and no voxel does. False while it is not known.
  bool isAbsent(int id) const { return mLabels && !mCounting.isBusy() && mSizes.count(id) == 0; }
  /// Null while it is not known, and for structures without voxels.
  const session::StructureSize* find(int id) const;
  const Shared<LabelVolume>& labels() const { return mLabels; }

  /// Starts to measure the scan's values in the structures where they are others. Cheap otherwise.
  void measureValues(const scene::Scene& scene);
  bool isMeasuringValues() const { return mMeasuring.isBusy(); }
  /// Null while they are not known, and for structures in which no voxel of the scan lies.
  const session::StructureValues* findValues(int id) const;
  /// Of the scan's values; empty: not known.
  const QString& valueUnit() const { return mValueUnit; }

 signals:
  void measured();
  void valuesMeasured();

 private:
  Shared<LabelVolume> mLabels;
  std::map<int, session::StructureSize> mSizes;
  NewestJob mCounting;
  /// What values are of.
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
