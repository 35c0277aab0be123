#include "gui/look/LookCommands.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <exception>
#include <string>
#include <vector>

#include "gui/kit/CoreWords.h"
#include "gui/service/SavePath.h"
#include "session/command/Command.h"
#include "session/command/LookCommands.h"
#include "session/look/Look.h"

namespace velum::gui {

LookCommands::LookCommands(session::Document& document, Toolbox& toolbox, MessageBar& messages, QWidget* window)
    : QObject(window),
      mDocument(document),
      mToolbox(toolbox),
      mMessages(messages),
      mWindow(window),
      mShowThis(new ShowThisTool(document, messages, this)) {}

void LookCommands::build(ActionTable& actions, QMenu* menu) {
  QAction* showThis = actions.addForScene(
      menu, "look.showThis", tr("Show &this"),
      tr("Click tissue to make it visible; with Shift beside what is shown, with Ctrl to hide it"), [] {});
  showThis->setIconText(tr("Show this"));
  mToolbox.bind(*mShowThis, *showThis);
  menu->addSeparator();
  actions.addForScene(menu, "look.import", tr("&Import look..."),
                      tr("Take colours and opacity from a file of ours or of 3D Slicer"), [this] { askImport(); });
  actions.addForScene(menu, "look.export", tr("&Export look..."),
                      tr("Write colours and opacity for other scenes, or for 3D Slicer"), [this] { askExport(); });
}

void LookCommands::importFrom(const QString& path) {
  if (!mDocument.shown().volume.data)
    return mMessages.showNote(tr("Open a volume first: %1 is a look for one.").arg(QFileInfo(path).fileName()));
  try {
    session::Call call(session::ImportLook{path.toStdString()});
    Progress progress;
    session::Edit edit = session::editOf(mDocument.shown(), call, progress);
    session::commit(mDocument, edit, call);
    mFolder = QFileInfo(path).path();
    if (!edit.told.empty()) mMessages.showNote(QFileInfo(path).fileName(), edit.told);
  } catch (const std::exception& error) {
    mMessages.showError(inWords(error.what()));
  }
}

void LookCommands::exportTo(const QString& path) {
  try {
    auto losses = session::exportLook(mDocument.shown(), path.toStdString());
    mFolder = QFileInfo(path).path();
    mMessages.showNote(tr("Saved %1").arg(path), losses);
  } catch (const std::exception& error) {
    mMessages.showError(inWords(error.what()));
  }
}

void LookCommands::askImport() {
  QStringList patterns;  // each that is written is read, too
  for (const auto& format : session::writtenPatterns(io::FileKind::Look)) patterns << patternsOf(format);
  QString path = QFileDialog::getOpenFileName(mWindow, tr("Import look"), mFolder,
                                              tr("Looks (%1);;All files (*)").arg(patterns.join(' ')));
  if (!path.isEmpty()) importFrom(path);
}

void LookCommands::askExport() {
  QString path =
      askSavePath(mWindow, tr("Export look"), mFolder + (mFolder.isEmpty() ? "" : "/") + "look.velum-transfer.json",
                  saveFilters(io::FileKind::Look));
  if (path.isEmpty()) return;
  if (!session::isLookFile(path.toStdString())) path += ".velum-transfer.json";
  exportTo(path);
}

}  // namespace velum::gui
