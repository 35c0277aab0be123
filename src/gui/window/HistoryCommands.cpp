#include "gui/window/HistoryCommands.h"

#include <QClipboard>
#include <QGuiApplication>
#include <algorithm>

#include "gui/kit/Words.h"
#include "gui/window/PreferencesDialog.h"
#include "session/command/PythonLines.h"

namespace velum::gui {

namespace {

constexpr int kHistoryRows = 30, kNoteLength = 90;

/// A label in a menu, where & is a mark.
QString menuText(const std::string& label) { return stepText(label).replace('&', "&&"); }

}  // namespace

HistoryCommands::HistoryCommands(const WindowParts& parts) : Room(parts) {
  QMenu* menu = parts.menu(MenuId::Edit);
  mUndo = parts.actions.add(menu, "edit.undo", tr("&Undo"), tr("Take the last change back"),
                            [this] { mParts.document().undo(); });
  mRedo = parts.actions.add(menu, "edit.redo", tr("&Redo"), tr("Do it again"), [this] { mParts.document().redo(); });
  QMenu* history = menu->addMenu(tr("&History"));
  connect(history, &QMenu::aboutToShow, this, [this, history] { fillHistory(*history); });
  mCopy =
      parts.actions.add(menu, "edit.copyCommand", tr("&Copy as command"),
                        tr("Copy the last change as the line of a script that does it again"), [this] { copyLast(); });
  parts.actions.add(menu, "edit.copyPython", tr("Copy as Pyth&on"),
                    tr("Copy all that was done to what is open as a program in Python"), [this] { copyPython(); });
  parts.actions.add(menu, "edit.commands", tr("Co&mmands so far..."),
                    tr("What has been done to what is open, as a script; and a line to type commands"),
                    [this] { showCommands(); });
  mUndo->setIconText(tr("Undo"));
  mRedo->setIconText(tr("Redo"));
  menu->addSeparator();
  parts.actions.add(menu, "edit.preferences", tr("&Preferences..."),
                    tr("Appearance, language, units, mouse and wheel, keys, memory"), [this] { askPreferences(); });
}

void HistoryCommands::askPreferences() {
  PreferencesDialog dialog(mParts.actions, &mParts.window);
  connect(&dialog, &PreferencesDialog::changed, this, &HistoryCommands::preferencesChanged);
  dialog.exec();
}

void HistoryCommands::copyLast() {
  QString text;
  for (const std::string& line : mParts.document().lastCommandLines()) text += QString::fromStdString(line) + '\n';
  QGuiApplication::clipboard()->setText(text);
  QString first = text.section('\n', 0, 0).startsWith('#') ? text.section('\n', 1, 1) : text.section('\n', 0, 0);
  mParts.messages.showNote(tr("Copied: %1").arg(first.size() > kNoteLength ? first.left(kNoteLength) + "..." : first));
}

void HistoryCommands::copyPython() {
  std::string program = session::pythonProgram(mParts.document().commandLines());
  QGuiApplication::clipboard()->setText(QString::fromStdString(program));
  mParts.messages.showNote(tr("Copied all that was done as a program in Python"));
}

void HistoryCommands::showCommands() {
  if (!mCommands) mCommands = new CommandsWindow(mParts.session, mParts.jobs, &mParts.window);
  mCommands->show();
  mCommands->raise();
  mCommands->activateWindow();
}

void HistoryCommands::refresh(const session::Session& session) {
  if (mCommands) mCommands->refresh();
  mCopy->setEnabled(session.document().canUndo());
  const session::Document& document = session.document();
  auto name = [](const QString& verb, const std::string& label) {
    return label.empty() ? verb : tr("%1 \"%2\"").arg(verb, stepText(label));
  };
  mUndo->setEnabled(document.canUndo());
  mUndo->setText(name(tr("&Undo"), document.undoLabel()));
  mRedo->setEnabled(document.canRedo());
  mRedo->setText(name(tr("&Redo"), document.redoLabel()));
}

void HistoryCommands::fillHistory(QMenu& menu) {
  menu.clear();
  auto add = [&](const std::vector<std::string>& labels, int i, void (session::Document::*step)()) {
    connect(menu.addAction(menuText(labels[std::size_t(i)])), &QAction::triggered, this, [this, i, step] {
      for (int n = 0; n <= i; ++n) (mParts.document().*step)();
    });
  };
  auto redo = mParts.document().redoLabels(), undo = mParts.document().undoLabels();
  for (int i = std::min(int(redo.size()), kHistoryRows) - 1; i >= 0; --i) add(redo, i, &session::Document::redo);
  if (!redo.empty()) menu.addSection(tr("Now"));
  for (int i = 0; i < std::min(int(undo.size()), kHistoryRows); ++i) add(undo, i, &session::Document::undo);
  if (menu.isEmpty()) menu.addAction(tr("Nothing yet"))->setEnabled(false);
}

}  // namespace velum::gui
