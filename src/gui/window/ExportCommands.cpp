#include "gui/window/ExportCommands.h"

#include <QFileInfo>
#include <QStandardPaths>
#include <cmath>

#include "core/ReplaceFile.h"
#include "gui/kit/Preferences.h"
#include "gui/service/SavePath.h"
#include "gui/service/SelectedCut.h"
#include "gui/window/ExportStructuresDialog.h"
#include "gui/window/SavePictureDialog.h"
#include "session/Session.h"
#include "session/membrane/Membranes.h"
#include "session/model/CountPictures.h"
#include "session/model/ModelExport.h"
#include "session/picture/Export.h"

namespace velum::gui {

namespace {

/// The size of the picture saved last; the size of a slide before any was saved.
glm::ivec2 usualPictureSize() {
  QSize size = Preferences().value(kPictureSizeKey).toSize();
  return size.isEmpty() ? glm::ivec2(1920, 1080) : glm::ivec2(size.width(), size.height());
}

}  // namespace

void ExportCommands::addActions(QMenu* menu) {
  QAction* picture =
      mParts.actions.addForScene(menu, "file.savePicture", tr("Save p&icture..."),
                                 tr("Draw and save a picture of any size"), [this] { askSavePicture(); });
  mParts.actions.addForScene(menu, "file.exportSheet", tr("Export s&heet..."),
                             tr("Write the sheet of a membrane as a surface"), [this] { askExportSheet(); });
  mParts.actions.addForScene(menu, "file.exportClipped", tr("Export clipped vol&ume..."),
                             tr("Write the volume without what the cuts take away"), [this] { askExportClipped(); });
  mParts.actions.addForScene(menu, "file.exportStructures", tr("Export s&tructures..."),
                             tr("Write structures as surfaces or as labels, for other programs"),
                             [this] { emit exportStructuresAsked(); });
  mParts.actions.addForScene(menu, "file.exportModel", tr("Export mo&del..."),
                             tr("Write the instances that cuts leave of the model"), [this] { askExportModel(); });
  mParts.actions.addForScene(menu, "file.exportBars", tr("Export &bars..."),
                             tr("Write how many instances of each type are seen, hidden and removed: SVG or CSV"),
                             [this] { askExportBars(); });
  picture->setIconText(tr("Save picture"));
}

// Pictures.

void ExportCommands::askSavePicture() {
  const Viewport& viewport = mParts.views.viewport();
  double ratio = viewport.devicePixelRatioF();
  SavePictureDialog dialog({int(viewport.width() * ratio), int(viewport.height() * ratio)}, usualPictureSize(),
                           mParts.session.shown(), &mParts.window);
  dialog.recall();
  if (dialog.exec() != QDialog::Accepted) return;
  dialog.remember();
  QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  QString start = (pictures.isEmpty() ? QString() : pictures + "/") +
                  QFileInfo(QString::fromStdString(mParts.session.file().path())).baseName() +
                  (dialog.options().layers ? ".exr" : ".png");
  QString path = askSavePath(&mParts.window, tr("Save picture"), start,
                             saveFilters(io::FileKind::Picture) + tr(";;Drawing of lines and letters (*.svg *.pdf)"));
  if (path.isEmpty()) return;
  savePictureTo(path, dialog.options(), dialog.pictureScene());
}

void ExportCommands::savePictureTo(const QString& path, const session::PictureOptions& options,
                                   const scene::Scene& scene) {
  auto notes = std::make_shared<std::vector<std::string>>();
  mParts.jobs.start(
      tr("Drawing %1").arg(QFileInfo(path).fileName()),
      [scene, options, notes, path = path.toStdString()](Progress& progress) {
        *notes = session::Session(scene).savePicture(options, {}, path, progress);
      },
      [this, notes, path] { mParts.messages.showNote(tr("Saved %1").arg(path), *notes); });
}

// Sheets, and what they leave.

/// Id of the selected membrane, else of the first one that is enabled; 0: none.
int ExportCommands::membraneToExport() const {
  const scene::Scene& scene = mParts.session.shown();
  if (const scene::Cut* selected = selectedMembrane(mParts.document(), mParts.selection)) return selected->id;
  for (const auto& cut : scene.cuts)
    if (scene::isMembrane(cut) && cut.enabled) return cut.id;
  return 0;
}

/// A function, to be called in a worker, that returns the scene at rest: sheets that rest or are held as the window
/// shows them, other sheets where they will come to rest, as the same scene always gives the same sheets.
std::function<scene::Scene(Progress&)> ExportCommands::sceneAtRest() const {
  const session::MembraneMover& player = mParts.session.membranes();
  scene::Scene scene = mParts.session.shown();
  bool isShown = player.isSettled() || !player.isPlaying();
  if (isShown || !session::hasMembranes(scene))
    return [shown = player.withShapes(std::move(scene))](Progress&) { return shown; };
  return [scene = std::move(scene)](Progress& progress) { return session::Session(scene).settled(progress); };
}

void ExportCommands::write(const QString& path, Write work) {
  auto losses = std::make_shared<std::vector<std::string>>();
  mParts.jobs.start(
      tr("Writing %1").arg(QFileInfo(path).fileName()),
      [losses, rest = sceneAtRest(), work = std::move(work), path = path.toStdString()](Progress& progress) {
        expectReplaceable(path);
        *losses = work(rest(progress), progress);
      },
      [this, losses, path] { mParts.messages.showNote(tr("Saved %1").arg(path), *losses); });
}

void ExportCommands::exportSheetTo(const QString& path) {
  int cut = membraneToExport();
  if (cut == 0) return mParts.messages.showNote(tr("There is no membrane: add one first (M)."));
  write(path, [cut, path = path.toStdString()](const scene::Scene& settled, Progress&) {
    return session::exportSheets(settled, {cut}, path);
  });
}

void ExportCommands::exportClippedTo(const QString& path) {
  write(path, [path = path.toStdString()](const scene::Scene& settled, Progress& progress) {
    return session::exportClippedVolume(settled, path, progress);
  });
}

void ExportCommands::exportModelTo(const QString& path) {
  write(path, [path = path.toStdString()](const scene::Scene& settled, Progress& progress) {
    return session::exportModel(settled, path, progress).losses;
  });
}

void ExportCommands::exportBarsTo(const QString& path) {
  const Viewport& viewport = mParts.views.viewport();
  double ratio = viewport.devicePixelRatioF();
  glm::ivec2 size(std::lround(viewport.width() * ratio), std::lround(viewport.height() * ratio));
  write(path, [path = path.toStdString(), size](const scene::Scene& settled, Progress& progress) {
    session::writeBars(settled, glm::max(size, 1), path, progress);
    return std::vector<std::string>();
  });
}

/// A file beside what is open. @param suffix  of the name that is proposed, with its ending, which is also the usual
/// one
QString ExportCommands::askPath(const QString& title, const char* suffix, const QString& filters) {
  QFileInfo open(QString::fromStdString(mParts.session.file().path()));
  QString start = open.path() + "/" + open.baseName() + suffix;
  return askSavePath(&mParts.window, title, start, filters);
}

void ExportCommands::askExportModel() {
  if (!mParts.session.shown().model.data) return mParts.messages.showNote(tr("No model is open."));
  QString path = askPath(tr("Export model"), "-model.cif", saveFilters(io::FileKind::Model));
  if (!path.isEmpty()) exportModelTo(path);
}

void ExportCommands::askExportBars() {
  if (!mParts.session.shown().model.data) return mParts.messages.showNote(tr("No model is open."));
  QString path = askPath(tr("Export bars"), "-bars.svg", tr("SVG (*.svg);;Table (*.csv)"));
  if (!path.isEmpty()) exportBarsTo(path);
}

void ExportCommands::askExportSheet() {
  if (membraneToExport() == 0) return mParts.messages.showNote(tr("There is no membrane: add one first (M)."));
  QString path = askPath(tr("Export sheet"), "-sheet.ply", saveFilters(io::FileKind::Surface));
  if (!path.isEmpty()) exportSheetTo(path);
}

void ExportCommands::askExportClipped() {
  if (!mParts.session.shown().volume.data) return mParts.messages.showNote(tr("There is no volume to clip."));
  QString path = askPath(tr("Export clipped volume"), "-clipped.nrrd", saveFilters(io::FileKind::Volume));
  if (!path.isEmpty()) exportClippedTo(path);
}

// Structures.

void ExportCommands::exportStructuresTo(const QString& path, const session::StructureExport& what) {
  if (!mParts.session.shown().labels.data) return mParts.messages.showNote(tr("There are no structures to export."));
  auto losses = std::make_shared<std::vector<std::string>>();
  mParts.jobs.start(
      tr("Writing %1").arg(QFileInfo(path).fileName()),
      [losses, what, scene = mParts.session.shown(), path = path.toStdString()](Progress& progress) {
        *losses = session::exportStructures(scene, path, what, progress);
      },
      [this, losses, path] { mParts.messages.showNote(tr("Saved %1").arg(path), *losses); });
}

void ExportCommands::askExportStructures(const std::vector<int>& selected) {
  if (!mParts.session.shown().labels.data) return mParts.messages.showNote(tr("There are no structures to export."));
  ExportStructuresDialog dialog(mParts.session.shown(), selected, &mParts.window);
  if (dialog.exec() != QDialog::Accepted) return;
  QString filters = saveFilters(io::FileKind::Surface) + ";;" + saveFilters(io::FileKind::Labels);
  QString path = askPath(tr("Export structures"), "-structures.stl", filters);
  if (!path.isEmpty()) exportStructuresTo(path, dialog.options());
}

}  // namespace velum::gui
