#include "ModelList.h"

#include <QContextMenuEvent>
#include <QHeaderView>
#include <QMouseEvent>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <algorithm>

#include "kit/RowPaint.h"

namespace velum::gui {

namespace {

constexpr int kRowHeight = 25;
constexpr int kWidths[ModelTree::kColumns] = {28, 22, 0, 62};
constexpr std::size_t kMostOpen = 80;  // types of a tree that is opened whole

class Delegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {40, kRowHeight}; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    int column = index.column();
    paintRowGround(*painter, option, column == 0, column == ModelTree::kColumns - 1);
    auto shown = ModelTree::Shown(index.data(ModelTree::VisibleRole).toInt());
    QRectF box(option.rect);
    if (column == ModelTree::Eye)
      paintEye(*painter, box, rowTextColor(option, shown == ModelTree::All), shown != ModelTree::None);
    if (column == ModelTree::Swatch) paintColor(*painter, option, index, shown != ModelTree::None);
    if (column == ModelTree::Name) paintText(*painter, option, index, shown != ModelTree::None, Qt::AlignLeft);
    if (column == ModelTree::Count) paintText(*painter, option, index, false, Qt::AlignRight);
    painter->restore();
  }

 private:
  static void paintColor(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                         bool visible) {
    auto color = index.data(ModelTree::ColorRole).value<QColor>();
    if (!color.isValid()) return;
    if (!visible) color.setAlphaF(0.35f);
    QPointF c = QRectF(option.rect).center();
    paintSwatch(painter, QRectF(c - QPointF(6.5, 6.5), QSizeF(13, 13)), color, QColor(0, 0, 0, 70));
  }
  static void paintText(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index, bool strong,
                        Qt::Alignment alignment) {
    QRect box = option.rect.adjusted(4, 0, -4, 0);
    QFont font = option.font;
    if (alignment == Qt::AlignLeft && !index.data(TypeTree::IsTypeRole).toBool()) font.setWeight(QFont::DemiBold);
    painter.setFont(font);
    QString text = QFontMetrics(font).elidedText(index.data().toString(), Qt::ElideMiddle, box.width());
    painter.setPen(rowTextColor(option, strong));
    painter.drawText(box, alignment | Qt::AlignVCenter, text);
  }
};

}  // namespace

ModelList::ModelList(ModelCommands& commands, QWidget* parent)
    : QTreeView(parent), mCommands(commands), mTree(new ModelTree(this)), mOrder(new TypeOrder(this)) {
  setObjectName("modelList");
  setAccessibleName(tr("Types of the model"));
  setToolTip(tr("Compartments and types of the model: shown, colour, name, number of instances"));
  mOrder->setSourceModel(mTree);
  setModel(mOrder);
  setItemDelegate(new Delegate(this));
  setTreePosition(ModelTree::Name);
  setIndentation(11);
  setUniformRowHeights(true);
  setHeaderHidden(true);
  setMouseTracking(true);
  setAllColumnsShowFocus(true);
  setExpandsOnDoubleClick(false);
  setSelectionMode(ExtendedSelection);
  setEditTriggers(NoEditTriggers);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollMode(ScrollPerPixel);
  verticalScrollBar()->setSingleStep(kRowHeight);
  setMinimumHeight(8 * kRowHeight);
  header()->setStretchLastSection(false);
  header()->setMinimumSectionSize(10);
  for (int i = 0; i < ModelTree::kColumns; ++i) {
    header()->setSectionResizeMode(i, i == ModelTree::Name ? QHeaderView::Stretch : QHeaderView::Fixed);
    if (kWidths[i]) header()->resizeSection(i, kWidths[i]);
  }
}

/// All of a small tree; of a large one what is left of the search, or its first two floors.
void ModelList::openSome() {
  bool isSmall = mTree->model() && mTree->model()->types.size() <= kMostOpen;
  isSmall || mOrder->isSearching() ? expandAll() : expandToDepth(1);
}

void ModelList::showLayer(const scene::ModelLayer& layer) {
  bool isOther = mTree->model() != layer.data;
  mTree->showLayer(layer);
  if (isOther) openSome();
}

void ModelList::setSearch(const QString& text) {
  bool was = mOrder->isSearching();
  mOrder->setSearch(text);
  if (was || mOrder->isSearching()) openSome();
}

const TypeTree::Row& ModelList::rowOf(const QModelIndex& shown) const {
  return mTree->rowAt(mOrder->mapToSource(shown));
}

session::TypeNumbers ModelList::selectedTypes() const {
  session::TypeNumbers types;
  for (const auto& index : selectionModel()->selectedRows()) {
    const auto& more = rowOf(index).types;
    types.insert(types.end(), more.begin(), more.end());
  }
  std::sort(types.begin(), types.end());
  types.erase(std::unique(types.begin(), types.end()), types.end());
  return types;
}

