#include "gui/window/FileLoads.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>
#include <algorithm>

#include "gui/kit/CoreWords.h"
#include "gui/kit/Preferences.h"
#include "gui/kit/Text.h"
#include "gui/service/RecentFiles.h"
#include "gui/service/Thumbnail.h"
#include "gui/window/RawDialog.h"
#include "gui/window/SeriesDialog.h"
#include "scene/VisibleFrame.h"
#include "scene/json/Paths.h"
#include "session/document/LabelPlace.h"
#include "session/document/Open.h"
#include "session/document/PyramidBeside.h"
#include "session/document/RawFile.h"
#include "session/document/Recent.h"
#include "session/document/Showcase.h"
#include "session/look/Look.h"

namespace velum::gui {

namespace {

/// The notes about the data that was read. @param before  the scene before that, whose data has had its notes already
std::vector<std::string> notesOf(const session::Loaded& loaded, const scene::Scene& before) {
  std::vector<std::string> notes = loaded.notes;
  auto take = [&](const auto& data, const auto& known) {
    if (data && data != known) notes.insert(notes.end(), data->warnings.begin(), data->warnings.end());
  };
  take(loaded.scene.volume.data, before.volume.data);
  take(loaded.scene.labels.data, before.labels.data);
  take(loaded.scene.model.data, before.model.data);
  return notes;
}
/// A folder's name is its last part, also where a slash follows.
QString withoutSlash(const QString& path) { return QDir::cleanPath(QFileInfo(path).absoluteFilePath()); }
double aspectOf(const QWidget& view) { return double(std::max(1, view.width())) / std::max(1, view.height()); }
QString nameOf(const QString& path) { return QFileInfo(path).fileName(); }

/// Shows an error where labels do not lie where the scan lies. @return false where they do
bool sayMisplaced(const WindowParts& parts, const QString& name) {
  std::string misplaced = session::misplacedLabels(parts.session.shown());
  if (!misplaced.empty()) parts.messages.showError(QString("%1: %2").arg(name, inWords(misplaced)));
  return !misplaced.empty();
}

}  // namespace

FileLoads::FileLoads(const WindowParts& parts) : QObject(&parts.window), mParts(parts) {
  connect(&parts.views.viewport(), &Viewport::refined, this, [this](double, const QString& stage) {
    if (stage.isEmpty() && mWantsPicture) rememberPicture();
  });
}

session::DataPolicy FileLoads::policy() const {
  return {.folders = session::recentFolders(session::recentList()),
          .keepsWithoutData = !mUnattended,
          .level = Preferences().level(),
          .quickLevels = true};
}

void FileLoads::start(const QString& what, Read read, bool add, const QString& path) {
  auto loaded = std::make_shared<session::Loaded>();
  mParts.jobs.start(
      what, [loaded, read = std::move(read)](Progress& progress) { *loaded = read(progress); },
      [this, loaded, add, path] {
        if (!add) return finish(loaded, path);
        auto notes = notesOf(*loaded, mParts.session.shown());
        bool hasOtherLabels = !(loaded->scene.labels.data == mParts.session.shown().labels.data);
        mParts.session.file().add(*loaded);
        if (hasOtherLabels) mParts.messages.hide();  // what it said may have been of those before
        if (hasOtherLabels && sayMisplaced(mParts, nameOf(path))) return;
        if (!notes.empty()) mParts.messages.showNote(nameOf(path), notes);
      });
}

void FileLoads::openPaths(const QStringList& paths, bool add) {
  if (paths.isEmpty()) return;
  if (paths.size() == 1 && session::isLookFile(paths.first().toStdString())) return emit lookOpened(paths.first());
  QString one = paths.size() == 1 && !add ? withoutSlash(paths.first()) : QString();
  if (mUnattended) return readPaths(paths, add);
  if (!one.isEmpty() && session::needsLayout(one.toStdString())) return askLayout(one);
  if (one.isEmpty()) return readPaths(paths, add);
  if (session::mayHoldSeries(one.toStdString())) return askSeries(one);
  scene::Source source;
  source.path = one.toStdString();
  openUnlessLarge(source);
}

/// What the samples of a file without a header are.
void FileLoads::askLayout(const QString& path) {
  scene::Source source;
  source.path = path.toStdString();
  auto* dialog = new RawDialog(source, &mParts.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] { openUnlessLarge(dialog->source()); });
  dialog->open();
}

