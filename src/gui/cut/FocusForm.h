#pragma once
#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <functional>
#include <string>
#include <vector>

#include "gui/kit/Widgets.h"
#include "gui/service/Selection.h"
#include "scene/Cut.h"
#include "session/document/Document.h"

namespace velum::gui {

/// Which types of a model the selected cut keeps in view, and how what stands before them is cleared ([VE] 6).
class FocusForm : public QWidget {
  Q_OBJECT
 public:
  FocusForm(session::Document& document, Selection& selection, QWidget* parent);
  /// @param paths  of the types and compartments that are selected in the list above
  void showCut(const scene::Cut& cut, const std::vector<std::string>& paths);
  /// Holds what is cleared to a view, or lets it follow the camera. @param aspect  width by height of the picture
  void lock(bool locked, double aspect);

 signals:
  void lockAsked(bool locked);

 private:
  void keep(bool kept);
  void changeSpares(const char* label, const std::function<void(scene::TypeSpare&)>& change);
  NumberRow* addShare(const QString& name, const char* objectName, const QString& tip, const char* label,
                      double scene::TypeSpare::*field);

  session::Document& mDocument;
  Selection& mSelection;
  QGridLayout* mGrid;
  QCheckBox *mKept, *mDepth, *mLock;
  QLabel* mFocus;
  NumberRow *mViewShare = nullptr, *mAperture = nullptr;
  std::vector<QWidget*> mOfFocus;  ///< what there is only with one
  std::vector<std::string> mPaths;
};

}  // namespace velum::gui
