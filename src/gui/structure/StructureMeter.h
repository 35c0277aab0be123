#pragma once
#include <QObject>
#include <map>
#include <memory>

#include "kit/Job.h"
#include "velum/session/structure/StructureSizes.h"

namespace velum::gui {

/// Counts the voxels of every structure in the background, once for a label volume.
class StructureMeter : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// Starts to count where the data is another one. Cheap otherwise.
  void measure(const Shared<LabelVolume>& labels);
  bool isMeasuring() const { return mJob != nullptr; }
  /// Its table has it, and no voxel does. False while it is not known.
  bool isAbsent(int id) const { return mLabels && !mJob && mSizes.count(id) == 0; }
  /// Null while it is not known, and for structures without voxels.
  const session::StructureSize* find(int id) const;
  const Shared<LabelVolume>& labels() const { return mLabels; }

 signals:
  void measured();

 private:
  Shared<LabelVolume> mLabels;
  std::map<int, session::StructureSize> mSizes;
  std::unique_ptr<Job> mJob;
};

}  // namespace velum::gui
