#pragma once
#include <QCheckBox>
#include <QLabel>
#include <string>
#include <vector>

#include "gui/rows/FieldForm.h"
#include "gui/service/Selection.h"
#include "scene/Cut.h"
#include "session/document/Document.h"

namespace velum::gui {

/// Which types of a model the selected cut keeps in view, and how the instances that stand before those types are
/// cleared ([VE] 6).
class FocusForm : public QWidget {
  Q_OBJECT
 public:
  FocusForm(session::Document& document, Selection& selection, QWidget* parent);
  /// @param paths  of the types and compartments that are selected in the list above
  void showCut(const scene::Cut& cut, const std::vector<std::string>& paths);
  /// Clears instances for the camera as it stands now, whatever the camera does later, or lets the clearing follow the
  /// camera. @param aspect  width by height of the picture
  void lock(bool locked, double aspect);

 signals:
  void lockAsked(bool locked);

 private:
  bool hasFocus() const { return mCut.model.focus && !mCut.model.focus->types.empty(); }
  void keep(bool kept);
  void addShare(const std::string& field, double scene::TypeSpare::*member, const QString& title, FieldText text);

  session::Document& mDocument;
  Selection& mSelection;
  FieldForm mForm;
  QCheckBox *mKept, *mLock;
  QLabel* mFocus;
  scene::Cut mCut;
  std::vector<std::string> mPaths;
};

}  // namespace velum::gui
