#pragma once
#include <QCheckBox>
#include <QComboBox>
#include <QWidget>
#include <glm/glm.hpp>

#include "kit/NumberField.h"

namespace velum::gui {

/// Asks for the edges of a voxel, in millimetres: three numbers with their unit, the last answer, and what usual
/// scanners and microscopes give.
class VoxelSizeForm : public QWidget {
  Q_OBJECT
 public:
  explicit VoxelSizeForm(QWidget* parent);
  /// Millimetres along x, y, z.
  glm::dvec3 value() const;
  void setValue(glm::dvec3 millimetres);
  /// The next form begins with this one's answer.
  void remember() const;
  /// The answer before; 1 mm where there was none.
  static glm::dvec3 lastAnswer();

 signals:
  void changed();

 private:
  void fillUsual();
  void showUnit(int index);
  NumberField* mEdges[3];
  QComboBox *mUnit, *mUsual;
  QCheckBox* mSame;
};

}  // namespace velum::gui
