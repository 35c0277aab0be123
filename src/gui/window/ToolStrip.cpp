#include "gui/window/ToolStrip.h"

#include <QEvent>
#include <QLayout>
#include <QToolButton>

#include "gui/kit/Icons.h"

namespace velum::gui {

namespace {

constexpr int kIcon = 24;  // the grid that icons are drawn on

/// What stands in it; an empty one is a gap.
constexpr const char* kCommands[] = {"cut.addMembrane",
                                     "cut.addPlane",
                                     "look.showThis",
                                     "extrusion.pull",
                                     "mark.distance",
                                     "",
                                     "file.open",
                                     "file.savePicture",
                                     "",
                                     "edit.undo",
                                     "edit.redo",
                                     "",
                                     "layout.four",
                                     "layout.volume",
                                     "layout.beside",
                                     "layout.section",
                                     "",
                                     "view.reset",
                                     "view.parallel"};

}  // namespace

ToolStrip::ToolStrip(QWidget* window) : QToolBar(tr("Tools"), window) {
  setObjectName("toolBar");
  setMovable(false);
  setContextMenuPolicy(Qt::PreventContextMenu);
  setIconSize({kIcon, kIcon});
}

void ToolStrip::fill(const ActionTable& actions) {
  for (const char* id : kCommands) *id ? addAction(actions.find(id)) : (void)addSeparator();
  // Qt's own button for what has no room.
  if (auto* more = findChild<QToolButton*>("qt_toolbar_ext_button")) {
    more->setIcon(makeIcon("view.more"));
    more->setToolTip(tr("More"));
  }
  nameWhatFits();
}

void ToolStrip::resizeEvent(QResizeEvent* event) {
  QToolBar::resizeEvent(event);
  nameWhatFits();
}

void ToolStrip::changeEvent(QEvent* event) {
  QToolBar::changeEvent(event);
  if (event->type() == QEvent::StyleChange || event->type() == QEvent::FontChange) nameWhatFits();
}

void ToolStrip::nameWhatFits() {
  QList<QToolButton*> buttons;
  int room = width();
  for (QAction* action : actions())
    if (auto* button = qobject_cast<QToolButton*>(widgetForAction(action))) {
      button->setToolButtonStyle(Qt::ToolButtonIconOnly);
      buttons << button;
    }
  layout()->invalidate();  // it would go on with the names
  room -= sizeHint().width();
  for (QToolButton* button : buttons) {
    int narrow = button->sizeHint().width();
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    room -= button->sizeHint().width() - narrow;
    if (room < 0) {
      button->setToolButtonStyle(Qt::ToolButtonIconOnly);
      break;
    }
  }
}

}  // namespace velum::gui
