// The main window's wiring of a membrane's brushes, and what it writes of membranes for other programs.
#include <QFileDialog>
#include <QFileInfo>

#include "MainWindow.h"
#include "cut/CutPanel.h"
#include "membrane/ProtectTool.h"
#include "membrane/SketchTool.h"
#include "velum/session/membrane/Membranes.h"
#include "velum/session/picture/Export.h"

namespace velum::gui {

void MainWindow::buildSketch() {
  MembraneForm& form = mCuts->membraneForm();
  SketchForm& panel = form.sketch();
  mSketch = new SketchTool(mDocument, *mViews, *mSelection, *mMessages, this);
  connect(&panel, &SketchForm::brushAsked, mSketch, [this](bool on, bool avoid) {
    mProtect->stop();
    on ? mSketch->start(avoid) : mSketch->stop();
  });
  connect(&form, &MembraneForm::protectAsked, mSketch, [this](bool on) {
    if (on) mSketch->stop();
  });
  connect(&panel, &SketchForm::radiusAsked, mSketch, &SketchTool::setRadius);
  connect(&panel, &SketchForm::radiusSettled, mSketch, &SketchTool::settleRadius);
  connect(&panel, &SketchForm::strokeSelected, mSketch, &SketchTool::select);
  connect(&panel, &SketchForm::removeAsked, mSketch, &SketchTool::remove);
  connect(mSketch, &SketchTool::ended, &panel, &SketchForm::brushEnded);
  connect(mSketch, &SketchTool::radiusChanged, &panel, &SketchForm::showRadius);
  connect(mSketch, &SketchTool::selectedChanged, &panel, &SketchForm::showSelected);
  connect(&form, &MembraneForm::exportSheetAsked, this, &MainWindow::askExportSheet);
  connect(&form, &MembraneForm::exportClippedAsked, this, &MainWindow::askExportClipped);
}

void MainWindow::buildExportActions(QMenu* menu) {
  mActions->addForScene(menu, "file.exportSheet", tr("Export s&heet..."),
                        tr("Write the sheet of a membrane as a surface: OBJ, PLY, VTP or STL"),
                        [this] { askExportSheet(); });
  mActions->addForScene(menu, "file.exportClipped", tr("Export &clipped volume..."),
                        tr("Write the volume without what the cuts take away: NRRD, NIfTI, VTI or OpenVDB"),
                        [this] { askExportClipped(); });
}

/// Id of the selected one, else of the first that is enabled; 0: none.
int MainWindow::membraneToExport() const {
  const scene::Cut* selected = scene::findCut(mDocument.scene(), mSelection->cut());
  if (selected && scene::isMembrane(*selected)) return selected->id;
  for (const auto& cut : mDocument.scene().cuts)
    if (scene::isMembrane(cut) && cut.enabled) return cut.id;
  return 0;
}

/// The sheets as the window shows them where they rest or are held; else where they will come to rest, as the same
/// scene always gives the same sheets. To be called in a worker.
std::function<scene::Scene(Progress&)> MainWindow::sceneAtRest() const {
  const session::MembranePlayer& player = mViewport->membranes();
  scene::Scene scene = mDocument.scene();
  bool isShown = player.isSettled() || !player.isPlaying();
  if (isShown || !session::hasMembranes(scene))
    return [shown = player.withShapes(std::move(scene))](Progress&) { return shown; };
  return [scene = std::move(scene)](Progress& progress) { return session::settledHeadless(scene, progress); };
}

void MainWindow::exportSheetTo(const QString& path) {
  int cut = membraneToExport();
  if (cut == 0) return mMessages->showNote(tr("There is no membrane: add one first (M)."));
  startJob(
      tr("Writing %1").arg(QFileInfo(path).fileName()),
      [rest = sceneAtRest(), cut, path = path.toStdString()](Progress& progress) {
        session::exportSheets(rest(progress), {cut}, path);
      },
      [this, path] { mMessages->showNote(tr("Saved %1").arg(path)); });
}

void MainWindow::exportClippedTo(const QString& path) {
  startJob(
      tr("Writing %1").arg(QFileInfo(path).fileName()),
      [rest = sceneAtRest(), path = path.toStdString()](Progress& progress) {
        session::exportClippedVolume(rest(progress), path, progress);
      },
      [this, path] { mMessages->showNote(tr("Saved %1").arg(path)); });
}

void MainWindow::askExportSheet() {
  if (membraneToExport() == 0) return mMessages->showNote(tr("There is no membrane: add one first (M)."));
  QString start = QFileInfo(mPath).path() + "/" + QFileInfo(mPath).baseName() + "-sheet.ply";
  QString path = QFileDialog::getSaveFileName(
      this, tr("Export sheet"), start, tr("PLY (*.ply);;Wavefront OBJ (*.obj);;VTK PolyData (*.vtp);;STL (*.stl)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += ".ply";
  exportSheetTo(path);
}

void MainWindow::askExportClipped() {
  if (!mDocument.scene().volume.data) return mMessages->showNote(tr("There is no volume to clip."));
  QString start = QFileInfo(mPath).path() + "/" + QFileInfo(mPath).baseName() + "-clipped.nrrd";
  QString path =
      QFileDialog::getSaveFileName(this, tr("Export clipped volume"), start,
                                   tr("NRRD (*.nrrd);;NIfTI (*.nii.gz *.nii);;VTK ImageData (*.vti);;OpenVDB (*.vdb)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += ".nrrd";
  exportClippedTo(path);
}

}  // namespace velum::gui
