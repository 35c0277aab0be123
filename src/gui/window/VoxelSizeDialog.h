#pragma once
#include <QDialog>

#include "gui/window/VoxelSizeForm.h"

namespace velum::gui {

/// Asks how large the voxels of what is open are, where its file does not say, or says it wrong.
class VoxelSizeDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param text  why it is asked
  VoxelSizeDialog(const QString& text, QWidget* parent);
  VoxelSizeForm& form() { return *mForm; }

 private:
  VoxelSizeForm* mForm;
};

}  // namespace velum::gui
