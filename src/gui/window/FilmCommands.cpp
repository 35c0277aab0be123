#include "gui/window/FilmCommands.h"

#include <QFileInfo>

#include "gui/kit/CoreWords.h"
#include "gui/window/ReadyFilmDialog.h"
#include "gui/window/SaveFilmDialog.h"
#include "session/Session.h"
#include "session/command/FilmCommands.h"
#include "session/command/SaveFilm.h"

namespace velum::gui {

namespace {

using session::ReadyFilm;

constexpr std::size_t kReadyFilms = std::size(EnumNames<ReadyFilm>::kNames);

QString nameOf(ReadyFilm film) { return QString::fromStdString(std::string(enumName(film))); }

}  // namespace

FilmCommands::FilmCommands(const WindowParts& parts) : Room(parts) {
  QMenu* menu = parts.menu(MenuId::Film);
  menu->setToolTipsVisible(true);
  for (std::size_t i = 0; i < kReadyFilms; ++i) {
    ReadyFilm film = ReadyFilm(i);
    mReady[nameOf(film)] = parts.actions.addForScene(menu, "film." + nameOf(film), readyFilmTitle(film) + "...",
                                                     readyFilmTip(film), [this, film] { askReady(film); });
  }
  menu->addSeparator();
  parts.actions.addForScene(menu, "film.save", tr("S&ave film..."),
                            tr("Draw the film of the scene, and save it as a video or as frames"),
                            [this] { askSaveFilm(); });
  mClear = parts.actions.addForScene(menu, "film.clear", tr("C&lear film"), tr("Remove all keys of the film"),
                                     [this] { mParts.jobs.run(session::ClearFilm{}); });
}

void FilmCommands::refresh(const session::Session& session) {
  const scene::Scene& scene = session.scene();
  bool isOpen = session.file().isOpen();
  for (std::size_t i = 0; i < kReadyFilms; ++i) {
    ReadyFilm film = ReadyFilm(i);
    QAction* action = mReady[nameOf(film)];
    QString why = inWords(session::whyNoFilm(scene, film));
    action->setEnabled(isOpen && why.isEmpty());
    mParts.actions.rename(action, action->text(),
                          why.isEmpty() ? readyFilmTip(film) : tr("%1: %2").arg(readyFilmTip(film), why));
  }
  mClear->setEnabled(isOpen && !scene.timeline.tracks.empty());
}

void FilmCommands::askReady(ReadyFilm film) {
  session::Document& document = mParts.document();
  ReadyFilmDialog dialog(document.scene(), film, document.playhead().value_or(0.0), &mParts.window);
  if (dialog.exec() != QDialog::Accepted) return;
  mParts.jobs.run(dialog.call());
  if (dialog.savesFilm() && mParts.jobs.lastError().isEmpty()) askSave(true);
}

void FilmCommands::askSave(bool asMp4) {
  const Viewport& viewport = mParts.views.viewport();
  double ratio = viewport.devicePixelRatioF();
  QString name = QFileInfo(QString::fromStdString(mParts.session.file().path())).baseName();
  SaveFilmDialog dialog({int(viewport.width() * ratio), int(viewport.height() * ratio)}, mParts.document().scene(),
                        name.isEmpty() ? tr("film") : name, &mParts.window);
  dialog.recall();
  if (asMp4) dialog.setFormat(SaveFilmDialog::Mp4);
  if (dialog.exec() != QDialog::Accepted) return;
  dialog.remember();
  saveFilmTo(dialog.output(), dialog.filmScene());
}

void FilmCommands::saveFilmTo(const session::FilmOutput& output, const scene::Scene& scene) {
  auto report = std::make_shared<session::FilmReport>();
  bool wasBusy = mParts.jobs.isBusy();
  std::vector<std::string> notes = session::filmNotes(scene, output);
  mParts.jobs.start(
      tr("Drawing %1").arg(QFileInfo(QString::fromStdString(output.path.string())).fileName()),
      [report, scene, output](Progress& progress) { *report = session::Session(scene).film(output, progress); },
      [this, report, output, notes] { tell(*report, output, notes); });
  if (!wasBusy && !notes.empty()) mParts.messages.showNote({}, notes);
}

void FilmCommands::tell(const session::FilmReport& report, const session::FilmOutput& output,
                        const std::vector<std::string>& notes) {
  QString path = QString::fromStdString(output.path.string());
  int there = report.drawn + report.kept;
  QString failed = QString::fromStdString(session::failedFrames(report));
  if (report.isStopped && there == 0) return mParts.messages.showNote(tr("Stopped: there is no frame yet."));
  if (report.isStopped)
    return mParts.messages.showNote(tr("Stopped: %1 of %2 frames are in %3").arg(there).arg(report.frames).arg(path),
                                    notes);
  if (!failed.isEmpty()) return mParts.jobs.setError(QString("%1: %2").arg(path, failed));
  mParts.messages.showNote(tr("Saved %1: %2 frames").arg(path).arg(report.frames), notes);
}

}  // namespace velum::gui
