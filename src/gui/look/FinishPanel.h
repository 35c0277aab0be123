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
  /// Takes a picture as the paper, as one undo step.
  void takePaper(const QString& path);

 public slots:
  /// The picture is done: the machine is free for small ones.
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
  QWidget* mOffer = nullptr;  ///< To make a look that one sees through a surface.
  session::HistogramMemo mHistogram;
  LitSphereGrid* mSpheres;
  FieldForm mForm;
  QComboBox* mPaper = nullptr;
  QPushButton* mOwnPaper = nullptr;
};

}  // namespace velum::gui
