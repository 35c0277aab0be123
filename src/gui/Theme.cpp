#include "Theme.h"

#include <QPalette>
#include <QStyleFactory>

/// Outside of namespaces, as the macro wants it: the linker would drop the resources of a static library otherwise.
static void useResources() { Q_INIT_RESOURCE(velum); }

namespace velum::gui {

namespace {

constexpr const char* kSheet = R"(
QToolTip { background: #30363e; color: #e3e7ec; border: 1px solid #4a525d; padding: 4px 6px; }
QMainWindow::separator { background: #16181c; width: 1px; }
QMenuBar { background: #1d2025; padding: 2px 4px; }
QMenuBar::item { padding: 4px 9px; border-radius: 4px; }
QMenuBar::item:selected { background: #343a43; }
QMenu { background: #282c33; border: 1px solid #3a4049; padding: 4px; }
QMenu::item { padding: 5px 26px 5px 22px; border-radius: 4px; }
QMenu::item:selected { background: #3b6f96; }
QMenu::item:disabled { color: #6d7681; }
QMenu::separator { height: 1px; background: #3a4049; margin: 4px 8px; }
QToolBar { background: #25292f; border: none; border-bottom: 1px solid #16181c; padding: 4px 6px; spacing: 3px; }
QToolBar::separator { background: #3a4049; width: 1px; margin: 5px 6px; }
QToolBar QToolButton { padding: 5px 10px; border: none; border-radius: 5px; color: #e3e7ec; }
QToolBar QToolButton:hover { background: #343a43; }
QToolBar QToolButton:pressed, QToolBar QToolButton:checked { background: #3b6f96; }
QToolBar QToolButton:disabled { color: #666f7a; }
QStatusBar { background: #1d2025; border-top: 1px solid #16181c; }
QStatusBar::item { border: none; }
QStatusBar QLabel { color: #b4bdc8; padding: 2px 6px; }
#sidePanel, #sidePanel QScrollArea, #sideContents { background: #25292f; }
QTabWidget::pane { border: none; }
QTabBar { background: #1d2025; qproperty-drawBase: 0; }
QTabBar::tab { background: #1d2025; color: #9ba5b1; padding: 8px 12px; border: none; border-bottom: 2px solid transparent; }
QTabBar::tab:hover { color: #e3e7ec; }
QTabBar::tab:selected { background: #25292f; color: #e3e7ec; border-bottom: 2px solid #5fb0ea; }
QLabel[role="title"] { color: #e3e7ec; font-weight: 600; }
QLabel[role="muted"] { color: #9ba5b1; }
QLabel[role="empty"] { font-size: 17pt; font-weight: 500; color: #e3e7ec; }
QFrame[role="line"] { background: #3a4049; border: none; max-height: 1px; min-height: 1px; }
QPushButton { background: #353b44; border: 1px solid #444c57; border-radius: 5px; padding: 5px 10px; color: #e3e7ec; }
QPushButton:hover { background: #3e4650; }
QPushButton:pressed, QPushButton:checked { background: #3b6f96; border-color: #4f8ab5; }
QPushButton:disabled { color: #6d7681; background: #2b3037; border-color: #363c45; }
QPushButton[role="main"] { background: #3b79a8; border-color: #5698c8; padding: 5px 20px; font-weight: 600; }
QPushButton[role="main"]:hover { background: #4689bb; }
QPushButton[role="quiet"] { background: transparent; border: none; padding: 3px 8px; }
QPushButton[role="quiet"]:checked { background: #343a43; }
QPushButton[role="row"] { background: transparent; border: 1px solid transparent; padding: 4px 8px; text-align: left; }
QPushButton[role="row"]:hover { background: #2f343c; }
QPushButton[role="row"]:checked { background: #343a43; border-color: #4f8ab5; }
QPushButton[role="quiet"]:hover { background: #4a525d; }
QComboBox, QDoubleSpinBox, QSpinBox, QLineEdit {
  background: #1d2025; border: 1px solid #3f4650; border-radius: 5px; padding: 4px 7px; color: #e3e7ec;
  selection-background-color: #3b6f96; min-height: 17px; }
QComboBox:focus, QDoubleSpinBox:focus, QSpinBox:focus, QLineEdit:focus { border-color: #5fb0ea; }
QComboBox:disabled, QDoubleSpinBox:disabled, QSpinBox:disabled { color: #6d7681; border-color: #343a42; }
QComboBox::drop-down { border: none; width: 20px; }
QComboBox::down-arrow { image: url(:/velum/chevron.svg); width: 10px; height: 10px; }
QComboBox QAbstractItemView { background: #282c33; border: 1px solid #3a4049; selection-background-color: #3b6f96; outline: 0; padding: 3px; }
QDoubleSpinBox::up-button, QDoubleSpinBox::down-button, QSpinBox::up-button, QSpinBox::down-button { width: 0; border: none; }
QSlider::groove:horizontal { height: 4px; background: #14161a; border-radius: 2px; }
QSlider::sub-page:horizontal { background: #4f8ab5; border-radius: 2px; }
QSlider::sub-page:horizontal:disabled { background: #3a4049; }
QSlider::handle:horizontal { background: #e3e7ec; width: 14px; height: 14px; margin: -5px 0; border-radius: 7px; }
QSlider::handle:horizontal:hover { background: #ffffff; }
QSlider::handle:horizontal:disabled { background: #5c6570; }
QListWidget { background: #1d2025; border: 1px solid #3f4650; border-radius: 5px; outline: 0; padding: 2px; }
QListWidget::item { padding: 4px 4px; border-radius: 4px; color: #e3e7ec; }
QListWidget::item:selected { background: #3b6f96; }
#preset { background: transparent; border: none; border-radius: 0; padding: 0; }
#preset::item { padding: 0; }
QCheckBox { spacing: 7px; }
QProgressBar { background: #14161a; border: none; border-radius: 3px; max-height: 6px; min-height: 6px; }
QProgressBar::chunk { background: #5fb0ea; border-radius: 3px; }
QScrollBar:vertical { background: transparent; width: 10px; margin: 0; }
QScrollBar::handle:vertical { background: #444c57; border-radius: 4px; min-height: 24px; margin: 1px 2px; }
QScrollBar::add-line, QScrollBar::sub-line { height: 0; }
#messageBar[kind="error"] { background: #4a2a2a; border-bottom: 1px solid #7d4540; }
#messageBar[kind="note"] { background: #2c3a46; border-bottom: 1px solid #44637a; }
#progressStrip { background: #25292f; border-top: 1px solid #16181c; }
#emptyState { background: qlineargradient(x1:0, y1:0, x2:0, y2:1, stop:0 #292e35, stop:1 #141619); }
)";

}  // namespace

void applyTheme(QApplication& application) {
  useResources();
  application.setStyle(QStyleFactory::create("Fusion"));
  QPalette palette;
  palette.setColor(QPalette::Window, kPanel);
  palette.setColor(QPalette::WindowText, kText);
  palette.setColor(QPalette::Base, kGround);
  palette.setColor(QPalette::AlternateBase, kPanel);
  palette.setColor(QPalette::Text, kText);
  palette.setColor(QPalette::PlaceholderText, kMuted);
  palette.setColor(QPalette::Button, QColor(0x35, 0x3b, 0x44));
  palette.setColor(QPalette::ButtonText, kText);
  palette.setColor(QPalette::ToolTipBase, QColor(0x30, 0x36, 0x3e));
  palette.setColor(QPalette::ToolTipText, kText);
  palette.setColor(QPalette::Highlight, QColor(0x3b, 0x6f, 0x96));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, kAccent);
  for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, QColor(0x6d, 0x76, 0x81));
  application.setPalette(palette);
  application.setStyleSheet(kSheet);
}

}  // namespace velum::gui