void FileLoads::openWhole(const scene::Source& source) {
  QString path = toText(source.path);
  start(
      tr("Opening %1").arg(nameOf(path)),
      [source, policy = policy()](Progress& progress) { return session::read({source}, progress, policy); }, false,
      path);
}

/// Headers are read first: what takes much memory is not read unasked.
void FileLoads::openUnlessLarge(const scene::Source& source) {
  QString path = toText(source.path);
  auto loaded = std::make_shared<session::Loaded>();
  auto isLarge = std::make_shared<bool>(false);
  mParts.jobs.start(
      tr("Opening %1").arg(nameOf(path)),
      [loaded, isLarge, source, policy = policy()](Progress& progress) {
        *isLarge = session::isTooLarge(source);
        if (!*isLarge) *loaded = session::read({source}, progress, policy);
      },
      [this, loaded, isLarge, source, path] { *isLarge ? emit tooLarge(source) : finish(loaded, path); });
}

/// Looks into a folder; of several series one is chosen.
void FileLoads::askSeries(const QString& path) {
  auto series = std::make_shared<std::vector<session::Series>>();
  mParts.jobs.start(
      tr("Looking into %1").arg(nameOf(path)),
      [series, path = path.toStdString()](Progress& progress) { *series = session::seriesIn(path, progress); },
      [this, series, path] { openSeries(path, *series); });
}

void FileLoads::openSeries(const QString& path, const std::vector<session::Series>& series) {
  bool hasChoice = series.size() > 1 || (series.size() == 1 && !series[0].labels.empty());
  if (!hasChoice) return readPaths({path}, false);
  SeriesDialog dialog(series, nameOf(path), &mParts.window);
  if (dialog.exec() != QDialog::Accepted) return;
  start(
      tr("Opening %1").arg(nameOf(path)),
      [path = path.toStdString(), uid = dialog.series().uid, labels = dialog.labels(),
       policy = policy()](Progress& progress) { return session::readSeries(path, uid, labels, progress, policy); },
      false, path);
}

void FileLoads::readPaths(const QStringList& paths, bool add) {
  std::vector<std::string> names;
  for (const auto& path : paths) names.push_back(withoutSlash(path).toStdString());
  QString first = toText(names.front());
  QString what = tr("Opening %1").arg(nameOf(first));
  bool beside = add && mParts.session.file().isOpen();
  Read read = [names, policy = policy()](Progress& progress) { return session::readPaths(names, progress, policy); };
  if (beside)
    read = [names, scene = mParts.session.shown(), policy = policy()](Progress& progress) {
      return session::readBeside(scene, names, progress, policy);
    };
  start(what, read, beside, first);
}

void FileLoads::openPhantom(const QString& name, int voxels) {
  std::filesystem::path folder(QStandardPaths::writableLocation(QStandardPaths::CacheLocation).toStdString());
  start(
      tr("Making a phantom"),
      [name = name.toStdString(), voxels, folder](Progress& progress) {
        return session::readPhantom(name, voxels, folder / "phantoms", progress);
      },
      false, name);
}

void FileLoads::openSample(const QString& name) {
  std::filesystem::path folder(QStandardPaths::writableLocation(QStandardPaths::CacheLocation).toStdString());
  start(
      tr("Opening a sample"),
      [name = name.toStdString(), folder](Progress& progress) {
        return session::readShowcase(name, folder / "samples", progress);
      },
      false, name);
}

void FileLoads::openLabels(const QString& path) {
  start(
      tr("Opening %1").arg(nameOf(path)),
      [scene = mParts.session.shown(), file = QFileInfo(path).absoluteFilePath().toStdString()](Progress& progress) {
        return session::readLabels(scene, session::sourcesOf({file}).front(), progress);
      },
      true, path);
}

void FileLoads::openLost(const std::filesystem::path& folder, const QString& path) {
  start(
      tr("Restoring %1").arg(nameOf(path)),
      [folder, policy = policy()](Progress& progress) { return session::readLost(folder, progress, policy); }, false,
      path);
}

void FileLoads::finish(std::shared_ptr<session::Loaded> loaded, const QString& path) {
  if (!locateMissing(*loaded)) return show(*loaded, path);
  mParts.jobs.start(
      tr("Opening %1").arg(nameOf(path)),
      [loaded, policy = policy()](Progress& progress) { session::readMissing(*loaded, progress, policy); },
      [this, loaded, path] { show(*loaded, path); });
}

