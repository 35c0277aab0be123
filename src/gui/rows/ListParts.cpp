#include "gui/rows/ListParts.h"

#include "gui/kit/Widgets.h"

namespace velum::gui {

namespace {

QHBoxLayout* makeLine(QWidget* widget, int spacing) {
  auto* row = new QHBoxLayout(widget);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(spacing);
  return row;
}

}  // namespace

QVBoxLayout* makeColumn(QWidget* widget, int spacing) {
  auto* layout = new QVBoxLayout(widget);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(spacing);
  return layout;
}

QPushButton* makeQuiet(const QString& text, const char* name, const QString& tip, QWidget* parent) {
  auto* button = new QPushButton(text, parent);
  button->setObjectName(name);
  button->setProperty("role", "quiet");
  button->setToolTip(tip);
  return button;
}

ListHead makeListHead(const char* eyeName, const QString& eyeTitle, const QString& tip, QWidget* parent) {
  ListHead head{new QHBoxLayout, makeTitle({}, parent), new EyeButton(parent)};
  head.row->setSpacing(6);
  head.name->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  head.shown->setObjectName(eyeName);
  head.shown->setAccessibleName(eyeTitle);
  head.shown->setToolTip(tip);
  head.row->addWidget(head.shown);
  head.row->addWidget(head.name, 1);
  return head;
}

ListSearch makeListSearch(const QString& name, QWidget* bar) {
  ListSearch search{makeLine(bar, 6), new QLineEdit(bar), new QToolButton(bar), nullptr};
  search.menu = new QMenu(search.sort);
  search.field->setObjectName(name + "Search");
  search.field->setClearButtonEnabled(true);
  search.sort->setObjectName(name + "Sort");
  search.sort->setText(QObject::tr("Sort"));
  search.sort->setPopupMode(QToolButton::InstantPopup);
  search.sort->setMenu(search.menu);
  for (QWidget* part : {static_cast<QWidget*>(search.field), static_cast<QWidget*>(search.sort)})
    part->setFixedHeight(kListFieldHeight);
  search.row->addWidget(search.field, 1);
  search.row->addWidget(search.sort);
  return search;
}

QToolButton* ListSearch::addSwitch(const char* name, const QString& text, const QString& tip) const {
  auto* button = new QToolButton(sort->parentWidget());
  button->setObjectName(name);
  button->setText(text);
  button->setCheckable(true);
  button->setToolTip(tip);
  button->setFixedHeight(kListFieldHeight);
  row->insertWidget(row->count() - 1, button);
  return button;
}

QAction* ListSearch::addChoice(QActionGroup* group, const QString& text, bool isFirst) const {
  QAction* action = menu->addAction(text);
  action->setCheckable(true);
  action->setChecked(isFirst);
  group->addAction(action);
  return action;
}

QLabel* makeListFoot(const std::vector<QPushButton*>& buttons, const QString& tip, QWidget* foot) {
  QHBoxLayout* row = makeLine(foot, 2);
  auto* count = new QLabel(foot);
  count->setProperty("role", "muted");
  count->setToolTip(tip);
  for (QPushButton* button : buttons) row->addWidget(button);
  row->addStretch(1);
  row->addWidget(count);
  return count;
}

}  // namespace velum::gui
