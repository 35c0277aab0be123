#pragma once
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QTreeView>
#include <functional>
#include <optional>

#include "kit/Selection.h"
#include "kit/TypeTree.h"
#include "kit/Widgets.h"
#include "velum/scene/Cut.h"
#include "velum/session/document/Document.h"

namespace velum::gui {

/// The types of a model with what a cut leaves of them.
class TypeSpareTree : public TypeTree {
  Q_OBJECT
 public:
  enum Column { Name, Bar, Percent, kColumns };
  enum Role { ShareRole = kOwnRole, OwnRole };
  explicit TypeSpareTree(QObject* parent);
  void showCut(const Shared<Model>& model, const scene::Cut& cut);
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  std::vector<scene::TypeSpare> mShown;
  std::vector<double> mShares;  ///< by row
  std::vector<bool> mOwn;
};

/// Its rows, with bars that are dragged.
class TypeSpareView : public QTreeView {
  Q_OBJECT
 public:
  explicit TypeSpareView(QWidget* parent);
  TypeSpareTree& tree() { return *mTree; }
  TypeOrder& order() { return *mOrder; }
  void setSearch(const QString& text);
  void openSome();
  /// Paths of the rows that are selected.
  std::vector<std::string> selectedPaths() const;
  /// Where a column of a row is, for tests. @param row  of the tree
  QRect cellOfRow(int row, TypeSpareTree::Column column) const;

 signals:
  void dragged(const std::vector<std::string>& paths, double share);
  void settled();

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  void dragTo(int x);
  TypeSpareTree* mTree;
  TypeOrder* mOrder;
  QPersistentModelIndex mHeld;  ///< Whose bar is dragged.
};

/// What the selected cut leaves of the types of a model, and how.
class TypeSpareList : public QWidget {
  Q_OBJECT
 public:
  TypeSpareList(session::Document& document, Selection& selection, QWidget* parent);
  /// Hides itself where the scene has no model.
  void showCut(const scene::Scene& scene, const scene::Cut& cut);

 private:
  using Change = std::function<void(scene::Cut&)>;
  void editCut(const std::string& label, const Change& change, bool merge = false);
  void changeSpares(const char* label, const std::function<void(scene::TypeSpare&)>& change);
  void setShare(const std::vector<std::string>& paths, double share);
  void makeRows(QVBoxLayout* layout);
  NumberRow* addNumber(QGridLayout* grid, const QString& name, const char* objectName, const QString& tip,
                       NumberRow* row);
  QWidget* makeRange(const QString& name, const QString& suffix, int decimals, double factor,
                     double scene::Cut::*least, double scene::Cut::*most, QDoubleSpinBox* (&spins)[2]);
  void showSelected();
  void showMenu(QPoint place);

  session::Document& mDocument;
  Selection& mSelection;
  QLineEdit* mSearch = nullptr;
  TypeSpareView* mView = nullptr;
  QLabel* mRow = nullptr;
  NumberRow *mShare = nullptr, *mFalloff = nullptr, *mAmount = nullptr, *mExponent = nullptr;
  QCheckBox* mWhole = nullptr;
  QDoubleSpinBox *mMass[2] = {}, *mCount[2] = {};
  scene::Cut mCut;
};

}  // namespace velum::gui
