#pragma once
#include <QCheckBox>
#include <QLabel>
#include <QSpinBox>
#include <QWidget>

#include "gui/kit/Length.h"
#include "gui/service/Selection.h"
#include "session/document/Document.h"
#include "session/membrane/MembraneMover.h"

namespace velum::gui {

/// What keeps the selected membrane from protecting noise: the size of the least piece that counts, whether noise is
/// taken out first, and how much is left out by both.
class NoiseForm : public QWidget {
  Q_OBJECT
 public:
  NoiseForm(session::Document& document, Selection& selection, QWidget* parent);
  void showField(const scene::ForceField& field);
  /// @param voxelSize  volume of a voxel; 0 where there is no volume
  void showLeftOut(const membrane::LeftOut& leftOut, double voxelSize, const Length& length);

 private:
  session::Document& mDocument;
  Selection& mSelection;
  QSpinBox* mLeast;
  QCheckBox* mDenoise;
  QLabel* mText;
};

}  // namespace velum::gui
