#pragma once
#include <QComboBox>
#include <QHash>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <map>
#include <set>

#include "gui/mark/LetteringForm.h"
#include "gui/mark/MarkMenu.h"
#include "gui/mark/OwnColor.h"
#include "gui/rows/EyeList.h"
#include "gui/service/Selection.h"
#include "session/measure/Measure.h"

namespace velum::gui {

/// The page of marks: a button for each tool, the list of marks with their values, the fields of the selected one, and
/// all other lettering.
class MarkPanel : public QWidget {
  Q_OBJECT
 public:
  MarkPanel(session::Document& document, Selection& selection, MarkMenu& menu, QWidget* parent);
  /// Shows the document as it is now.
  void refresh();
  /// What marks measure that are not measured at once, by their ids.
  void setMeasured(std::map<int, session::Measured> measured);
  /// Marks that the 3D picture does not show, as it hides what they point at: their ids.
  void setHidden(std::set<int> marks);
  CaptionForm& captions() { return mLettering->captions(); }
  /// The button of a tool. @param kind  one that has a tool
  QToolButton& toolButton(scene::MarkKind kind) { return *mTools.value(int(kind)); }
  /// Selects a mark and opens the field in which its words are typed.
  void startRenaming(int mark);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* makeTools();
  QWidget* makeButtons();
  QWidget* makeFields();
  QComboBox* makeShownAt(QWidget* parent);
  void refreshShownAt();
  int place() const;
  const std::vector<scene::Mark>& marks() const { return mDocument.shown().lettering.marks; }
  void showList();
  QString valueOf(const scene::Mark& mark) const;

  session::Document& mDocument;
  Selection& mSelection;
  MarkMenu& mMenu;
  std::map<int, session::Measured> mMeasured;
  std::set<int> mHidden;
  QHash<int, QToolButton*> mTools;  ///< by kind
  EyeList* mList;
  QLabel* mEmpty;
  FieldForm mForm;
  QWidget *mButtons, *mFields;
  OwnColor* mOwnColor = nullptr;
  QComboBox* mShownAt = nullptr;
  QWidget* mShownAtLabel = nullptr;
  LetteringForm* mLettering;
};

}  // namespace velum::gui
