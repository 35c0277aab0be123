#pragma once
#include <QAbstractListModel>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QSortFilterProxyModel>
#include <QWidget>
#include <vector>

#include "scene/Cut.h"
#include "scene/Structure.h"

namespace velum::gui {

/// The structures as rows, with a tick at each structure that a cut spares.
class SpareModel : public QAbstractListModel {
  Q_OBJECT
 public:
  using QAbstractListModel::QAbstractListModel;
  void setRows(const std::vector<scene::Structure>& structures, const scene::Cut& cut);
  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool isKept(int row) const;

 signals:
  void ticked(int id, bool whole);

 private:
  std::vector<scene::Structure> mStructures;
  std::vector<int> mSpared;  ///< ascending
};

/// A list of structures that can be searched, with a tick at each structure that the cut spares.
class SpareList : public QWidget {
  Q_OBJECT
 public:
  explicit SpareList(QWidget* parent);
  void showCut(const std::vector<scene::Structure>& structures, const scene::Cut& cut);

 signals:
  void changed(const std::vector<int>& ids, bool whole);

 private:
  std::vector<int> listedIds() const;

  SpareModel* mModel;
  QSortFilterProxyModel* mFound;
  QLabel* mTitle;
  QLineEdit* mSearch;
  QListView* mList;
};

}  // namespace velum::gui
