#pragma once
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <functional>
#include <optional>

#include "gui/cut/FocusForm.h"
#include "gui/cut/TypeSpareView.h"
#include "gui/kit/Widgets.h"
#include "gui/rows/FieldForm.h"
#include "gui/service/Selection.h"
#include "scene/Cut.h"
#include "session/document/Document.h"

namespace velum::gui {

/// How much of each type of a model the selected cut leaves, and the settings that decide which instances it leaves.
class TypeSpareList : public QWidget {
  Q_OBJECT
 public:
  TypeSpareList(session::Document& document, Selection& selection, QWidget* parent);
  /// Hides itself where the scene has no model.
  void showCut(const scene::Scene& scene, const scene::Cut& cut);
  FocusForm& focus() { return *mFocus; }

 private:
  using Change = std::function<void(scene::Cut&)>;
  void editCut(const std::string& label, const Change& change, bool merge = false);
  void setShare(const std::vector<std::string>& paths, double share);
  void makeRows(QVBoxLayout* layout);
  void addHow(QGridLayout* grid);
  QWidget* makeRange(const QString& name, const QString& suffix, int decimals, double factor,
                     double scene::ModelCut::*least, double scene::ModelCut::*most, NumberField* (&spins)[2]);
  void showSelected();
  void showMenu(QPoint place);

  session::Document& mDocument;
  Selection& mSelection;
  QLineEdit* mSearch = nullptr;
  TypeSpareView* mView = nullptr;
  QLabel* mRow = nullptr;
  FieldForm mForm;
  FocusForm* mFocus = nullptr;
  NumberField *mMass[2] = {}, *mCount[2] = {};
  scene::Cut mCut;
  double mReach = 1.0;  ///< how far the falloff can be set to reach, a length
};

}  // namespace velum::gui
