#pragma once
#include <QDialog>

#include "gui/window/VoxelSizeForm.h"

namespace velum::gui {

/// Asks how large the voxels of the open data are, where the file does not tell, or tells a wrong size.
class VoxelSizeDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param text  says why the user is asked
  VoxelSizeDialog(const QString& text, QWidget* parent);
  VoxelSizeForm& form() { return *mForm; }

 private:
  VoxelSizeForm* mForm;
};

}  // namespace velum::gui
