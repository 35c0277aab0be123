#include "gui/structure/StructureModel.h"

#include <QColor>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/Text.h"
#include "gui/kit/Text.h"
#include "gui/kit/Words.h"
#include "gui/rows/Amounts.h"

namespace velum::gui {

StructureModel::StructureModel(const StructureMeter& meter, const AreaMeter& areas, QObject* parent)
    : QAbstractTableModel(parent), mMeter(meter), mAreas(areas) {}

void StructureModel::setRows(const std::vector<scene::Structure>& rows, std::optional<int> solo) {
  bool sameIds = std::equal(rows.begin(), rows.end(), mRows.begin(), mRows.end(),
                            [](const auto& a, const auto& b) { return a.id == b.id; });
  if (!sameIds) {
    beginResetModel();
    mRows = rows;
    mSolo = solo;
    endResetModel();
    return;
  }
  int first = -1, last = -1;
  for (int i = 0; i < int(rows.size()); ++i) {
    const scene::Structure& now = rows[std::size_t(i)];
    bool soloChanged = solo != mSolo && (solo == now.id || mSolo == now.id);
    if (!soloChanged && now == mRows[std::size_t(i)]) continue;
    mRows[std::size_t(i)] = now;
    if (first < 0) first = i;
    last = i;
  }
  mSolo = solo;
  if (first >= 0) emit dataChanged(index(first, 0), index(last, kColumns - 1));
}

void StructureModel::setLengthUnit(LengthUnit unit) {
  if (std::exchange(mLengthUnit, unit) != unit) sizesChanged();
}

void StructureModel::sizesChanged() {
  // Only that column: a name that is being typed must not be set back.
  if (!mRows.empty()) emit dataChanged(index(0, Size), index(int(mRows.size()) - 1, Size));
}

void StructureModel::valuesChanged() {
  emit headerDataChanged(Qt::Horizontal, Mean, Most);
  if (!mRows.empty()) emit dataChanged(index(0, Mean), index(int(mRows.size()) - 1, Most));
}

void StructureModel::areasChanged() {
  if (!mRows.empty()) emit dataChanged(index(0, Bar), index(int(mRows.size()) - 1, Bar));
}

CountBar StructureModel::barOf(int id, QRect cell) const {
  const Counts* area = mAreas.find(id);
  return area ? layCountBar(cell, BarScale(), *area) : CountBar{};
}

int StructureModel::rowOf(int id) const {
  auto found = std::find_if(mRows.begin(), mRows.end(), [id](const auto& row) { return row.id == id; });
  return found == mRows.end() ? -1 : int(found - mRows.begin());
}

int StructureModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(mRows.size()); }
int StructureModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QString StructureModel::sizeText(int id) const {
  const session::StructureSize* size = mMeter.find(id);
  return size                   ? volumeText(1e3 * size->volume, mLengthUnit)
         : mMeter.isMeasuring() ? QString()
                                : QString::fromUtf8("\u2013");
}

QString StructureModel::valueText(int id, Column column) const {
  const session::StructureValues* values = mMeter.findValues(id);
  if (!values) return mMeter.isMeasuringValues() ? QString() : QString::fromUtf8("\u2013");
  return localNumber(tidyNumber(column == Mean ? values->mean : values->most));
}

/// The tip with the scan's values in a structure; empty where they have not been measured.
QString StructureModel::valuesTip(int id) const {
  const session::StructureValues* values = mMeter.findValues(id);
  if (!values) return {};
  auto number = [](double value) { return localNumber(tidyNumber(value)); };
  QString unit = mMeter.valueUnit().isEmpty() ? QString() : " " + mMeter.valueUnit();
  return "\n" + tr("Values: mean %1%5, deviation %2%5, from %3%5 to %4%5, of %6 voxels of the scan")
                    .arg(number(values->mean), number(values->deviation), number(values->least), number(values->most),
                         unit, QLocale().toString(qulonglong(values->voxels)));
}

QString StructureModel::tipOf(const scene::Structure& structure, int column) const {
  switch (column) {
    case Eye:
      return structure.visible ? tr("Shown: click to hide, Alt+click to show it alone")
                               : tr("Hidden: click to show, Alt+click to show it alone");
    case Swatch:
      return tr("Click to choose another colour");
    case Opacity:
      return tr("Opacity %1 %: drag to change").arg(std::lround(structure.opacity * 100.0));
    case Bar: {
      const Counts* area = mAreas.find(structure.id);
      if (!area || area->total() == 0)
        return tr("How much of it is seen, hidden and removed: it is not in the picture");
      QStringList shares;
      for (std::size_t i = 0; i < kCountKinds.size(); ++i)
        shares << wordsOf(kCountKinds[i].pixels)
                      .arg(QLocale().toString(100.0 * double(area->parts[i]) / double(area->total()), 'f', 1));
      return tr("Of where it would be in the picture, %1.\nDrag the knob to pull it out of the cuts (Ctrl+Right, "
                "Ctrl+Left)")
          .arg(shares.join(", "));
    }
    case Solo:
      return mSolo == structure.id ? tr("Shown alone: click to show what was shown before") : tr("Show it alone");
    default:
      break;
  }
  QString tip = QString("%1\n%2").arg(data(index(rowOf(structure.id), Name), Qt::DisplayRole).toString(),
                                      tr("Number %1").arg(structure.id));
  if (const session::StructureSize* size = mMeter.find(structure.id))
    tip += "\n" + tr("%1 voxels, %2, surface %3")
                      .arg(QLocale().toString(qulonglong(size->voxels)), volumeText(1e3 * size->volume, mLengthUnit),
                           areaText(1e2 * size->surface, mLengthUnit));
  else if (!mMeter.isMeasuring())
    tip += "\n" + tr("No voxel has this number");
  return tip + valuesTip(structure.id) + "\n" + tr("Double click: go there. F2: rename");
}

