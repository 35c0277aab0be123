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
#include "scene/SceneFwd.h"

namespace velum::gui {

/// The compartments and types of a model as rows of a tree, all below a single root row. Derived classes decide what
/// the columns show. The rows are made once for each model; compartments without types have no row.
class TypeTree : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Role {
    NameRole = Qt::UserRole,
    FileNameRole,
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
    QString name;                      ///< as it is shown: the author's or the file's
    QString fileName;                  ///< as it is shown where the author says nothing
    std::uint64_t instances = 0;       ///< of all types below
    double mass = 0.0;                 ///< of one instance, dalton; for a compartment: of all its instances
    std::vector<std::uint32_t> types;  ///< the row's own type and those of all rows below, ascending
  };

  TypeTree(int columns, int nameColumn, QObject* parent);

  /// @return true when the model is another than before
  bool setModel(const Shared<Model>& model);
  /// Calls the rows as a layer of this model does. @return true when some row has another name than before
  bool showNames(const scene::ModelLayer& layer);
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
  /// Tells that cells of all rows have changed. @param roles  which of the cells' data
  void tellCells(int firstColumn, int lastColumn, const QList<int>& roles);

 private:
  void makeRows();
  int addRow(Row row);

  int mColumns, mNameColumn;
  Shared<Model> mModel;
  std::vector<Row> mRows;       ///< The first is the root's.
  std::vector<int> mRowOfType;  ///< by type
};

/// Sorts, filters and searches the rows of a TypeTree: a search leaves the rows whose name, the author's
/// or the file's, holds all words, and the
/// rows above and below them. The rows' counts are read only when a key or a filter is chosen, and by look(), so that
/// rows do not jump while a bar is dragged.
class TypeOrder : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  enum class Key { Name, Count, Mass, Part };
  /// The share of a kind of kCountKinds.
  static Key keyOf(CountOf kind) { return Key(int(Key::Part) + int(kind)); }
  /// Which types are left: all, or those of which some instances are seen, none is seen, or some are removed.
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
