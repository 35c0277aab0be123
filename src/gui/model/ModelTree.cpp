#include "ModelTree.h"

#include <QLocale>
#include <algorithm>

#include "velum/session/model/ModelEdit.h"

namespace velum::gui {

namespace {

constexpr int kMostTip = 400;  // letters of a description

QString toText(const std::string& text) { return QString::fromStdString(text); }

QString numberText(std::uint64_t number) { return QLocale().toString(qulonglong(number)); }

/// With as many digits as there is room for in a narrow column.
QString shortCount(std::uint64_t count) {
  if (count < 100000) return numberText(count);
  if (count < 1000000) return ModelTree::tr("%1k").arg(QString::number(double(count) * 1e-3, 'f', 0));
  return ModelTree::tr("%1M").arg(QString::number(double(count) * 1e-6, 'f', count < 100000000 ? 1 : 0));
}

}  // namespace

ModelTree::ModelTree(QObject* parent) : TypeTree(kColumns, Name, parent) {}

void ModelTree::showLayer(const scene::ModelLayer& layer) {
  if (layer == mLayer) return;
  bool isOther = layer.data != mLayer.data;
  mLayer = layer;
  mVisible = session::visibleTypes(layer);
  mOwnColors = session::ownColors(layer);
  mShownCount = int(std::count(mVisible.begin(), mVisible.end(), true));
  mColors.clear();
  for (glm::vec3 color : scene::typeColors(layer)) {
    color = glm::clamp(color, 0.0f, 1.0f);
    mColors.push_back(QColor::fromRgbF(color.r, color.g, color.b));
  }
  setModel(layer.data);
  if (!isOther) tellCells(Eye, Count, {VisibleRole, ColorRole, Qt::AccessibleTextRole});
}

ModelTree::Shown ModelTree::shownOf(const Row& row) const {
  auto isShown = [this](std::uint32_t type) { return mVisible[type]; };
  if (std::none_of(row.types.begin(), row.types.end(), isShown)) return None;
  return std::all_of(row.types.begin(), row.types.end(), isShown) ? All : Some;
}

QString ModelTree::describe(const MoleculeType& type) const {
  QStringList lines;
  std::uint64_t atoms = atomCount(*model(), type), beads = beadCount(*model(), type);
  QString what = tr("%1 instances").arg(numberText(type.instanceCount));
  if (atoms) what += tr(", %1 atoms").arg(numberText(atoms));
  if (beads && !atoms) what += tr(", %1 beads").arg(numberText(beads));
  lines << what;
  if (type.mass > 0.0) {
    QString from = type.massSource == MassSource::File    ? tr("as the file says")
                   : type.massSource == MassSource::Atoms ? tr("of its atoms")
                                                          : tr("from the volume of its beads");
    lines << tr("%1 each, %2").arg(massText(type.mass), from);
  }
  if (type.moleculeCount > 1) lines << tr("%1 shapes").arg(type.moleculeCount);
  if (!type.function.empty()) lines << tr("Function: %1").arg(toText(type.function));
  if (!type.structure.empty()) lines << tr("Structure: %1").arg(toText(type.structure));
  if (type.origin == Origin::Curves) lines << tr("Put along curves of the file");
  if (type.origin == Origin::Added) lines << tr("Not in the file: made to complete the model");
  QString description = toText(type.description).simplified();
  if (description.size() > kMostTip) description = description.left(kMostTip) + QString::fromUtf8("\u2026");
  if (!description.isEmpty()) lines << description;
  return lines.join("\n");
}

QString ModelTree::tipOf(const Row& row, int column) const {
  bool isShown = shownOf(row) != None;
  if (column == Eye)
    return isShown ? tr("Shown: click to hide, Alt+click to show it alone")
                   : tr("Hidden: click to show, Alt+click to show it alone");
  if (column == Swatch && row.isType) return tr("Click to choose another colour");
  if (row.isType) return QString("%1\n%2").arg(toText(row.path), describe(model()->types[row.number]));
  return QString("%1\n%2\n%3")
      .arg(toText(row.path), tr("%1 instances of %2 types").arg(numberText(row.instances)).arg(row.types.size()),
           row.mass > 0.0 ? tr("%1 in all").arg(massText(row.mass)) : tr("mass unknown"));
}

QVariant ModelTree::data(const QModelIndex& index, int role) const {
  const Row& row = rowAt(index);
  switch (role) {
    case Qt::DisplayRole:
      if (index.column() == Count) return shortCount(row.instances);
      break;
    case Qt::ToolTipRole:
      return tipOf(row, index.column());
    case Qt::AccessibleTextRole:
      return tr("%1, %2").arg(row.name, shownOf(row) == All    ? tr("shown")
                                        : shownOf(row) == None ? tr("hidden")
                                                               : tr("partly shown"));
    case VisibleRole:
      return int(shownOf(row));
    case ColorRole:
      return row.isType ? mColors[row.number] : QColor();
    default:
      break;
  }
  return TypeTree::data(index, role);
}

QVariant ModelTree::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  const QString names[kColumns] = {tr("Shown"), tr("Colour"), tr("Name"), tr("Instances")};
  return names[section];
}

}  // namespace velum::gui
