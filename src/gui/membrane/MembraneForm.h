#pragma once
#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <optional>

#include "gui/kit/Widgets.h"
#include "gui/membrane/NoiseForm.h"
#include "gui/membrane/ShareBar.h"
#include "gui/membrane/SheetHandsForm.h"
#include "gui/membrane/SketchForm.h"
#include "gui/membrane/StrengthForm.h"
#include "gui/membrane/StrengthTable.h"
#include "gui/rows/FieldForm.h"
#include "gui/service/Selection.h"
#include "session/document/Document.h"
#include "session/membrane/MembraneMover.h"

namespace velum::gui {

/// What a membrane protects, how its sheet hangs, what the membrane does to the picture, and what its sheet is doing
/// just now. Stands below the numbers of the membrane's cut.
class MembraneForm : public QWidget {
  Q_OBJECT
 public:
  MembraneForm(session::Document& document, Selection& selection, QWidget* parent);
  void showCut(const scene::Cut& cut);
  void showStatus(const std::optional<session::MembraneStatus>& status, bool isPlaying);
  SheetHandsForm& hands() { return *mHands; }
  /// In words: "cuts 12 % of what the plane cuts; 1.3 mm from the rest plane on average".
  static QString figureText(const session::MembraneStatus& status, const Length& length);
  /// The buttons of the tools with which a click says what is protected, or what the sheet may pass through.
  QPushButton& protectButton() { return *mProtect; }
  QPushButton& letThroughButton() { return *mLetThrough; }
  /// The membrane's brushes and strokes.
  SketchForm& sketch() { return *mSketch; }

 signals:
  void playAsked(bool play);
  void stepAsked();
  void flatAsked();
  void exportSheetAsked();
  void exportClippedAsked();

 private:
  /// Sets the force with which a structure, or a type of a model, acts on the sheet.
  void setForceOf(const session::Protectable& what, double strength);
  QWidget* makeProtect();
  QWidget* makePlayer();
  QWidget* makeLast();
  void addPicture();
  void addCloth();

  session::Document& mDocument;
  Selection& mSelection;
  scene::Cut mShown;
  ShareBar* mShares;
  QLabel *mFigure, *mDoing;
  StrengthForm* mStrength;
  SheetHandsForm* mHands = nullptr;
  StrengthTable* mStructures;
  NoiseForm* mNoise;
  SketchForm* mSketch;
  QPushButton *mProtect = nullptr, *mLetThrough = nullptr, *mPlay = nullptr, *mStep = nullptr, *mMore = nullptr;
  FieldForm mForm;
};

}  // namespace velum::gui