/// Asks for each file that was not found. @return true when some were named, so that they are to be read
bool FileLoads::locateMissing(session::Loaded& loaded) {
  bool found = false;
  for (const auto& missing : session::missingData(loaded.scene)) {
    QFileInfo file(toText(missing.path));
    QMessageBox box(QMessageBox::Question, tr("Missing data"),
                    tr("The %1 of the scene is missing: %2").arg(inWords(missing.what), file.fileName()),
                    QMessageBox::NoButton, &mParts.window);
    box.setInformativeText(tr("It was %1, and is not near the scene, nor where you worked last.").arg(file.filePath()));
    auto* locate = box.addButton(tr("&Locate..."), QMessageBox::AcceptRole);
    auto* skip = box.addButton(tr("&Skip"), QMessageBox::RejectRole);
    box.setDefaultButton(locate);
    box.setEscapeButton(skip);
    box.exec();
    QString path;
    if (box.clickedButton() == locate)
      path = QFileDialog::getOpenFileName(&mParts.window, tr("Where is %1?").arg(file.fileName()), file.path());
    if (path.isEmpty()) {
      loaded.notes.push_back(
          tr("opened without its %1 (%2)").arg(inWords(missing.what), file.filePath()).toStdString());
      continue;
    }
    found = true;
    scene::setField(loaded.scene, missing.field, path.toStdString());
  }
  return found;
}

void FileLoads::show(session::Loaded& loaded, const QString& path) {
  scene::Scene& scene = loaded.scene;
  ViewGrid& views = mParts.views;
  std::vector<std::string> notes = notesOf(loaded, {});
  emit aboutToShow();
  if (!loaded.isScene && !loaded.lost) {
    scene.sections.layout = ViewGrid::layoutFor(scene);
    views.place(scene.sections);  // so that the camera fits the view as it will be
    scene.camera = scene::firstCamera(scene, aspectOf(views.viewport()));
  }
  bool wasLost = loaded.lost != nullptr, isNew = !loaded.isScene && !wasLost;
  session::WorkFile& file = mParts.session.file();
  std::string name = loaded.path.empty() ? path.toStdString() : loaded.path;
  file.open(std::move(loaded), name);
  QString now = toText(file.path());
  rememberFile(now);
  if (wasLost) emit lostWorkTaken();
  views.viewport().setFocus();
  sayNotes(nameOf(now), notes);
  if (isNew && !mUnattended) emit volumeOpened();
}

/// Shows all notes about the data; as an error where slices are missing, as what is seen there was not measured.
void FileLoads::sayNotes(const QString& name, const std::vector<std::string>& notes) {
  if (sayMisplaced(mParts, name)) return;
  const auto& volume = mParts.session.shown().volume.data;
  int missing = 0;
  if (volume)
    for (glm::ivec2 gap : volume->gaps) missing += gap[1];
  if (missing == 0) {
    if (!notes.empty()) mParts.messages.showNote(name, notes);
    return;
  }
  QStringList lines{
      tr("%1: of %2 planes, %3 are missing, and hatched in the sections").arg(name).arg(volume->dims.z).arg(missing)};
  for (const std::string& note : notes) lines << inWords(note);
  mParts.messages.showError(lines.join("; "));
}

void FileLoads::rememberFile(const QString& path) {
  QFileInfo file(path);
  mWantsPicture = !path.isEmpty() && file.exists();
  if (mWantsPicture) session::addRecent(session::recentList(), file.absoluteFilePath().toStdString());
}

void FileLoads::rememberPicture() {
  const session::WorkFile& open = mParts.session.file();
  if (open.isModified()) return;  // the file does not have what is seen
  Viewport& view = mParts.views.viewport();
  QFileInfo file(toText(open.path()));
  mWantsPicture = mWantsPicture && open.isOpen() && !view.isConverged();
  if (!open.isOpen() || open.path().empty() || !file.exists()) return;
  saveRecentPicture(file.absoluteFilePath().toStdString(), view.picture());
  if (view.isConverged()) keepThumbnail(file.absoluteFilePath().toStdString(), view.picture());
}

}  // namespace velum::gui
