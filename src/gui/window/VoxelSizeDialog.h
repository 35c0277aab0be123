#pragma once
#include <QDialog>

#include "VoxelSizeForm.h"

namespace velum::gui {

/// Asks how large the voxels of what is open are, where its file does not say, or says it wrong.
class VoxelSizeDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param text  why it is asked
  VoxelSizeDialog(const QString& text, glm::dvec3 millimetres, QWidget* parent);
  glm::dvec3 value() const { return mForm->value(); }

 private:
  VoxelSizeForm* mForm;
};

}  // namespace velum::gui
