// What the dialog makes of what is chosen in it.

#include <QClipboard>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMessageBox>
#include <QSignalBlocker>

#include "gui/kit/CoreWords.h"
#include "gui/kit/Widgets.h"
#include "gui/service/KeepScene.h"
#include "gui/service/SavePath.h"
#include "gui/window/SaveFilmDialog.h"
#include "scene/timeline/SceneAt.h"
#include "session/film/FrameNames.h"
#include "session/film/ReadyFilms.h"

namespace velum::gui {

namespace {

/// Of the files of each format.
constexpr const char* kEndings[] = {"mp4", "webm", "gif", "png", "exr"};

/// The path with another ending in the place of the one that it has.
QString withEnding(const QString& path, const QString& ending) {
  QFileInfo file(path);
  bool isFormat = std::ranges::any_of(kEndings, [&](const char* one) { return file.suffix().toLower() == one; });
  return file.path() + "/" + (isFormat ? file.completeBaseName() : file.fileName()) + "." + ending;
}

}  // namespace

void SaveFilmDialog::browse() {
  QStringList filters;
  for (int i = 0; i < mFormat->count(); ++i) filters << QString("%1 (*.%2)").arg(mFormat->itemText(i), kEndings[i]);
  QString path = askSavePath(this, tr("Save film"), mPath->text(), filters.join(";;"));
  if (path.isEmpty()) return;
  mPath->setText(path);
  takePath();
  mReplaced = mPath->text();
}

/// A new format changes the ending of the path.
void SaveFilmDialog::takeFormat() {
  mPath->setText(withEnding(mPath->text(), kEndings[mFormat->currentIndex()]));
  bool isVideo = mFormat->currentIndex() <= Gif;
  mTransparent->setEnabled(mFormat->currentIndex() != Mp4);
  mVideoQuality->setEnabled(isVideo && mFormat->currentIndex() != Gif);
  mSixteenBits->setEnabled(!isVideo);
  mLayers->setEnabled(!isVideo);
  updateText();
}

/// An ending that is typed changes the format; without one the path gets that of the format.
void SaveFilmDialog::takePath() {
  QString ending = QFileInfo(mPath->text()).suffix().toLower();
  for (int i = 0; i < mFormat->count(); ++i)
    if (ending == kEndings[i]) mFormat->setCurrentIndex(i);
  takeFormat();
}

void SaveFilmDialog::setSize(glm::ivec2 size) {
  const QSignalBlocker quietWidth(mWidth), quietHeight(mHeight);
  mWidth->setValue(size.x);
  mHeight->setValue(size.y);
  showSize();
}

/// Names the size in the list, where it is in it.
void SaveFilmDialog::showSize() {
  int known = mSizes->findData(QSize(mWidth->value(), mHeight->value()));
  mSizes->setCurrentIndex(known < 0 ? mSizes->count() - 1 : known);
  showFilm();
}

scene::Scene SaveFilmDialog::filmScene() const {
  scene::Scene scene = mScene;
  scene::Timeline& film = scene.timeline;
  scene.background.transparent = mTransparent->isEnabled() && mTransparent->isChecked();
  film.framesPerSecond = mRate->value();
  if (mRange->currentIndex() == 0) film.rangeStart = film.rangeEnd = 0.0;
  if (film.tracks.empty()) session::addReadyFilm(scene, session::usualFilm(scene), {0.0, film.duration});
  return scene;
}

session::FilmOutput SaveFilmDialog::output() const {
  session::FilmOutput output;
  bool isVideo = mFormat->currentIndex() <= Gif;
  output.path = mPath->text().toStdString();
  output.picture.size = {mWidth->value(), mHeight->value()};
  output.picture.samples = mSamples->samples();
  output.picture.transparent = mTransparent->isEnabled() && mTransparent->isChecked();
  output.picture.layers = !isVideo && mLayers->isChecked();
  output.picture.bits = !isVideo && mSixteenBits->isChecked() ? 16 : 8;
  output.framesPerSecond = mRate->value();
  output.quality = mVideoQuality->value();
  output.blur = mBlur->value();
  output.old = {!isVideo, !isVideo};
  return output;
}

void SaveFilmDialog::showFilm() {
  mTime.reset();
  mPreview->show({[scene = filmScene()](Progress&) { return scene; }, {}, {mWidth->value(), mHeight->value()}, true});
  updateText();
}

void SaveFilmDialog::tell(const QString& why) {
  mWhyNot = why;
  updateText();
}

QString SaveFilmDialog::facts() const {
  scene::FilmFrames frames = scene::framesOf(filmScene().timeline);
  QString text = tr("%n frames, %1 s at %2 frames a second", nullptr, frames.count)
                     .arg(QLocale().toString(frames.count / frames.framesPerSecond, 'g', 4),
                          QLocale().toString(frames.framesPerSecond, 'g', 4));
  if (mTime) {
    double megapixels = 1e-6 * mWidth->value() * mHeight->value();
    double pictureMs = mTime->fixedMs + mTime->msPerMegapixel * megapixels * mSamples->samples();
    text += tr(", about %1 to draw")
                .arg(QString::fromStdString(session::sayTime(1e-3 * pictureMs * mBlur->value() * frames.count)));
  }
  text += ".";
  if (mScene.timeline.tracks.empty())
    text += session::usualFilm(mScene) == session::ReadyFilm::Time
                ? tr(" The scene has no film: this one goes through the time steps.")
                : tr(" The scene has no film: this one goes once round.");
  if (mFormat->currentIndex() > Gif) {
    session::FrameNames names(mPath->text().toStdString());
    text += tr(" The frames are %1, ...").arg(QString::fromStdString(names.frame(0).filename().string()));
  }
  return text;
}

/// What is chosen, and what stands against it.
void SaveFilmDialog::updateText() {
  if (!mFacts || !mMain) return;
  mFacts->setText(facts());
  // Whether it can be done does not depend on the place, which may be typed yet.
  session::FilmOutput output = this->output();
  output.path = (QDir::tempPath() + "/velum-film." + kEndings[mFormat->currentIndex()]).toStdString();
  QString why = mWhyNot;
  bool isPossible = why.isEmpty();
  try {
    session::expectFilmOutput(output);
    if (isPossible) why = inWords(session::filmNote(output));
  } catch (const std::exception& error) {
    why = inWords(error.what());
    isPossible = false;
  }
  why.remove(QString::fromStdString(output.path.string()) + ": ");
  sayIn(*mNote, why.left(1).toUpper() + why.mid(1), !isPossible);
  mNote->setVisible(!why.isEmpty());
  mMain->setEnabled(isPossible);
}

/// Asks, where something is there, and it has not been asked yet.
bool SaveFilmDialog::mayReplace() {
  QString name = QFileInfo(mPath->text()).fileName();
  if (mPath->text() == mReplaced && mFormat->currentIndex() <= Gif) return true;
  if (mFormat->currentIndex() <= Gif)
    return !QFileInfo::exists(mPath->text()) ||
           QMessageBox::question(this, windowTitle(), tr("%1 already exists.\nReplace it?").arg(name)) ==
               QMessageBox::Yes;
  return session::FrameNames(mPath->text().toStdString()).manifests().empty() ||
         QMessageBox::question(this, windowTitle(),
                               tr("Frames with this name are there already.\nThose of this very film are kept, those "
                                  "of another film are replaced. Go on?")) == QMessageBox::Yes;
}

void SaveFilmDialog::accept() {
  takePath();
  try {
    session::expectFilmOutput(output());
    if (mayReplace()) QDialog::accept();
  } catch (const std::exception& error) {
    sayIn(*mNote, inWords(error.what()), true);
    mNote->show();
  }
}

QString SaveFilmDialog::command() const {
  return QString::fromStdString(session::filmCommand(keepScene(filmScene()), output()));
}

void SaveFilmDialog::copyCommand() {
  try {
    takePath();
    QString text = command();
    QGuiApplication::clipboard()->setText(text);
    mFacts->setText(tr("Copied: %1").arg(text));
  } catch (const std::exception& error) {
    mFacts->setText(inWords(error.what()));
  }
}

}  // namespace velum::gui
