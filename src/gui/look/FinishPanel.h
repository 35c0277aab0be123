#pragma once
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QWidget>
#include <vector>

#include "gui/kit/Widgets.h"
#include "gui/look/FinishGrid.h"
#include "gui/look/LitSphereGrid.h"
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
  /// A slider of one number of the finish.
  struct Slider {
    NumberRow* row;
    double scene::Finish::*field;
    double unit;  ///< What is shown is the field's value divided by that.
  };
  /// What a slider is of and how it is named.
  struct SliderText {
    const char* object;
    QString title, name, tip;
    const char* step;  ///< Of undo.
  };
  QGridLayout* addSection(const QString& title);
  void addSlider(QGridLayout* rows, const SliderText& text, double scene::Finish::*field, double min, double max,
                 double unit, const QString& suffix);
  void addShare(QGridLayout* rows, const SliderText& text, double scene::Finish::*field);
  ColorButton* makeColor(const char* object, const QString& title, const QString& tip, const char* step,
                         glm::vec3 scene::Finish::*field);
  void addOffer();
  void refreshOffer();
  void addContours();
  void addSpheres();
  void addStrokes();
  void addPaper();
  void askPaper();
  void showPaper(const scene::Finish& finish);

  session::Document& mDocument;
  FinishGrid* mFinishes;
  QWidget* mOffer = nullptr;  ///< To make a look that one sees through a surface.
  session::HistogramMemo mHistogram;
  LitSphereGrid* mSpheres;
  std::vector<Slider> mSliders;
  ColorButton *mInk = nullptr, *mPaperColor = nullptr;
  QCheckBox* mOwnSpheres = nullptr;
  QComboBox* mPaper = nullptr;
  QPushButton* mOwnPaper = nullptr;
};

}  // namespace velum::gui
