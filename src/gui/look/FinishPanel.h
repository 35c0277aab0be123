#pragma once
#include <QComboBox>
#include <QPushButton>
#include <QWidget>

#include "gui/look/FinishGrid.h"
#include "gui/look/LitSphereGrid.h"
#include "gui/rows/FieldForm.h"
#include "session/document/Document.h"
#include "session/look/ValueHistogram.h"

namespace velum::gui {

/// What an illustrator adds to a picture: named finishes, contours, lit spheres, strokes, paper. Reads the document,
/// and changes it by edits only.
class FinishPanel : public QWidget {
  Q_OBJECT
 public:
  FinishPanel(session::Document& document, QWidget* parent);
  void refresh();
  bool isComplete() const { return mFinishes->isComplete(); }
  LitSphereGrid& spheres() { return *mSpheres; }
  /// Makes the picture in a file the scene's paper, as one undo step.
  void takePaper(const QString& path);

 public slots:
  /// The view's picture is complete: the machine is free to draw the small ones.
  void viewIsComplete() { mFinishes->drawPictures(); }

 signals:
  /// A picture could not be read; one line.
  void failed(const QString& error);

 private:
  void addSection(const QString& title);
  void addOffer();
  void refreshOffer();
  void addContours();
  void addSpheres();
  void addStrokes();
  void addPaper();
  void askPaper();
  void listOwnPaper();

  session::Document& mDocument;
  FinishGrid* mFinishes;
  QWidget* mOffer = nullptr;  ///< Offers to turn a translucent look into one of surfaces.
  session::HistogramMemo mHistogram;
  LitSphereGrid* mSpheres;
  FieldForm mForm;
  QComboBox* mPaper = nullptr;
  QPushButton* mOwnPaper = nullptr;
};

}  // namespace velum::gui