QVariant StructureModel::data(const QModelIndex& index, int role) const {
  const scene::Structure& row = mRows[std::size_t(index.row())];
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      if (index.column() == Size) return sizeText(row.id);
      if (index.column() == Mean || index.column() == Most) return valueText(row.id, Column(index.column()));
      if (index.column() != Name) return {};
      if (row.name.empty() && role == Qt::DisplayRole) return tr("structure %1").arg(row.id);
      return QString::fromStdString(row.name);
    case Qt::ToolTipRole:
      return tipOf(row, index.column());
    case Qt::AccessibleTextRole:
      return tr("%1, %2").arg(data(this->index(index.row(), Name), Qt::DisplayRole).toString(),
                              row.visible ? tr("shown") : tr("hidden"));
    case IdRole:
      return row.id;
    case VisibleRole:
      return row.visible;
    case ColorRole:
      return QColor::fromRgbF(std::clamp(row.color.r, 0.0f, 1.0f), std::clamp(row.color.g, 0.0f, 1.0f),
                              std::clamp(row.color.b, 0.0f, 1.0f));
    case OpacityRole:
      return row.opacity;
    case SoloRole:
      return mSolo == row.id;
    case VoxelsRole: {
      const session::StructureSize* size = mMeter.find(row.id);
      return qulonglong(size ? size->voxels : 0);
    }
    case AbsentRole:
      return mMeter.isAbsent(row.id);
    case MeanRole:
    case MostRole: {
      const session::StructureValues* values = mMeter.findValues(row.id);
      return values ? QVariant(role == MeanRole ? values->mean : values->most) : QVariant();
    }
    default:
      return {};
  }
}

QVariant StructureModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  bool isText = section == Size || section == Mean || section == Most;
  if (role == Qt::TextAlignmentRole) return int(Qt::AlignVCenter | (isText ? Qt::AlignRight : Qt::AlignLeft));
  // The names of narrow columns are not shown, but screen readers say them.
  bool isShown = role == Qt::DisplayRole && (isText || section == Name);
  if (!isShown && role != Qt::AccessibleTextRole && role != Qt::ToolTipRole) return {};
  QString unit = mMeter.valueUnit();
  bool isUptake = unit.startsWith("SUV");
  auto withUnit = [&](const QString& name) { return unit.isEmpty() ? name : QString("%1, %2").arg(name, unit); };
  const QString names[kColumns] = {tr("Shown"),
                                   tr("Colour"),
                                   tr("Name"),
                                   tr("Size"),
                                   isUptake ? tr("SUVmean") : withUnit(tr("Mean")),
                                   isUptake ? tr("SUVmax") : withUnit(tr("Max")),
                                   tr("Opacity"),
                                   tr("Solo"),
                                   countTitle()};
  return names[section];
}

bool StructureModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || index.column() != Name) return false;
  emit renamed(mRows[std::size_t(index.row())].id, value.toString());
  return true;
}

Qt::ItemFlags StructureModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
  return index.column() == Name ? flags | Qt::ItemIsEditable : flags;
}

StructureOrder::StructureOrder(QObject* parent) : QSortFilterProxyModel(parent) {
  mCollator.setNumericMode(true);
  mCollator.setCaseSensitivity(Qt::CaseInsensitive);
  sort(0);
}

void StructureOrder::setKey(Key key) {
  if (mKey == key) return;
  mKey = key;
  invalidate();
}

void StructureOrder::setSearch(const QString& text) {
  mWords = text.simplified().split(' ', Qt::SkipEmptyParts);
  invalidateFilter();
}

void StructureOrder::setAbsentShown(bool shown) {
  if (mIsAbsentShown == shown) return;
  mIsAbsentShown = shown;
  invalidateFilter();
}

bool StructureOrder::filterAcceptsRow(int row, const QModelIndex& parent) const {
  QModelIndex index = sourceModel()->index(row, StructureModel::Name, parent);
  if (!mIsAbsentShown && index.data(StructureModel::AbsentRole).toBool()) return false;
  if (mWords.isEmpty()) return true;
  if (mWords.size() == 1 && QString::number(index.data(StructureModel::IdRole).toInt()) == mWords[0]) return true;
  QString name = index.data().toString();
  return std::all_of(mWords.begin(), mWords.end(),
                     [&](const QString& word) { return name.contains(word, Qt::CaseInsensitive); });
}

bool StructureOrder::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  if (mKey == Key::Name) {
    auto name = [](const QModelIndex& index) { return index.siblingAtColumn(StructureModel::Name).data().toString(); };
    if (int order = mCollator.compare(name(left), name(right)); order != 0) return order < 0;
  }
  if (mKey == Key::Size) {
    auto voxels = [](const QModelIndex& index) { return index.data(StructureModel::VoxelsRole).toULongLong(); };
    if (voxels(left) != voxels(right)) return voxels(left) > voxels(right);  // the largest first
  }
  if (mKey == Key::Mean || mKey == Key::Most) {
    int role = mKey == Key::Mean ? StructureModel::MeanRole : StructureModel::MostRole;
    QVariant a = left.data(role), b = right.data(role);
    if (a.isValid() != b.isValid()) return a.isValid();
    if (a.toDouble() != b.toDouble()) return a.toDouble() > b.toDouble();  // the largest first
  }
  return left.data(StructureModel::IdRole).toInt() < right.data(StructureModel::IdRole).toInt();
}

}  // namespace velum::gui
