#pragma once
#include "gui/view/Room.h"
#include "gui/window/FileLoads.h"
#include "scene/Source.h"

namespace velum::gui {

/// What can be done to the volume itself: how large its voxels are, how a file without a header is read, and whether
/// the scanner's table belongs to it. Each is a job, and one undo step.
class VolumeCommands : public Room {
  Q_OBJECT
 public:
  VolumeCommands(const WindowParts& parts, FileLoads& loads);
  void refresh(const session::Session& session) override;

  /// Reads the volume anew from a source that tells another layout or voxel size. @param step  the undo step's name
  void reread(const QString& step, const scene::Source& source);
  /// Leaves out of the volume what is not part of the largest body, such as the table, or shows it again.
  void hideTable(bool hidden);

 private:
  void askVoxelSize(const QString& why);
  void askLayout();
  void askLevel();
  void askWhatIsUnknown();

  QAction *mVoxelSize, *mLayout, *mLevel, *mTable;
};

}  // namespace velum::gui
