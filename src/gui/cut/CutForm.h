#pragma once
#include <QGridLayout>
#include <QPushButton>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "gui/cut/AlignRow.h"
#include "gui/kit/Widgets.h"
#include "gui/rows/FieldForm.h"
#include "gui/service/JobRunner.h"
#include "gui/service/Selection.h"
#include "session/document/Document.h"

namespace velum::gui {

/// Every number of the selected cut: place, direction, size, face.
class CutForm : public QWidget {
  Q_OBJECT
 public:
  CutForm(session::Document& document, Selection& selection, JobRunner& jobs, QWidget* parent);
  void showCut(const scene::Cut& cut);

 private:
  void editCut(const char* label, const std::function<void(scene::Cut&)>& change, bool merge = false);
  QLabel* addRow(const QString& name, QWidget* control);
  QWidget* makeTriple(NumberField* (&spins)[3], const QString& name, std::function<void(int, double)> change);
  NumberField* makeSpin(QWidget* parent, double min, double max, const QString& suffix);
  void makePlace();
  void makeDirection();
  void makeAlign();
  void makeSize();
  void makeFace();
  void showDirections();
  void nameSides();
  void showSize(const scene::Cut& cut);
  void align(glm::dvec3 axis);

  session::Document& mDocument;
  Selection& mSelection;
  JobRunner& mJobs;
  QGridLayout* mGrid;
  FieldForm mForm;
  NumberRow* mPosition = nullptr;
  QLabel *mPositionLabel = nullptr, *mAxisLabel = nullptr, *mAlignLabel = nullptr, *mCentreLabel = nullptr,
         *mSizeLabel = nullptr;
  QWidget *mCentreRow = nullptr, *mAxisRow = nullptr;
  AlignRow* mAlignRow = nullptr;
  std::vector<QWidget*> mOfPlace;  ///< controls of the place, hidden for shapes without a place
  NumberField *mCentre[3] = {}, *mSize[3] = {}, *mAzimuth = nullptr, *mElevation = nullptr, *mSpin = nullptr;
  QWidget* mSizeRow = nullptr;
  QPushButton* mFlip = nullptr;
  std::optional<bool> mNamesPatient;  ///< whether sides have the names of a patient's; nothing: they have none yet
  scene::Cut mShown;
};

}  // namespace velum::gui
