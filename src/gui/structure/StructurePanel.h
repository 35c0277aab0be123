#pragma once
#include <QGridLayout>
#include <QWidget>

#include "gui/kit/Widgets.h"
#include "gui/rows/CountKey.h"
#include "gui/rows/ListParts.h"
#include "gui/structure/StructureCommands.h"
#include "gui/structure/StructureList.h"

namespace velum::gui {

/// The page of labelled structures: how all labels together are shown, and the list of structures. Reads the document,
/// and changes it by edits only.
class StructurePanel : public QWidget {
  Q_OBJECT
 public:
  StructurePanel(StructureCommands& commands, AreaMeter& areas, Selection& selection, QWidget* parent);
  /// Shows the document as it is now; does next to nothing when no label has changed.
  void refresh();
  std::vector<int> selectedIds() const { return mList->selectedIds(); }

 public slots:
  /// The keyboard goes to the search field.
  void startSearch();

 signals:
  void openLabelsAsked();
  /// The shapes of structures are to be smoothed. @param deviation  of the smoothing, a length
  void smoothingAsked(const std::vector<int>& ids, double deviation);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* makeEmpty();
  QWidget* makeHead();
  QGridLayout* makeShares(QWidget* head);
  QWidget* makeSearch();
  QWidget* makeFoot();
  QWidget* makeDetail();
  void driveShare(NumberRow* row, const char* step, const char* field);
  void showSelected();
  void showSmoothing(const scene::Structure* structure);
  void showCount();
  void setSearch(const QString& text);
  void showColumns(bool on);
  void measureValues();

  StructureCommands& mCommands;
  AreaMeter& mAreas;
  session::Document& mDocument;
  Selection& mSelection;
  StructureList* mList = nullptr;
  CountKey* mKey = nullptr;  ///< of the bars, shown with them
  QWidget *mEmpty = nullptr, *mFull = nullptr, *mDetail = nullptr;
  QLabel *mName = nullptr, *mCount = nullptr, *mDetailName = nullptr;
  EyeButton* mShown = nullptr;
  QLineEdit* mSearch = nullptr;
  QToolButton *mValues = nullptr, *mBars = nullptr;
  NumberRow *mTint = nullptr, *mUnlabelled = nullptr, *mOnSections = nullptr, *mOpacity = nullptr,
            *mSmoothing = nullptr;
  ColorButton* mColor = nullptr;
  scene::LabelLayer mShownLabels;  ///< The labels that the rows were last made from.
  double mShownOnSections = -1.0;
  bool mIsMade = false;
};

}  // namespace velum::gui
