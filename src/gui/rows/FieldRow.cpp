#include "gui/rows/FieldRow.h"

#include <algorithm>

namespace velum::gui {

namespace {

constexpr int kSpacing = 5;

}  // namespace

FieldRow::FieldRow(QWidget* parent) : QLayout(parent) {
  setContentsMargins(0, 0, 0, 0);
  setSpacing(kSpacing);
}

FieldRow::~FieldRow() = default;

QLayoutItem* FieldRow::itemAt(int index) const {
  return index >= 0 && index < count() ? mItems[std::size_t(index)].get() : nullptr;
}

QLayoutItem* FieldRow::takeAt(int index) {
  if (!itemAt(index)) return nullptr;
  QLayoutItem* item = mItems[std::size_t(index)].release();
  mItems.erase(mItems.begin() + index);
  return item;
}

std::vector<QLayoutItem*> FieldRow::shown() const {
  std::vector<QLayoutItem*> items;
  for (const auto& item : mItems)
    if (!item->isEmpty()) items.push_back(item.get());
  return items;
}

QSize FieldRow::minimumSize() const {
  QSize size(0, 0);
  for (const QLayoutItem* item : shown()) size = size.expandedTo(item->minimumSize());
  return size;
}

int FieldRow::columnCount(int width) const {
  int least = minimumSize().width();
  return std::clamp((width + spacing()) / std::max(1, least + spacing()), 1, std::max(1, int(shown().size())));
}

int FieldRow::heightForWidth(int width) const {
  int columns = columnCount(width), lines = (int(shown().size()) + columns - 1) / columns;
  return std::max(0, lines * (minimumSize().height() + spacing()) - spacing());
}

void FieldRow::setGeometry(const QRect& rect) {
  QLayout::setGeometry(rect);
  auto items = shown();
  int columns = columnCount(rect.width()), height = minimumSize().height();
  // Edges are rounded, not widths, so that the last one ends with the row.
  auto edgeOf = [&](int column) { return rect.left() + column * (rect.width() + spacing()) / columns; };
  for (int i = 0; i < int(items.size()); ++i) {
    int column = i % columns, left = edgeOf(column);
    items[std::size_t(i)]->setGeometry(
        {left, rect.top() + i / columns * (height + spacing()), edgeOf(column + 1) - spacing() - left, height});
  }
}

}  // namespace velum::gui
