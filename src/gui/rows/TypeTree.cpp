#include "gui/rows/TypeTree.h"

#include <QLocale>
#include <algorithm>

#include "gui/kit/Text.h"
#include "scene/ModelLayer.h"

namespace velum::gui {

QString massText(double dalton) {
  auto number = [](double value) { return QLocale().toString(value, 'g', value < 1000.0 ? 3 : 4); };
  if (dalton < 1e3) return QString("%1 Da").arg(number(dalton));
  if (dalton < 1e6) return QString("%1 kDa").arg(number(dalton * 1e-3));
  if (dalton < 1e9) return QString("%1 MDa").arg(number(dalton * 1e-6));
  return QString("%1 GDa").arg(QLocale().toString(dalton * 1e-9, 'g', 4));
}

TypeTree::TypeTree(int columns, int nameColumn, QObject* parent)
    : QAbstractItemModel(parent), mColumns(columns), mNameColumn(nameColumn) {}

bool TypeTree::setModel(const Shared<Model>& model) {
  if (model == mModel) return false;
  beginResetModel();
  mModel = model;
  mRows.clear();
  mRowOfType.clear();
  if (mModel) makeRows();
  endResetModel();
  return true;
}

bool TypeTree::showNames(const scene::ModelLayer& layer) {
  bool isOther = false;
  for (Row& row : mRows) {
    std::string own = scene::ownName(layer, row.path);
    QString name = own.empty() ? row.fileName : toText(own);
    if (name == row.name) continue;
    row.name = name;
    isOther = true;
  }
  if (isOther) tellCells(mNameColumn, mNameColumn, {Qt::DisplayRole, NameRole, Qt::ToolTipRole});
  return isOther;
}

int TypeTree::addRow(Row row) {
  int at = int(mRows.size());
  row.fileName = row.name;
  if (row.parent >= 0) {
    Row& parent = mRows[std::size_t(row.parent)];
    row.place = int(parent.children.size());
    row.path = parent.path + "." + row.path;
    parent.children.push_back(at);
  }
  mRows.push_back(std::move(row));
  return at;
}

void TypeTree::makeRows() {
  const Model& model = *mModel;
  // Compartments stand before their children: from the last to the first, those with a type below have a row.
  std::vector<bool> isNeeded(model.compartments.size());
  for (const MoleculeType& type : model.types) isNeeded[type.compartment] = true;
  for (std::size_t i = isNeeded.size(); i-- > 1;)
    if (isNeeded[i]) isNeeded[std::size_t(model.compartments[i].parent)] = true;
  std::vector<int> rowOf(model.compartments.size(), -1);
  for (std::uint32_t i = 0; i < isNeeded.size(); ++i) {
    if (i > 0 && !isNeeded[i]) continue;
    const Compartment& one = model.compartments[i];
    Row row;
    row.number = i;
    row.parent = one.parent < 0 ? -1 : rowOf[std::size_t(one.parent)];
    row.path = one.name;
    row.name = one.parent < 0 ? tr("All types") : nameText(one.name);
    rowOf[i] = addRow(std::move(row));
  }
  for (std::uint32_t i = 0; i < model.types.size(); ++i) {
    const MoleculeType& type = model.types[i];
    Row row;
    row.isType = true;
    row.number = i;
    row.parent = rowOf[type.compartment];
    row.path = type.name;
    row.name = nameText(type.name);
    row.mass = type.mass;
    mRowOfType.push_back(addRow(std::move(row)));
    for (int at = mRowOfType.back(); at >= 0; at = mRows[std::size_t(at)].parent) {
      Row& above = mRows[std::size_t(at)];
      above.types.push_back(i);
      above.instances += type.instanceCount;
      if (!above.isType) above.mass += type.mass * type.instanceCount;
    }
  }
}

QModelIndex TypeTree::indexOfRow(int row, int column) const {
  if (row < 0 || row >= int(mRows.size())) return {};
  return createIndex(mRows[std::size_t(row)].place, column, quintptr(row));
}

QModelIndex TypeTree::indexOfType(int type, int column) const {
  return type < 0 || type >= int(mRowOfType.size()) ? QModelIndex() : indexOfRow(mRowOfType[std::size_t(type)], column);
}

QModelIndex TypeTree::index(int row, int column, const QModelIndex& parent) const {
  if (column < 0 || column >= mColumns || row < 0 || mRows.empty()) return {};
  if (!parent.isValid()) return row == 0 ? createIndex(0, column, quintptr(0)) : QModelIndex();
  const Row& above = rowAt(parent);
  return row < int(above.children.size()) ? createIndex(row, column, quintptr(above.children[std::size_t(row)]))
                                          : QModelIndex();
}

QModelIndex TypeTree::parent(const QModelIndex& child) const {
  return child.isValid() ? indexOfRow(rowAt(child).parent, 0) : QModelIndex();
}

int TypeTree::rowCount(const QModelIndex& parent) const {
  if (!parent.isValid()) return mRows.empty() ? 0 : 1;
  return parent.column() == 0 ? int(rowAt(parent).children.size()) : 0;
}

QVariant TypeTree::data(const QModelIndex& index, int role) const {
  const Row& row = rowAt(index);
  switch (role) {
    case Qt::DisplayRole:
      return index.column() == mNameColumn ? QVariant(row.name) : QVariant();
    case NameRole:
      return row.name;
    case FileNameRole:
      return row.fileName;
    case CountRole:
      return qulonglong(row.instances);
    case MassRole:
      return row.mass;
    case IsTypeRole:
      return row.isType;
    default:
      return {};
  }
}

void TypeTree::tellCells(int firstColumn, int lastColumn, const QList<int>& roles) {
  if (mRows.empty()) return;
  emit dataChanged(indexOfRow(0, firstColumn), indexOfRow(0, lastColumn), roles);
  for (const Row& row : mRows)
    if (!row.children.empty())
      emit dataChanged(indexOfRow(row.children.front(), firstColumn), indexOfRow(row.children.back(), lastColumn),
                       roles);
}

TypeOrder::TypeOrder(QObject* parent) : QSortFilterProxyModel(parent) {
  mCollator.setNumericMode(true);
  mCollator.setCaseSensitivity(Qt::CaseInsensitive);
  setRecursiveFilteringEnabled(true);
  setAutoAcceptChildRows(true);
  sort(0);
}

void TypeOrder::setKey(Key key) {
  mKey = key;
  invalidate();
}

void TypeOrder::setOnly(Only only) {
  mOnly = only;
  invalidateFilter();
}

void TypeOrder::look() {
  if (mOnly != Only::All || mKey >= Key::Part) invalidate();
}

bool TypeOrder::isAsAsked(const QModelIndex& row) const {
  if (mOnly == Only::All) return true;
  if (!row.data(TypeTree::IsTypeRole).toBool()) return false;  // stays where one below it does
  if (mOnly == Only::Removed) return row.data(TypeTree::partRole(CountOf::Clipped)).toDouble() > 0.0;
  bool isSeen = false;
  for (std::size_t kind = 0; kind < kCountKinds.size(); ++kind)
    isSeen |= kCountKinds[kind].isSeen && row.data(TypeTree::partRole(CountOf(kind))).toDouble() > 0.0;
  return isSeen == (mOnly == Only::Seen);
}

void TypeOrder::setSearch(const QString& text) {
  mWords = text.simplified().split(' ', Qt::SkipEmptyParts);
  invalidateFilter();
}

bool TypeOrder::filterAcceptsRow(int row, const QModelIndex& parent) const {
  QModelIndex index = sourceModel()->index(row, 0, parent);
  if (!isAsAsked(index)) return false;
  if (mWords.isEmpty()) return true;
  QString own = index.data(TypeTree::NameRole).toString(), inFile = index.data(TypeTree::FileNameRole).toString();
  return std::all_of(mWords.begin(), mWords.end(), [&](const QString& word) {
    return own.contains(word, Qt::CaseInsensitive) || inFile.contains(word, Qt::CaseInsensitive);
  });
}

bool TypeOrder::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  if (bool isType = left.data(TypeTree::IsTypeRole).toBool(); isType != right.data(TypeTree::IsTypeRole).toBool())
    return !isType;  // compartments first
  if (mKey != Key::Name) {
    int role = mKey == Key::Count  ? int(TypeTree::CountRole)
               : mKey == Key::Mass ? int(TypeTree::MassRole)
                                   : TypeTree::PartRole + int(mKey) - int(Key::Part);
    double a = left.data(role).toDouble(), b = right.data(role).toDouble();
    if (a != b) return a > b;  // the most first
  }
  return mCollator.compare(left.data(TypeTree::NameRole).toString(), right.data(TypeTree::NameRole).toString()) < 0;
}

}  // namespace velum::gui