session::TypeNumbers ModelList::listedTypes() const {
  session::TypeNumbers types;
  int count = mTree->model() ? int(mTree->model()->types.size()) : 0;
  for (int i = 0; i < count; ++i)
    if (mOrder->mapFromSource(mTree->indexOfType(i, 0)).isValid()) types.push_back(std::uint32_t(i));
  return types;
}

void ModelList::selectType(int type) {
  mIsQuiet = true;
  QModelIndex index = mOrder->mapFromSource(mTree->indexOfType(type, ModelTree::Name));
  bool isThere = index.isValid() && currentIndex().siblingAtColumn(ModelTree::Name) == index &&
                 selectionModel()->isRowSelected(index.row(), index.parent());
  if (!index.isValid()) {
    // A compartment that was selected here is no type, and stays.
    if (currentIndex().isValid() && rowOf(currentIndex()).isType) selectionModel()->clear();
  } else if (!isThere) {
    setCurrentIndex(index);
    scrollTo(index);
  }
  mIsQuiet = false;
}

QRect ModelList::cellOfType(int type, ModelTree::Column column) const {
  return visualRect(mOrder->mapFromSource(mTree->indexOfType(type, column)));
}

void ModelList::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
  QTreeView::currentChanged(current, previous);
  if (mIsQuiet || !current.isValid()) return;
  const TypeTree::Row& row = rowOf(current);
  emit picked(row.isType ? int(row.number) : -1);
}

/// All that are selected, when the row is one of them; else the row alone.
session::TypeNumbers ModelList::typesFor(const QModelIndex& shown) const {
  return selectionModel()->isRowSelected(shown.row(), shown.parent()) ? selectedTypes() : rowOf(shown).types;
}

bool ModelList::pressCell(const QModelIndex& index, QMouseEvent* event) {
  if (index.column() == ModelTree::Eye) {
    if (event->modifiers() & Qt::AltModifier)
      mCommands.toggleSolo(typesFor(index));
    else
      mCommands.setVisible(typesFor(index), index.data(ModelTree::VisibleRole).toInt() == ModelTree::None);
    return true;
  }
  if (index.column() != ModelTree::Swatch || !rowOf(index).isType) return false;
  mCommands.chooseColor(typesFor(index), window());
  return true;
}

void ModelList::mousePressEvent(QMouseEvent* event) {
  QModelIndex index = indexAt(event->position().toPoint());
  mIsHeld = event->button() == Qt::LeftButton && index.isValid() && pressCell(index, event);
  if (!mIsHeld) QTreeView::mousePressEvent(event);
}

void ModelList::mouseMoveEvent(QMouseEvent* event) {
  if (!mIsHeld) QTreeView::mouseMoveEvent(event);
}

void ModelList::mouseReleaseEvent(QMouseEvent* event) {
  if (!mIsHeld) QTreeView::mouseReleaseEvent(event);
  mIsHeld = false;
}

void ModelList::mouseDoubleClickEvent(QMouseEvent* event) {
  QModelIndex index = indexAt(event->position().toPoint());
  bool isName = index.column() == ModelTree::Name || index.column() == ModelTree::Count;
  if (index.isValid() && isName && visualRect(index).contains(event->position().toPoint()))
    return mCommands.goTo(rowOf(index).types);
  mousePressEvent(event);  // two quick clicks on an eye are two clicks
}

bool ModelList::event(QEvent* event) {
  // The list's own keys go before commands of the window that have the same.
  if (event->type() == QEvent::ShortcutOverride) {
    int key = static_cast<QKeyEvent*>(event)->key();
    constexpr int kOwn[] = {Qt::Key_Space, Qt::Key_Return, Qt::Key_Enter,
                            Qt::Key_Delete};  // Del would remove a cut that nobody thinks of here
    if (std::find(std::begin(kOwn), std::end(kOwn), key) != std::end(kOwn)) event->accept();
  }
  return QTreeView::event(event);
}

void ModelList::keyPressEvent(QKeyEvent* event) {
  session::TypeNumbers types = selectedTypes();
  if (!types.empty() && event->key() == Qt::Key_Space) {
    if (event->modifiers() & Qt::AltModifier) return mCommands.toggleSolo(types);
    return mCommands.setVisible(types, currentIndex().data(ModelTree::VisibleRole).toInt() == ModelTree::None);
  }
  bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (!types.empty() && isEnter) return mCommands.goTo(types);
  QTreeView::keyPressEvent(event);
}

void ModelList::contextMenuEvent(QContextMenuEvent* event) {
  bool isMouse = event->reason() == QContextMenuEvent::Mouse;
  QModelIndex index = isMouse ? indexAt(event->pos()) : currentIndex();
  if (!index.isValid()) return;
  session::TypeNumbers types = typesFor(index);
  bool isRow = types == rowOf(index).types;
  QMenu menu(this);
  mCommands.fillMenu(menu, types, isRow ? rowOf(index).name : tr("%n types", nullptr, int(types.size())));
  menu.exec(isMouse ? event->globalPos() : viewport()->mapToGlobal(visualRect(index).center()));
}

}  // namespace velum::gui
