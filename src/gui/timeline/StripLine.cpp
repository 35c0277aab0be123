#include "gui/timeline/StripLine.h"

#include <QMenu>
#include <algorithm>
#include <functional>
#include <iterator>

#include "gui/kit/Icons.h"

namespace velum::gui {

StripLine::StripLine(int height, QWidget* parent)
    : QWidget(parent), mLine(new QHBoxLayout(this)), mMore(new QToolButton(this)) {
  setFixedHeight(height);
  setMinimumWidth(1);
  mLine->setContentsMargins(0, 0, 0, 4);
  mLine->setSpacing(3);
  mMore->setObjectName("more");
  mMore->setIcon(makeIcon("view.more"));
  mMore->setToolTip(tr("What has no room here"));
  mMore->setAccessibleName(tr("More"));
  mMore->setFocusPolicy(Qt::TabFocus);
  mMore->setPopupMode(QToolButton::InstantPopup);
  mMore->setMenu(new QMenu(mMore));
  mMore->hide();
  mLine->addWidget(mMore);
  connect(mMore->menu(), &QMenu::aboutToShow, this, &StripLine::fillMenu);
}

void StripLine::add(QWidget* control, int rank) {
  mLine->insertWidget(mLine->count() - 1, control);
  mItems.push_back({control, rank});
}

void StripLine::addGap(int pixels) {
  mLine->insertSpacing(mLine->count() - 1, pixels);
  mGaps += pixels + mLine->spacing();
}

void StripLine::addStretch() { mLine->insertStretch(mLine->count() - 1, 1); }

int StripLine::widthOf(const QWidget& control) const {
  return control.sizeHint().expandedTo(control.minimumSize()).boundedTo(control.maximumSize()).width() +
         mLine->spacing();
}

int StripLine::wholeWidth() const {
  int width = mGaps;
  for (const Item& item : mItems) width += widthOf(*item.control);
  return width;
}

void StripLine::fit() {
  std::vector<Item> leaving;
  std::ranges::copy_if(mItems, std::back_inserter(leaving), [](const Item& item) { return item.rank > 0; });
  std::ranges::stable_sort(leaving, std::greater{}, &Item::rank);
  int room = width() - wholeWidth();
  bool isShort = room < 0;
  if (isShort) room -= widthOf(*mMore);
  int left = 0;  // the rank that left last: all of it
  for (const Item& item : leaving) {
    bool leaves = room < 0 || item.rank == left;
    if (leaves) left = item.rank, room += widthOf(*item.control);
    item.control->setVisible(!leaves);
  }
  mMore->setVisible(isShort);
}

void StripLine::resizeEvent(QResizeEvent* event) {
  fit();
  QWidget::resizeEvent(event);
}

void StripLine::fillMenu() {
  QMenu& menu = *mMore->menu();
  menu.clear();
  for (const Item& item : mItems) {
    auto* button = qobject_cast<QToolButton*>(item.control);
    if (!button || !button->isHidden()) continue;
    if (button->menu())
      menu.addMenu(button->menu());
    else if (button->defaultAction())
      menu.addAction(button->defaultAction());
    else
      menu.addAction(button->accessibleName(), button, &QToolButton::click);
  }
}

}  // namespace velum::gui
