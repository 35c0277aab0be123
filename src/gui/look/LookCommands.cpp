#include "LookCommands.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>

#include "velum/core/Error.h"
#include "velum/session/look/Look.h"
#include "velum/session/look/ShowThis.h"

namespace velum::gui {

LookCommands::LookCommands(session::Document& document, ViewGrid& views, MessageBar& messages, QWidget* window)
    : QObject(window), mDocument(document), mViews(views), mMessages(messages), mWindow(window) {
  connect(&views.viewport(), &Viewport::clicked, this, &LookCommands::clickedInPicture);
  connect(&views, &ViewGrid::clickedSlice, this, &LookCommands::showAt);
}

void LookCommands::build(ActionTable& actions, QMenu* menu, QToolBar* bar) {
  mShowThis = actions.addForScene(
      menu, "look.showThis", tr("Show &this"),
      tr("Click tissue to make it visible; with Shift beside what is shown, with Ctrl to hide it"), [] {});
  mShowThis->setCheckable(true);
  mShowThis->setIconText(tr("Show this"));
  connect(mShowThis, &QAction::toggled, this, [this](bool on) {
    mViews.setPointing(on);
    emit showingChanged(on);
  });
  menu->addSeparator();
  actions.addForScene(menu, "look.import", tr("&Import look..."),
                      tr("Take colours and opacity from a file of ours or of 3D Slicer"), [this] { askImport(); });
  actions.addForScene(menu, "look.export", tr("&Export look..."),
                      tr("Write colours and opacity for other scenes, or for 3D Slicer"), [this] { askExport(); });
  bar->addAction(mShowThis);
}

/// The picture's point lies on the material's border: what is meant is behind it.
void LookCommands::clickedInPicture(QPointF place, Qt::KeyboardModifiers keys) {
  if (!isShowing()) return;
  auto pick = mViews.viewport().pickAt(place);
  const auto& volume = mDocument.scene().volume.data;
  if (!pick || !pick->hit || !volume) return;
  glm::dvec3 spacing = spacingMm(*volume);
  double depth = 2.5 * std::max(spacing.x, std::max(spacing.y, spacing.z));
  showAt(pick->worldMm - glm::dvec3(pick->normal) * depth, keys);
}

void LookCommands::showAt(glm::dvec3 worldMm, Qt::KeyboardModifiers keys) {
  std::optional<session::Tissue> tissue;
  bool hide = keys & Qt::ControlModifier, add = keys & Qt::ShiftModifier;
  mDocument.edit(hide ? "Hide this tissue" : "Show this tissue", [&](scene::Scene& scene) {
    tissue = hide ? session::hideThis(scene, worldMm) : session::showThis(scene, worldMm, add);
  });
  const auto& volume = mDocument.scene().volume.data;
  if (!tissue || !volume) return;
  QString unit = QString::fromStdString(volume->unit);
  mMessages.showNote((hide ? tr("Hidden: values around %1 %2") : tr("Shown: values around %1 %2"))
                         .arg(QString::number(tissue->value, 'g', 4), unit)
                         .trimmed());
}

void LookCommands::importFrom(const QString& path) {
  if (!mDocument.scene().volume.data)
    return mMessages.showNote(tr("Open a volume first: %1 is a look for one.").arg(QFileInfo(path).fileName()));
  try {
    mDocument.edit("Import look", [&](scene::Scene& scene) { session::importLook(scene, path.toStdString()); });
    mFolder = QFileInfo(path).path();
  } catch (const Error& error) {
    mMessages.showError(QString::fromUtf8(error.what()));
  }
}

void LookCommands::exportTo(const QString& path) {
  try {
    session::exportLook(mDocument.scene(), path.toStdString());
    mFolder = QFileInfo(path).path();
    mMessages.showNote(tr("Saved %1").arg(path));
  } catch (const Error& error) {
    mMessages.showError(QString::fromUtf8(error.what()));
  }
}

void LookCommands::askImport() {
  QString path = QFileDialog::getOpenFileName(mWindow, tr("Import look"), mFolder,
                                              tr("Looks (*.velum-transfer.json *.vp.json *.vp);;All files (*)"));
  if (!path.isEmpty()) importFrom(path);
}

void LookCommands::askExport() {
  QString kind;
  QString path = QFileDialog::getSaveFileName(
      mWindow, tr("Export look"), mFolder + (mFolder.isEmpty() ? "" : "/") + "look.velum-transfer.json",
      tr("Velum (*.velum-transfer.json);;3D Slicer (*.vp.json);;3D Slicer, old (*.vp)"), &kind);
  if (path.isEmpty()) return;
  if (!session::isLookFile(path.toStdString()))
    path += kind.contains("*.vp.json") ? ".vp.json" : kind.contains("*.vp") ? ".vp" : ".velum-transfer.json";
  exportTo(path);
}

}  // namespace velum::gui
