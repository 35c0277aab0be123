#include "gui/model/ModelList.h"

#include <QContextMenuEvent>
#include <QHeaderView>
#include <QMouseEvent>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "gui/kit/Text.h"

namespace velum::gui {

namespace {

constexpr int kWidths[ModelTree::kColumns] = {26, 20, 0, 100, 46};
constexpr int kFieldRoom = 10;  // pixels that the field for a number takes beside its text
constexpr int kWordsMs = 4000;
constexpr std::size_t kMostOpen = 80;  // types of a tree that is opened whole

}  // namespace

ModelList::ModelList(ModelCommands& commands, Equalizer& equalizer, QWidget* parent)
    : BarList(parent),
      mCommands(commands),
      mEqualizer(equalizer),
      mTree(new ModelTree(equalizer, this)),
      mOrder(new TypeOrder(this)),
      mDelegate(new ModelDelegate(*mTree, kRowHeight, this)) {
  setObjectName("modelList");
  setAccessibleName(tr("Types of the model"));
  setToolTip(tr("Compartments and types of the model: shown, colour, name, and how many are seen, hidden and removed"));
  setHeader(new ModelHeader(*mTree, this));
  mOrder->setSourceModel(mTree);
  setModel(mOrder);
  setItemDelegate(mDelegate);
  setTreePosition(ModelTree::Name);
  setIndentation(8);
  setExpandsOnDoubleClick(false);
  setEditTriggers(NoEditTriggers);
  layColumns(kWidths, 12);
  connect(mDelegate, &ModelDelegate::typed, this, &ModelList::setTyped);
  connect(mDelegate, &ModelDelegate::renamed, this, &ModelList::setName);
  connect(&mEqualizer, &Equalizer::counted, this, &ModelList::showCounts);
  connect(&mEqualizer, &Equalizer::told, this, &ModelList::sayWords);
}

void ModelList::showCounts() {
  mTree->showCounts();
  if (mEqualizer.counts().isExact() && !mEqualizer.isHeld() && !underMouse()) mOrder->look();
}

/// Shows words beside the row rather than in a banner over the picture.
void ModelList::sayWords(const QString& words) {
  QModelIndex row = mHeldBar.isValid() ? QModelIndex(mHeldBar) : currentIndex();
  QRect cell = visualRect(row.siblingAtColumn(ModelTree::Bar));
  QToolTip::showText(viewport()->mapToGlobal(cell.bottomLeft()), readableText(words.toStdString()), viewport(), {},
                     kWordsMs);
}

void ModelList::setPercent(bool percent) {
  mTree->setPercent(percent);
  header()->viewport()->update();
}

void ModelList::setPointed(int type) {
  mDelegate->setPointed(type);
  viewport()->update();
}

/// Takes the number that was typed into a row as the number that is drawn; a text that is no number changes nothing.
void ModelList::setTyped(const QModelIndex& index, const QString& text) {
  const TypeTree::Row& row = rowOf(index);
  auto number = ModelTree::readNumber(text, double(mTree->countOf(row).total()));
  if (!number) return emit refused(tr("\"%1\" is no number of instances and no share, such as 50 or 20 %").arg(text));
  mEqualizer.set(row.path, Equalizer::Handle::Left, *number);
}

/// Takes the name that was typed into a row; the file's own is no other name.
void ModelList::setName(const QModelIndex& index, const QString& text) {
  const TypeTree::Row& row = rowOf(index);
  QString name = text.simplified();
  if (name != row.name) mCommands.rename(row.path, name == row.fileName ? QString() : name);
}

void ModelList::startRename(const std::string& path) {
  const auto& rows = mTree->rows();
  auto found = std::find_if(rows.begin(), rows.end(), [&](const TypeTree::Row& row) { return row.path == path; });
  if (found == rows.end()) return;
  QModelIndex index = mOrder->mapFromSource(mTree->indexOfRow(int(found - rows.begin()), ModelTree::Name));
  if (!index.isValid()) return;
  setCurrentIndex(index);
  scrollTo(index);
  edit(index);
}

/// Opens all of a small tree; of a large one the rows that the search leaves, or the first two levels.
void ModelList::openSome() {
  bool isSmall = mTree->model() && mTree->model()->types.size() <= kMostOpen;
  isSmall || mOrder->isSearching() ? expandAll() : expandToDepth(1);
}

/// Makes the column of numbers as wide as its widest number, whatever is counted: it does not move with the counts.
void ModelList::fitNumbers() {
  int width = mTree->widestNumber(fontMetrics()) + 2 * ModelDelegate::kTextMargin + kFieldRoom;
  header()->resizeSection(ModelTree::Count, std::max(kWidths[ModelTree::Count], width));
}

void ModelList::changeEvent(QEvent* event) {
  BarList::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) fitNumbers();
}

