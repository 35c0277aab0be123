#pragma once
#include <QAbstractItemModel>
#include <QCollator>
#include <QSortFilterProxyModel>
#include <cstdint>
#include <string>
#include <vector>

#include "core/Counts.h"
#include "core/Model.h"
#include "core/Shared.h"

namespace velum::gui {

/// The compartments and types of a model as rows of a tree; all of it hangs below one row. What columns show is of
/// those that derive from it. Rows are made once a model; compartments without types have none.
class TypeTree : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Role {
    NameRole = Qt::UserRole,
    CountRole,
    MassRole,
    IsTypeRole,
    PartRole,
    kOwnRole = PartRole + int(kCountKinds.size())
  };
  /// The share of a kind of kCountKinds, 0 to 1.
  static int partRole(CountOf kind) { return PartRole + int(kind); }
  struct Row {
    bool isType = false;
    std::uint32_t number = 0;  ///< in Model::types or Model::compartments
    int parent = -1;           ///< in rows(); stands before it
    int place = 0;             ///< among the parent's children
    std::vector<int> children;
    std::string path;
    QString name;
    std::uint64_t instances = 0;       ///< of all types below
    double mass = 0.0;                 ///< of one instance, dalton; a compartment's: of all of its
    std::vector<std::uint32_t> types;  ///< it and all below, ascending
  };

  TypeTree(int columns, int nameColumn, QObject* parent);

  /// @return true where it was another one
  bool setModel(const Shared<Model>& model);
  const Shared<Model>& model() const { return mModel; }
  const std::vector<Row>& rows() const { return mRows; }
  const Row& rowAt(const QModelIndex& index) const { return mRows[std::size_t(index.internalId())]; }
  QModelIndex indexOfRow(int row, int column) const;
  QModelIndex indexOfType(int type, int column) const;

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& = {}) const override { return mColumns; }
  QVariant data(const QModelIndex& index, int role) const override;

 protected:
  /// Cells of all rows have changed. @param roles  what of them
  void tellCells(int firstColumn, int lastColumn, const QList<int>& roles);

 private:
  void makeRows();
  int addRow(Row row);

  int mColumns, mNameColumn;
  Shared<Model> mModel;
  std::vector<Row> mRows;       ///< The first is the root's.
  std::vector<int> mRowOfType;  ///< by type
};

/// Sorts, filters and searches them: a row stays whose name holds all words, with those above and below it. What rows
/// say of their instances is looked at when a key or a filter is chosen, and by look(): rows do not jump while a bar is
/// dragged.
class TypeOrder : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  enum class Key { Name, Count, Mass, Part };
  /// The share of a kind of kCountKinds.
  static Key keyOf(CountOf kind) { return Key(int(Key::Part) + int(kind)); }
  /// Types of which some are as it says.
  enum class Only { All, Seen, Unseen, Removed };
  explicit TypeOrder(QObject* parent);
  void setKey(Key key);
  Key key() const { return mKey; }
  void setOnly(Only only);
  Only only() const { return mOnly; }
  void look();
  void setSearch(const QString& text);
  bool isSearching() const { return !mWords.isEmpty(); }

 protected:
  bool isAsAsked(const QModelIndex& row) const;
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  Key mKey = Key::Count;
  Only mOnly = Only::All;
  QStringList mWords;
  QCollator mCollator;
};

/// "25.5 kDa".
QString massText(double dalton);

}  // namespace velum::gui
