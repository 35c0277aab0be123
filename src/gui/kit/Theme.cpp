#include "gui/kit/Theme.h"

#include <QHash>
#include <QPalette>
#include <QStyleFactory>

/// Outside of namespaces, as the macro wants it: the linker would drop the resources of a static library otherwise.
static void useResources() {
  Q_INIT_RESOURCE(velum);
  Q_INIT_RESOURCE(icons);
  Q_INIT_RESOURCE(guide);
  Q_INIT_RESOURCE(translations);
}

namespace velum::gui {

namespace {

using Colors = QHash<QString, QString>;

/// What the style sheet's @names stand for.
Colors colorsOf(ThemeKind kind) {
  if (kind == ThemeKind::Light)
    return {{"ground", "#ffffff"},      {"panel", "#f3f4f6"},       {"deep", "#d3d7dd"},      {"popup", "#ffffff"},
            {"tip", "#ffffff"},         {"line", "#d5d9df"},        {"edge", "#b9c0c9"},      {"hover", "#e4e8ed"},
            {"text", "#1f242b"},        {"soft", "#454d57"},        {"muted", "#565f6b"},     {"faint", "#626c78"},
            {"button", "#ffffff"},      {"buttonHover", "#eef1f5"}, {"buttonOff", "#eceef1"}, {"chosen", "#2f78b0"},
            {"chosenEdge", "#2a6b9e"},  {"onChosen", "#ffffff"},    {"main", "#2f78b0"},      {"mainHover", "#28699c"},
            {"accent", "#1f74b5"},      {"groove", "#cdd3da"},      {"white", "#2b3037"},     {"errorFill", "#fbe4e1"},
            {"errorEdge", "#e0a39b"},   {"noteFill", "#e1edf7"},    {"noteEdge", "#a9c7df"},  {"emptyTop", "#f7f8fa"},
            {"emptyBottom", "#dfe3e8"}, {"alarm", "#8a5a00"},       {"control", "#828b97"}};
  return {{"ground", "#1d2025"},      {"panel", "#25292f"},       {"deep", "#16181c"},      {"popup", "#282c33"},
          {"tip", "#30363e"},         {"line", "#3a4049"},        {"edge", "#444c57"},      {"hover", "#343a43"},
          {"text", "#e3e7ec"},        {"soft", "#b4bdc8"},        {"muted", "#9ba5b1"},     {"faint", "#8e98a4"},
          {"button", "#353b44"},      {"buttonHover", "#3e4650"}, {"buttonOff", "#2b3037"}, {"chosen", "#3b6f96"},
          {"chosenEdge", "#4f8ab5"},  {"onChosen", "#ffffff"},    {"main", "#34719f"},      {"mainHover", "#3b79a8"},
          {"accent", "#5fb0ea"},      {"groove", "#14161a"},      {"white", "#ffffff"},     {"errorFill", "#4a2a2a"},
          {"errorEdge", "#7d4540"},   {"noteFill", "#2c3a46"},    {"noteEdge", "#44637a"},  {"emptyTop", "#292e35"},
          {"emptyBottom", "#141619"}, {"alarm", "#ffb85c"},       {"control", "#6d7681"}};
}

constexpr const char* kSheet = R"(
QToolTip { background: @tip; color: @text; border: 1px solid @edge; padding: 4px 6px; }
QMainWindow::separator { background: @deep; width: 1px; }
QMenuBar { background: @ground; padding: 2px 4px; }
QMenuBar::item { padding: 4px 9px; border-radius: 4px; }
QMenuBar::item:selected { background: @hover; }
QMenu { background: @popup; border: 1px solid @line; padding: 4px; }
QMenu::item { padding: 5px 26px 5px 10px; border-radius: 4px; }
QMenu::item:selected { background: @chosen; color: @onChosen; }
QMenu::icon { padding: 2px; margin-left: 5px; }
QMenu::icon:checked { background: @chosen; border-radius: 4px; }
QMenu::item:disabled { color: @faint; }
QMenu::separator { height: 1px; background: @line; margin: 4px 8px; }
QToolBar { background: @panel; border: none; border-bottom: 1px solid @deep; padding: 4px 6px; spacing: 3px; }
QToolBar::separator { background: @line; width: 1px; margin: 5px 6px; }
QToolBar QToolButton { padding: 5px 7px; border: none; border-radius: 5px; color: @text; }
QToolBar #qt_toolbar_ext_button { padding: 0; }
QToolBar QToolButton:hover { background: @hover; }
QToolBar QToolButton:pressed, QToolBar QToolButton:checked { background: @chosen; color: @onChosen; }
QToolBar QToolButton:disabled { color: @faint; }
QToolBar QToolButton:checked:disabled { background: @hover; }
QStatusBar { background: @ground; border-top: 1px solid @deep; }
QStatusBar::item { border: none; }
QStatusBar QLabel { color: @soft; padding: 2px 6px; }
#sidePanel, #sidePanel QScrollArea, #sideContents { background: @panel; }
QTabWidget::pane { border: none; }
QTabBar { background: @ground; qproperty-drawBase: 0; }
QTabBar::tab { background: @ground; color: @muted; padding: 8px 4px; border: none; border-bottom: 2px solid transparent; }
QTabBar::tab:hover { color: @text; }
QTabBar::tab:selected { background: @panel; color: @text; border-bottom: 2px solid @accent; }
QLabel[role="title"] { color: @text; font-weight: 600; }
QLabel[role="muted"] { color: @muted; }
QLabel[role="alarm"] { color: @alarm; }
QLabel[role="empty"] { font-size: 17pt; font-weight: 500; color: @text; }
QFrame[role="line"] { background: @line; border: none; max-height: 1px; min-height: 1px; }
QPushButton { background: @button; border: 1px solid @edge; border-radius: 5px; padding: 5px 10px; color: @text; }
QPushButton:hover { background: @buttonHover; }
QPushButton:pressed, QPushButton:checked { background: @chosen; border-color: @chosenEdge; color: @onChosen; }
QPushButton:disabled { color: @faint; background: @buttonOff; border-color: @line; }
QPushButton[role="main"] { background: @main; border-color: @chosenEdge; color: @onChosen; padding: 5px 20px; font-weight: 600; }
QPushButton[role="main"]:hover { background: @mainHover; }
QPushButton[role="main"]:disabled { color: @faint; background: @buttonOff; border-color: @line; }
QPushButton[role="quiet"] { background: transparent; border: none; padding: 3px 8px; }
QPushButton[role="quiet"]:checked { background: @hover; color: @text; }
QPushButton[role="quiet"]:hover { background: @edge; }
QPushButton[role="row"] { background: transparent; border: 1px solid transparent; padding: 4px 8px; text-align: left; }
QPushButton[role="row"]:hover { background: @hover; }
QPushButton[role="row"]:checked { background: @hover; border-color: @chosenEdge; color: @text; }
QComboBox, QDoubleSpinBox, QSpinBox, QLineEdit {
  background: @ground; border: 1px solid @edge; border-radius: 5px; padding: 4px 7px;
  selection-background-color: @chosen; min-height: 17px; }
QComboBox:focus, QDoubleSpinBox:focus, QSpinBox:focus, QLineEdit:focus, QPlainTextEdit:focus { border-color: @accent; }
QComboBox:disabled, QDoubleSpinBox:disabled, QSpinBox:disabled { color: @faint; border-color: @line; }
QComboBox::drop-down { border: none; width: 20px; }
QComboBox::down-arrow { image: url(:/velum/@chevron); width: 10px; height: 10px; }
QComboBox QAbstractItemView { background: @popup; border: 1px solid @line; selection-background-color: @chosen; outline: 0; padding: 3px; }
QDoubleSpinBox::up-button, QDoubleSpinBox::down-button, QSpinBox::up-button, QSpinBox::down-button { width: 0; border: none; }
QSlider::groove:horizontal { height: 4px; background: @groove; border-radius: 2px; }
QSlider::sub-page:horizontal { background: @chosenEdge; border-radius: 2px; }
QSlider::sub-page:horizontal:disabled { background: @line; }
QSlider::handle:horizontal { background: @text; width: 14px; height: 14px; margin: -5px 0; border-radius: 7px; }
QSlider::handle:horizontal:hover { background: @white; }
QSlider::handle:horizontal:disabled { background: @faint; }
#sidePanel QDoubleSpinBox { padding: 4px 5px; }
QPushButton[role="small"] { padding: 4px 2px; }
#sidePanel QToolButton { background: @button; border: 1px solid @edge; border-radius: 5px; padding: 5px 9px; color: @text; }
#sidePanel QToolButton:hover { background: @buttonHover; }
#sidePanel QToolButton:checked { background: @chosen; border-color: @chosenEdge; color: @onChosen; }
#sidePanel QToolButton::menu-indicator { image: url(:/velum/@chevron); width: 9px; height: 9px; subcontrol-position: right center; right: 6px; }
#sidePanel QToolButton[popupMode="2"] { padding-right: 21px; }
QTreeView, QListView, QPlainTextEdit { background: @ground; border: 1px solid @edge; border-radius: 5px; outline: 0; padding: 2px; }
QTreeView QLineEdit, QListView QLineEdit { padding: 0 4px; min-height: 0; }
QListWidget { background: @ground; border: 1px solid @edge; border-radius: 5px; outline: 0; padding: 2px; }
QListWidget::item { padding: 4px 4px; border-radius: 4px; color: @text; }
QListWidget::item:selected { background: @chosen; color: @onChosen; }
QListWidget[role="pictures"] { background: transparent; border: none; border-radius: 0; padding: 0; }
QListWidget[role="pictures"]::item { padding: 0; }
QCheckBox::indicator, QListView::indicator, QTreeView::indicator { width: 13px; height: 13px; border: 1px solid @control; border-radius: 3px; background: @ground; }
QCheckBox::indicator:checked, QListView::indicator:checked, QTreeView::indicator:checked { background: @chosen; border-color: @chosenEdge; image: url(:/velum/check.svg); }
QCheckBox::indicator:focus { border-color: @accent; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QProgressBar { background: @groove; border: none; border-radius: 3px; max-height: 6px; min-height: 6px; }
QProgressBar::chunk { background: @accent; border-radius: 3px; }
QScrollBar:vertical { background: transparent; width: 10px; margin: 0; }
QScrollBar::handle:vertical { background: @edge; border-radius: 4px; min-height: 24px; margin: 1px 2px; }
QScrollBar::add-line, QScrollBar::sub-line { height: 0; }
#messageBar[kind="error"] { background: @errorFill; border: 1px solid @errorEdge; border-radius: 8px; }
#messageBar[kind="note"] { background: @noteFill; border: 1px solid @noteEdge; border-radius: 8px; }
#recoveryBar { background: @noteFill; border: 1px solid @noteEdge; border-radius: 8px; }
#timeBar { background: @panel; border-top: 1px solid @deep; }
#timeline { background: @panel; border-top: 1px solid @deep; }
#timeline QToolButton { background: transparent; border: 1px solid transparent; border-radius: 5px; padding: 4px 5px; color: @text; }
#timeline QToolButton:hover { background: @hover; }
#timeline QToolButton:pressed, #timeline QToolButton:checked { background: @chosen; border-color: @chosenEdge; color: @onChosen; }
#timeline QToolButton[role="record"]:checked { background: @errorFill; border-color: #e5484d; }
#timeline QToolButton:disabled { color: @faint; }
#timeline QToolButton#saveFilm, #timeline QToolButton#addFilm { background: @button; border-color: @edge; padding: 4px 9px; }
#timeline QToolButton#addFilm { padding-right: 21px; }
#timeline QToolButton#saveFilm:hover, #timeline QToolButton#addFilm:hover { background: @buttonHover; }
#timeline QToolButton::menu-indicator { image: url(:/velum/@chevron); width: 9px; height: 9px; subcontrol-position: right center; right: 6px; }
#timeline QToolButton#more::menu-indicator { image: none; width: 0; }
#timeline QDoubleSpinBox { padding: 3px 5px; }
#commandFinder { background: @popup; border: 1px solid @edge; }
#commandFinder QLineEdit { font-size: 13pt; padding: 8px 10px; }
QTextBrowser { background: @ground; border: none; padding: 10px 20px; }
QScrollBar:horizontal { height: 0; }
#progressStrip, #keptBar { background: @panel; border: 1px solid @edge; border-radius: 8px; }
#emptyState { background: qlineargradient(x1:0, y1:0, x2:0, y2:1, stop:0 @emptyTop, stop:1 @emptyBottom); }
)";

QString sheetOf(const Colors& colors, ThemeKind kind) {
  QString sheet;
  const QString text = kSheet;
  for (qsizetype i = 0; i < text.size();) {
    if (text[i] != '@') {
      sheet += text[i++];
      continue;
    }
    qsizetype end = i + 1;
    while (end < text.size() && text[end].isLetter()) ++end;
    QString name = text.mid(i + 1, end - i - 1);
    sheet += name == "chevron" ? QString(kind == ThemeKind::Light ? "chevron-light.svg" : "chevron.svg")
                               : colors.value(name);
    i = end;
  }
  return sheet;
}

}  // namespace

QColor themeColor(ThemeKind kind, const QString& name) {
  QString text = colorsOf(kind).value(name);
  return text.isEmpty() ? QColor() : QColor(text);
}

ThemeKind themeOf(const QPalette& palette) {
  return palette.color(QPalette::Base).lightness() > 128 ? ThemeKind::Light : ThemeKind::Dark;
}

void applyTheme(QApplication& application, ThemeKind kind) {
  useResources();
  application.setStyle(QStyleFactory::create("Fusion"));
  Colors colors = colorsOf(kind);
  auto color = [&](const char* name) { return QColor(colors.value(name)); };
  QPalette palette;
  struct Role {
    QPalette::ColorRole role;
    const char* name;
  };
  for (const Role& row : {Role{QPalette::Window, "panel"},
                          {QPalette::WindowText, "text"},
                          {QPalette::Base, "ground"},
                          {QPalette::AlternateBase, "panel"},
                          {QPalette::Text, "text"},
                          {QPalette::PlaceholderText, "muted"},
                          {QPalette::Button, "button"},
                          {QPalette::ButtonText, "text"},
                          {QPalette::ToolTipBase, "tip"},
                          {QPalette::ToolTipText, "text"},
                          {QPalette::Highlight, "chosen"},
                          {QPalette::HighlightedText, "onChosen"},
                          {QPalette::Link, "accent"},
                          {QPalette::Mid, "line"},
                          {QPalette::Dark, "edge"},
                          {QPalette::Light, "hover"}})
    palette.setColor(row.role, color(row.name));
  for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, color("faint"));
  application.setPalette(palette);
  application.setStyleSheet(sheetOf(colors, kind));
}

}  // namespace velum::gui
