#pragma once
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "gui/kit/Widgets.h"
#include "gui/membrane/NoiseForm.h"
#include "gui/membrane/ShareBar.h"
#include "gui/membrane/SheetHandsForm.h"
#include "gui/membrane/SketchForm.h"
#include "gui/membrane/StrengthCanvas.h"
#include "gui/membrane/StrengthTable.h"
#include "gui/service/Selection.h"
#include "session/document/Document.h"
#include "session/membrane/MembraneMover.h"

namespace velum::gui {

class Job;

/// What a membrane protects, how its sheet hangs and what it does to the picture; what it is doing just now. Below
/// the numbers of its cut.
class MembraneForm : public QWidget {
  Q_OBJECT
 public:
  MembraneForm(session::Document& document, Selection& selection, QWidget* parent);
  ~MembraneForm() override;
  void showCut(const scene::Cut& cut);
  void showStatus(const std::optional<session::MembraneStatus>& status, bool isPlaying);
  SheetHandsForm& hands() { return *mHands; }
  /// In words: "cuts 12 % of what the plane cuts; 1.3 mm from the rest plane on average".
  static QString figureText(const session::MembraneStatus& status, const Length& length);
  /// The buttons of the tools that say by a click what is protected, or let through.
  QPushButton& protectButton() { return *mProtect; }
  QPushButton& letThroughButton() { return *mLetThrough; }
  /// Its brushes and strokes.
  SketchForm& sketch() { return *mSketch; }

 signals:
  void playAsked(bool play);
  void stepAsked();
  void flatAsked();
  void exportSheetAsked();
  void exportClippedAsked();

 private:
  using Change = std::function<void(scene::Membrane&)>;
  using Rows = std::vector<std::pair<QWidget*, QWidget*>>;  ///< labels and controls
  QWidget* makeFieldHead();
  QWidget* makeProtect();
  QWidget* makePlayer();
  QWidget* makeLast();
  void makePicture(QGridLayout* grid);
  void makeCloth(QGridLayout* grid);
  NumberRow* addNumber(QGridLayout* grid, const QString& name, const QString& tip, double min, double max, int decimals,
                       const QString& suffix, std::function<void(scene::Membrane&, double)> set);
  QComboBox* addChoice(QGridLayout* grid, const QString& name, const QString& tip, const QStringList& items,
                       std::function<void(scene::Membrane&, int)> set);
  void edit(const QString& label, const Change& change, bool merge = false);
  bool byGradient() const { return mAttribute->currentIndex() == 1; }
  /// Notes the last row of a grid.
  static void addLastRow(const QGridLayout* grid, Rows& rows);
  void showCurve();
  void countHistogram();
  void showWords();

  session::Document& mDocument;
  Selection& mSelection;
  scene::Membrane mShown;
  ShareBar* mShares;
  QLabel *mFigure, *mDoing;
  QLabel* mFieldTitle = nullptr;
  QComboBox* mAttribute = nullptr;
  StrengthCanvas* mCanvas;
  SheetHandsForm* mHands = nullptr;
  StrengthTable* mStructures;
  NoiseForm* mNoise;
  SketchForm* mSketch;
  QPushButton *mProtect = nullptr, *mLetThrough = nullptr, *mPlay = nullptr, *mStep = nullptr, *mMore = nullptr;
  QWidget* mCloth = nullptr;
  QComboBox *mUse = nullptr, *mLook = nullptr, *mRule = nullptr, *mSide = nullptr, *mRepositioning = nullptr;
  NumberRow *mLevel = nullptr, *mInlayOpacity = nullptr, *mEmphasis = nullptr, *mFalloff = nullptr, *mStretch = nullptr,
            *mBend = nullptr, *mRestoring = nullptr, *mReach = nullptr, *mParticles = nullptr, *mFinest = nullptr;
  Rows mInlayRows;                                ///< that only an inlay has
  Rows mSidedRows, mPaperRows;                    ///< and that act by one of the rules only
  std::pair<std::uint64_t, int> mCounted{0, -1};  ///< Volume and channel whose values they are.
  Histogram mValues, mGradients;
  std::unique_ptr<Job> mJob;
};

}  // namespace velum::gui