void ModelList::showLayer(const scene::ModelLayer& layer) {
  bool isOther = mTree->model() != layer.data;
  mTree->showLayer(layer);
  fitNumbers();
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

std::string ModelList::selectedPath() const {
  if (!currentIndex().isValid() || rowOf(currentIndex()).parent < 0) return {};
  return rowOf(currentIndex()).path;
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

CountBar ModelList::barOf(int row) const {
  QModelIndex index = mOrder->mapFromSource(mTree->indexOfRow(row, ModelTree::Bar));
  return mDelegate->barOf(mTree->rows()[std::size_t(row)], visualRect(index));
}

void ModelList::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
  QTreeView::currentChanged(current, previous);
  if (mIsQuiet || !current.isValid()) return;
  const TypeTree::Row& row = rowOf(current);
  emit picked(row.isType ? int(row.number) : -1);
}

/// The types of all selected rows, when this row is one of them; else those of this row alone.
session::TypeNumbers ModelList::typesFor(const QModelIndex& shown) const {
  return selectionModel()->isRowSelected(shown.row(), shown.parent()) ? selectedTypes() : rowOf(shown).types;
}

bool ModelList::pressCell(const QModelIndex& index, QMouseEvent* event) {
  if (index.column() == ModelTree::Bar) return takeHandle(index, event->position().x());
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

void ModelList::mouseMoveEvent(QMouseEvent* event) {
  if (!isHeld()) {
    QModelIndex index = indexAt(event->position().toPoint());
    bool isBar = index.column() == ModelTree::Bar && mTree->countOf(rowOf(index)).total() > 0;
    viewport()->setCursor(isBar ? Qt::SplitHCursor : Qt::ArrowCursor);
    tellHover(index);
  }
  BarList::mouseMoveEvent(event);
}

void ModelList::tellHover(const QModelIndex& index) {
  int row = index.isValid() ? int(mOrder->mapToSource(index).internalId()) : -1;
  if (row == mHoveredRow) return;
  mHoveredRow = row;
  emit hovered(row < 0 ? session::TypeNumbers() : mTree->rows()[std::size_t(row)].types);
}

void ModelList::leaveEvent(QEvent* event) {
  tellHover({});
  QTreeView::leaveEvent(event);
}

void ModelList::mouseDoubleClickEvent(QMouseEvent* event) {
  QModelIndex index = indexAt(event->position().toPoint());
  if (index.isValid() && index.column() == ModelTree::Count) return edit(index);
  bool isName = index.column() == ModelTree::Name;
  if (index.isValid() && isName && visualRect(index).contains(event->position().toPoint()))
    return mCommands.goTo(rowOf(index).types);
  mousePressEvent(event);  // two quick clicks on an eye are two clicks
}

void ModelList::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_F2 && currentIndex().isValid()) {
    bool isNumber = bool(event->modifiers() & Qt::ShiftModifier);
    return edit(currentIndex().siblingAtColumn(isNumber ? ModelTree::Count : ModelTree::Name));
  }
  session::TypeNumbers types = selectedTypes();
  if (!types.empty() && event->key() == Qt::Key_Space) {
    if (event->modifiers() & Qt::AltModifier) return mCommands.toggleSolo(types);
    return mCommands.setVisible(types, currentIndex().data(ModelTree::VisibleRole).toInt() == ModelTree::None);
  }
  bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (!types.empty() && isEnter) return mCommands.goTo(types);
  BarList::keyPressEvent(event);
}

void ModelList::contextMenuEvent(QContextMenuEvent* event) {
  bool isMouse = event->reason() == QContextMenuEvent::Mouse;
  QModelIndex index = isMouse ? indexAt(event->pos()) : currentIndex();
  if (!index.isValid()) return;
  session::TypeNumbers types = typesFor(index);
  bool isRow = types == rowOf(index).types;
  QMenu menu(this);
  mCommands.fillMenu(menu, types, isRow ? rowOf(index).name : tr("%n types", nullptr, int(types.size())),
                     isRow ? rowOf(index).path : std::string());
  menu.exec(isMouse ? event->globalPos() : viewport()->mapToGlobal(visualRect(index).center()));
}

}  // namespace velum::gui
