#pragma once
#include <vector>

#include "gui/rows/BarList.h"
#include "gui/rows/TypeTree.h"
#include "scene/Cut.h"

namespace velum::gui {

/// The types of a model, each with the share of it that a cut leaves.
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

/// The rows of a TypeSpareTree, with bars that can be dragged.
class TypeSpareView : public BarList {
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
  bool pressCell(const QModelIndex& index, QMouseEvent* event) override;
  void dragKnob(double x) override;
  void letKnobGo() override;
  bool hasKeys() const override { return false; }

 private:
  TypeSpareTree* mTree;
  TypeOrder* mOrder;
  QPersistentModelIndex mHeld;  ///< The row whose bar is dragged.
};

}  // namespace velum::gui
