#include "gui/model/ModelTree.h"

#include <fmt/format.h>

#include <QLocale>
#include <algorithm>

#include "gui/kit/Text.h"
#include "gui/kit/Words.h"
#include "gui/rows/CountBar.h"
#include "scene/Shown.h"
#include "session/model/InstanceNumber.h"
#include "session/model/ModelEdit.h"

namespace velum::gui {

namespace {

constexpr int kMostTip = 400;  // letters of a description

QString numberText(std::uint64_t number) { return QLocale().toString(qulonglong(number)); }

/// The numbers of so many digits that may be the widest: 11..1 to 99..9, and 10..0 to 90..0 where the nought is wide.
std::vector<std::uint64_t> widestOf(int digits) {
  std::uint64_t tens = 1, ones = 1;
  for (int i = 1; i < digits; ++i) tens *= 10, ones = 10 * ones + 1;
  std::vector<std::uint64_t> numbers;
  for (std::uint64_t digit = 1; digit < 10; ++digit) {
    numbers.push_back(digit * ones);
    numbers.push_back(digit * tens);
  }
  return numbers;
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
  showNames(layer);
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

QString ModelTree::drawnText(std::uint64_t drawn, std::uint64_t total, bool isPercent) {
  if (!isPercent) return numberText(drawn);
  // What is a little is not nothing, and what is nearly all is not all.
  if (drawn > 0 && drawn < total && drawn * 1000 < total) return tr("< %1 %").arg(QLocale().toString(0.1, 'f', 1));
  if (drawn < total && drawn * 1000 > total * 999) return tr("> %1 %").arg(QLocale().toString(99.9, 'f', 1));
  double percent = total > 0 ? 100.0 * double(drawn) / double(total) : 0.0;
  bool isEdge = (percent > 0.0 && percent < 1.0) || (percent > 99.0 && percent < 100.0);
  return tr("%1 %").arg(QLocale().toString(percent, 'f', isEdge ? 1 : 0));
}

QString ModelTree::numberOf(const Row& row) const {
  Counts count = countOf(row);
  if (count.total() > 0) return drawnText(count.left(), count.total(), mScale.isPercent);
  return numberText(row.instances * std::uint64_t(scene::copyCount(mLayer)));
}

int ModelTree::widestNumber(const QFontMetrics& metrics) const {
  int widest = metrics.horizontalAdvance(headerData(Count, Qt::Horizontal, Qt::DisplayRole).toString());
  auto take = [&](const QString& text) { widest = std::max(widest, metrics.horizontalAdvance(text)); };
  for (std::uint64_t number : widestOf(int(std::to_string(std::uint64_t(mScale.most)).size())))
    take(numberText(number));
  for (std::uint64_t number : widestOf(3)) {
    take(tr("> %1 %").arg(QLocale().toString(double(number) / 10.0, 'f', 1)));
    take(tr("< %1 %").arg(QLocale().toString(double(number) / 10.0, 'f', 1)));
  }
  take(drawnText(1, 1, true));
  return widest;
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
    return tr("%1 (%L2 %)").arg(numberText(part)).arg(100.0 * double(part) / double(count.total()), 0, 'f', 1);
  };
  QString about = mEqualizer.counts().isExact() ? QString() : tr(", about, while the picture is coarse");
  QStringList lines;
  for (std::size_t i = 0; i < kCountKinds.size(); ++i)
    lines << tr("%1: %2%3").arg(wordsOf(kCountKinds[i].instances), share(count.parts[i]), i == 0 ? about : QString());
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
  if (!type.function.empty()) lines << tr("Function: %1").arg(readableText(type.function));
  if (!type.structure.empty()) lines << tr("Structure: %1").arg(readableText(type.structure));
  if (type.origin == Origin::Curves) lines << tr("Put along curves of the file");
  if (type.origin == Origin::Added) lines << tr("Not in the file: made to complete the model");
  QString description = readableText(type.description).simplified();
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
    QString how = column == Bar
                      ? tr("Drag the right knob to set how many are drawn, the left one how many are seen "
                           "(Ctrl+Right, Ctrl+Left; with Shift: seen)")
                      : tr("How many are drawn: double-click or Shift+F2 to type another number, or a share in %");
    Counts count = countOf(row);
    return (count.total() > 0 ? describe(count) + "\n" + how : how) + held;
  }
  QString path = readableText(row.path);
  if (row.name != row.fileName && row.parent >= 0) path = tr("%1, in the file %2").arg(row.name, path);
  if (row.isType) return QString("%1\n%2").arg(path, describe(model()->types[row.number]));
  return QString("%1\n%2\n%3")
      .arg(path, tr("%1 instances of %2 types").arg(numberText(row.instances)).arg(row.types.size()),
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
  return index.column() == Count || index.column() == Name ? flags | Qt::ItemIsEditable : flags;
}

}  // namespace velum::gui
