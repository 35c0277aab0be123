#include "gui/cut/TypeSpareView.h"

#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "gui/cut/TypeSpareDelegate.h"
#include "scene/Scene.h"
#include "session/cut/CutEdit.h"

namespace velum::gui {

namespace {

constexpr int kWidths[TypeSpareTree::kColumns] = {0, 62, 46};
constexpr std::size_t kMostOpen = 80;  // types of a tree that is opened whole

}  // namespace

TypeSpareTree::TypeSpareTree(QObject* parent) : TypeTree(kColumns, Name, parent) {}

void TypeSpareTree::showCut(const Shared<Model>& model, const scene::Cut& cut) {
  bool isOther = model != this->model();
  if (!isOther && cut.model.spares == mShown) return;
  setModel(model);
  mShown = cut.model.spares;
  mShares.assign(rows().size(), 0.0);
  mOwn.assign(rows().size(), false);
  for (std::size_t i = 0; i < rows().size(); ++i) {
    const scene::TypeSpare* own = session::findTypeSpare(cut, rows()[i].path);
    mOwn[i] = own != nullptr;
    mShares[i] = own ? own->share : rows()[i].parent >= 0 ? mShares[std::size_t(rows()[i].parent)] : 0.0;
  }
  tellCells(Name, Percent, {ShareRole, OwnRole, Qt::AccessibleTextRole});
}

QVariant TypeSpareTree::data(const QModelIndex& index, int role) const {
  auto row = std::size_t(index.internalId());
  double percent = row < mShares.size() ? mShares[row] * 100.0 : 0.0;
  switch (role) {
    case Qt::DisplayRole:
      if (index.column() == Percent) return tr("%1 %").arg(std::lround(percent));
      break;
    case Qt::AccessibleTextRole:
      return tr("%1, %2 % are left").arg(rows()[row].name).arg(std::lround(percent));
    case Qt::ToolTipRole:
      return index.column() == Name ? QString::fromStdString(rows()[row].path)
                                    : tr("Share of its instances that the cut leaves: drag to change");
    case ShareRole:
      return percent / 100.0;
    case OwnRole:
      return row < mOwn.size() && mOwn[row];
    default:
      break;
  }
  return TypeTree::data(index, role);
}

TypeSpareView::TypeSpareView(QWidget* parent)
    : BarList(parent), mTree(new TypeSpareTree(this)), mOrder(new TypeOrder(this)) {
  setObjectName("typeSpares");
  setAccessibleName(tr("What the cut leaves of types"));
  setToolTip(tr("How much of each type stays in what the cut removes"));
  mOrder->setSourceModel(mTree);
  setModel(mOrder);
  setItemDelegate(new TypeSpareDelegate(kRowHeight, this));
  setIndentation(11);
  setHeaderHidden(true);
  setEditTriggers(NoEditTriggers);
  layColumns(kWidths, 7);
}

void TypeSpareView::openSome() {
  bool isSmall = mTree->model() && mTree->model()->types.size() <= kMostOpen;
  isSmall || mOrder->isSearching() ? expandAll() : expandToDepth(1);
}

void TypeSpareView::setSearch(const QString& text) {
  mOrder->setSearch(text);
  openSome();
}

std::vector<std::string> TypeSpareView::selectedPaths() const {
  std::vector<std::string> paths;
  for (const auto& index : selectionModel()->selectedRows())
    paths.push_back(mTree->rowAt(mOrder->mapToSource(index)).path);
  return paths;
}

QRect TypeSpareView::cellOfRow(int row, TypeSpareTree::Column column) const {
  return visualRect(mOrder->mapFromSource(mTree->indexOfRow(row, column)));
}

void TypeSpareView::dragKnob(double x) {
  if (!mHeld.isValid()) return;
  QRect cell = visualRect(mHeld);
  double share = (std::trunc(x) - cell.left() - kShareBarMargin) / (cell.width() - 2.0 * kShareBarMargin);
  std::vector<std::string> paths = selectedPaths();
  std::string own = mTree->rowAt(mOrder->mapToSource(mHeld)).path;
  if (std::find(paths.begin(), paths.end(), own) == paths.end()) paths = {own};
  emit dragged(paths, std::round(std::clamp(share, 0.0, 1.0) * 100.0) / 100.0);
}

bool TypeSpareView::pressCell(const QModelIndex& index, QMouseEvent* event) {
  if (index.column() != TypeSpareTree::Bar) return false;
  selectRowOf(index, TypeSpareTree::Name);
  mHeld = index;
  holdKnob(event->position().x());
  return true;
}

void TypeSpareView::letKnobGo() {
  mHeld = QModelIndex();
  emit settled();
}

}  // namespace velum::gui
