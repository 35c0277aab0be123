#include "gui/model/ModelTree.h"

#include <fmt/format.h>

#include <QLocale>
#include <algorithm>

#include "gui/kit/Text.h"
#include "gui/rows/CountBar.h"
#include "scene/Shown.h"
#include "session/model/InstanceNumber.h"
#include "session/model/ModelEdit.h"

namespace velum::gui {

namespace {

constexpr int kMostTip = 400;  // letters of a description

QString numberText(std::uint64_t number) { return QLocale().toString(qulonglong(number)); }

/// With as many digits as there is room for in a narrow column.
QString shortCount(std::uint64_t count) {
  if (count < 100000) return numberText(count);
  if (count < 1000000) return ModelTree::tr("%1k").arg(QString::number(double(count) * 1e-3, 'f', 0));
  return ModelTree::tr("%1M").arg(QString::number(double(count) * 1e-6, 'f', count < 100000000 ? 1 : 0));
}

}  // namespace

ModelTree::ModelTree(const Equalizer& equalizer, QObject* parent)
    : TypeTree(kColumns, Name, parent), mEqualizer(equalizer) {}

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
  if (!rows().empty()) mScale.most = double(rows().front().instances) * scene::copyCount(layer);
  if (!isOther) tellCells(Eye, Count, {VisibleRole, ColorRole, HeldRole, Qt::AccessibleTextRole});
}

void ModelTree::showCounts() {
  QList<int> roles;
  for (std::size_t i = 0; i < kCountKinds.size(); ++i) roles << partRole(CountOf(i));
  tellCells(Bar, Count, roles);
}

void ModelTree::setPercent(bool percent) {
  mScale.isPercent = percent;
  showCounts();
}

Counts ModelTree::countOf(const Row& row) const {
  if (!mEqualizer.heldPath().empty() && mEqualizer.heldPath() == row.path) return mEqualizer.heldCount();
  const session::LiveCounts& counts = mEqualizer.counts();
  if (counts.model() != model()) return {};
  return row.isType ? counts.types()[row.number] : counts.compartments()[row.number];
}

QString ModelTree::numberOf(const Row& row) const {
  Counts count = countOf(row);
  if (count.total() == 0) return shortCount(row.instances * std::uint64_t(scene::copyCount(mLayer)));
  if (!mScale.isPercent) return shortCount(count.left());
  double percent = 100.0 * double(count.left()) / double(count.total());
  // What is a little is not nothing, and what is nearly all is not all.
  bool isEdge = (percent > 0.0 && percent < 1.0) || (percent > 99.0 && percent < 100.0);
  return tr("%1 %").arg(QLocale().toString(percent, 'f', isEdge ? 1 : 0));
}

std::optional<double> ModelTree::readNumber(const QString& text, double total) {
  QString number = text.trimmed();
  bool isPercent = number.endsWith('%');
  if (isPercent) number = number.chopped(1).trimmed();
  number.remove(QChar(0xa0)).remove(' ');
  bool isRead = false;
  double value = QLocale().toDouble(number, &isRead);
  if (!isRead) value = QLocale::c().toDouble(number, &isRead);
  if (!isRead) return std::nullopt;
  return session::instanceNumber(fmt::format("{}{}", value, isPercent ? "%" : ""), total);
}

QString ModelTree::describe(const Counts& count) const {
  auto share = [&](std::uint64_t part) {
    return tr("%1 (%2 %)").arg(numberText(part)).arg(100.0 * double(part) / double(count.total()), 0, 'f', 1);
  };
  QString about = mEqualizer.counts().isExact() ? QString() : tr(", about, while the picture is coarse");
  QStringList lines;
  for (std::size_t i = 0; i < kCountKinds.size(); ++i)
    lines << tr("%1: %2%3").arg(toText(kCountKinds[i].instances), share(count.parts[i]), i == 0 ? about : QString());
  return lines.join("\n");
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
  if (column == Bar || column == Count) {
    QString held = session::isHeld(mLayer, row.path) ? "\n" + heldText(row.path) : QString();
    QString how = column == Bar ? tr("Drag the right knob to set how many are drawn, the left one how many are seen "
                                     "(Ctrl+Right, Ctrl+Left; with Shift: seen)")
                                : tr("How many are drawn: double-click or F2 to type another number, or a share in %");
    Counts count = countOf(row);
    return (count.total() > 0 ? describe(count) + "\n" + how : how) + held;
  }
  if (row.isType) return QString("%1\n%2").arg(toText(row.path), describe(model()->types[row.number]));
  return QString("%1\n%2\n%3")
      .arg(toText(row.path), tr("%1 instances of %2 types").arg(numberText(row.instances)).arg(row.types.size()),
           row.mass > 0.0 ? tr("%1 in all").arg(massText(row.mass)) : tr("mass unknown"));
}

/// Says which number the scene holds for a row.
QString ModelTree::heldText(const std::string& path) const {
  const scene::TypeTarget* target = session::targetOf(mLayer, path);
  if (!target) return {};
  if (target->visible) return tr("To be seen: %1, set by hand").arg(numberText(std::uint64_t(*target->visible)));
  return tr("Drawn: %1, set by hand: it stays when the number of its group is set")
      .arg(numberText(std::uint64_t(target->rendered.value_or(0.0))));
}

QVariant ModelTree::data(const QModelIndex& index, int role) const {
  const Row& row = rowAt(index);
  if (role >= PartRole && role < kOwnRole) {
    Counts count = countOf(row);
    return count.total() == 0 ? 0.0 : double(count.parts[std::size_t(role - PartRole)]) / double(count.total());
  }
  switch (role) {
    case Qt::DisplayRole:
      if (index.column() == Count) return numberOf(row);
      break;
    case Qt::ToolTipRole:
      return tipOf(row, index.column());
    case Qt::AccessibleTextRole:
      return tr("%1, %2").arg(row.name, shownOf(row) == All    ? tr("shown")
                                        : shownOf(row) == None ? tr("hidden")
                                                               : tr("partly shown"));
    case VisibleRole:
      return int(shownOf(row));
    case HeldRole:
      return session::isHeld(mLayer, row.path);
    case ColorRole:
      return row.isType ? mColors[row.number] : QColor();
    default:
      break;
  }
  return TypeTree::data(index, role);
}

QVariant ModelTree::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  const QString names[kColumns] = {tr("Shown"), tr("Colour"), tr("Name"), countTitle(), tr("Drawn")};
  return names[section];
}

Qt::ItemFlags ModelTree::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = TypeTree::flags(index);
  return index.column() == Count ? flags | Qt::ItemIsEditable : flags;
}

}  // namespace velum::gui
