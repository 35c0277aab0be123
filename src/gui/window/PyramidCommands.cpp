#include "gui/window/PyramidCommands.h"

#include <QApplication>
#include <QFileInfo>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "gui/kit/CoreWords.h"
#include "gui/kit/Preferences.h"
#include "gui/kit/Text.h"
#include "session/document/Sources.h"

namespace velum::gui {

namespace {

constexpr double kGiB = double(1u << 30);
constexpr int kMostRemembered = 200;  // files about which the offer has been made
const char* const kOffered = "volumes/pyramidOffered";

QString sayBytes(double bytes) {
  return bytes < kGiB ? PyramidCommands::tr("%1 MiB").arg(std::ceil(bytes / (1 << 20)), 0, 'f', 0)
                      : PyramidCommands::tr("%L1 GiB").arg(bytes / kGiB, 0, 'f', 1);
}

QString sayDuration(double seconds) {
  if (seconds < 90) return PyramidCommands::tr("%1 s").arg(std::max(1.0, std::round(seconds)));
  if (seconds < 5400) return PyramidCommands::tr("%1 min").arg(std::round(seconds / 60));
  return PyramidCommands::tr("%L1 h").arg(seconds / 3600, 0, 'f', 1);
}

QString nameOf(const std::filesystem::path& path) { return toText(path.filename().string()); }

/// True once for each file as it is now.
bool isFirstOffer(const std::string& path) {
  Preferences preferences;
  QStringList known = preferences.value(kOffered).toStringList();
  QString key = toText(session::fingerprintOf(path));
  if (known.contains(key)) return false;
  known << key;
  while (known.size() > kMostRemembered) known.removeFirst();
  preferences.setValue(kOffered, known);
  return true;
}

QString whatItTakes(const session::PyramidBeside& plan) {
  QString name = nameOf(plan.path);
  if (plan.isThere) return PyramidCommands::tr("%1 beside it has the same voxels and coarser levels.").arg(name);
  if (!plan.obstacle.empty())
    return PyramidCommands::tr("A pyramid beside it would let it open at once, but it cannot be written: %1")
        .arg(inWords(plan.obstacle));
  QString text = PyramidCommands::tr(
                     "A pyramid beside it, %1, lets it open at once and be streamed. It takes up to %2 of "
                     "the disk, of which %3 are free, and about %4 on a machine that has little else to do; you can go "
                     "on working meanwhile. The "
                     "file itself stays as it is.")
                     .arg(name, sayBytes(plan.diskBytes), sayBytes(plan.freeBytes), sayDuration(plan.seconds));
  if (plan.isBegun)
    text += " " + PyramidCommands::tr("It was begun and stopped; what is there already is not written again.");
  return text;
}

}  // namespace

PyramidCommands::PyramidCommands(const WindowParts& parts, FileLoads& loads) : Room(parts), mLoads(loads) {
  mMake = parts.actions.addForScene(
      parts.menu(MenuId::Edit), "edit.makePyramid", tr("Make a p&yramid beside it..."),
      tr("Write the open file with coarser levels beside it, as OME-Zarr: what opens at once, whatever its size"),
      [this] { look(mParts.session.shown().volume.source, Why::Asked); });
  mStrip = new ProgressStrip(parts.floating.host());
  mStrip->findChild<QPushButton*>("cancel")->setToolTip(
      tr("Stop writing; what is on the disk stays, and the next writer goes on"));
  parts.floating.addToBottom(*mStrip);
  connect(mStrip, &ProgressStrip::cancelled, this, [this] {
    if (mJob) mJob->cancel();
  });
  connect(&loads, &FileLoads::volumeOpened, this, [this] { look(mParts.session.shown().volume.source, Why::Opened); });
  connect(&loads, &FileLoads::tooLarge, this, [this](const scene::Source& source) { look(source, Why::TooLarge); });
}

void PyramidCommands::refresh(const session::Session& session) {
  const scene::VolumeLayer& layer = session.shown().volume;
  mMake->setEnabled(layer.data && !layer.source.path.empty() && !layer.data->finer && !isWriting());
}

bool PyramidCommands::isOpen(const scene::Source& source) const {
  const scene::VolumeLayer& layer = mParts.session.shown().volume;
  return layer.data && layer.source.path == source.path && layer.source.raw == source.raw;
}

/// Headers of files of many pages take a moment.
void PyramidCommands::look(const scene::Source& source, Why why) {
  if (mLook || isWriting() || source.path.empty()) return;
  auto found = std::make_shared<std::optional<session::PyramidBeside>>();
  mLook =
      new Job([found, source, why](Progress&) { *found = session::pyramidBeside(source, why == Why::Asked); }, this);
  connect(mLook, &Job::finished, this, [this, found, source, why](bool done, const QString& error) {
    mLook->deleteLater();
    mLook = nullptr;
    if (!done && why != Why::Opened && !error.isEmpty()) mParts.messages.showError(error);
    if (!done) return;
    if (*found) return offer(source, **found, why);
    if (why == Why::Asked)
      mParts.messages.showNote(
          tr("%1 has levels already, or cannot be read piece by piece; Save as writes a pyramid of what is open.")
              .arg(nameOf(source.path)));
  });
  mLook->start();
}

void PyramidCommands::offer(const scene::Source& source, const session::PyramidBeside& plan, Why why) {
  if (mOffer || (why == Why::Opened && !isOpen(source))) return;
  if (auto* asks = qobject_cast<QDialog*>(QApplication::activeModalWidget()); asks && why == Why::Opened) {
    connect(
        asks, &QDialog::finished, this, [this, source, plan, why] { offer(source, plan, why); },
        Qt::ConnectionType(Qt::QueuedConnection | Qt::SingleShotConnection));
    return;
  }
  if (why == Why::Opened && !isFirstOffer(source.path) && !plan.isBegun) return;
  bool canMake = plan.isThere || plan.obstacle.empty();
  mOffer = new QMessageBox(
      QMessageBox::Question, tr("Pyramid"),
      tr("%1 has %2 of voxels and no coarser levels.").arg(nameOf(source.path), sayBytes(plan.sampleBytes)),
      QMessageBox::NoButton, &mParts.window);
  mOffer->setObjectName("pyramidOffer");
  mOffer->setAttribute(Qt::WA_DeleteOnClose);
  mOffer->setInformativeText(whatItTakes(plan));
  if (canMake) {
    auto* make = mOffer->addButton(plan.isThere ? tr("&Use it") : tr("&Make the pyramid"), QMessageBox::AcceptRole);
    mOffer->setDefaultButton(make);
    connect(make, &QPushButton::clicked, this,
            [this, source, plan] { plan.isThere ? use(source, toText(plan.path.string())) : write(source, plan); });
  }
  if (why == Why::TooLarge && plan.fitsMemory) {
    auto* whole = mOffer->addButton(tr("Read it &whole"), QMessageBox::ActionRole);
    whole->setToolTip(tr("It takes %1 of memory").arg(sayBytes(plan.sampleBytes)));
    connect(whole, &QPushButton::clicked, this, [this, source] { mLoads.openWhole(source); });
  }
  auto* later = mOffer->addButton(canMake ? tr("&Not now") : tr("&Close"), QMessageBox::RejectRole);
  mOffer->setEscapeButton(later);
  mOffer->open();
}

void PyramidCommands::write(const scene::Source& source, const session::PyramidBeside& plan) {
  if (isWriting()) return;
  mSource = source;
  mPath = toText(plan.path.string());
  mFirst = -1;
  mSince.start();
  mStrip->begin(tr("Making %1").arg(nameOf(plan.path)));
  mJob =
      new Job([source, to = plan.path](Progress& progress) { session::makePyramidBeside(source, to, progress); }, this);
  connect(mJob, &Job::progressed, this, &PyramidCommands::showProgress);
  connect(mJob, &Job::finished, this, &PyramidCommands::ended);
  mJob->start();
  refresh(mParts.session);
}

/// With the time that is left, by what has been written since this writer began.
void PyramidCommands::showProgress(double fraction, const QString& what) {
  if (mFirst < 0) mFirst = fraction;
  double seconds = double(mSince.elapsed()) / 1000.0, done = fraction - mFirst;
  bool isKnown = seconds > 2.0 && done > 0.01 && fraction < 1.0;
  mStrip->setProgress(fraction,
                      isKnown ? tr("%1, %2 left").arg(what, sayDuration(seconds * (1.0 - fraction) / done)) : what);
}

void PyramidCommands::ended(bool done, const QString& error) {
  mJob->deleteLater();
  mJob = nullptr;
  mStrip->hide();
  refresh(mParts.session);
  if (done) return use(mSource, mPath);
  QString name = QFileInfo(mPath).fileName();
  error.isEmpty()
      ? mParts.messages.showNote(tr("%1 is not whole; Edit > Make a pyramid goes on where it was.").arg(name))
      : mParts.messages.showError(error);
}

/// Where the file is open its voxels come from the pyramid from now on; else the pyramid is opened if nothing is lost.
void PyramidCommands::use(const scene::Source& source, const QString& pyramid) {
  if (mParts.jobs.isBusy()) {
    connect(
        &mParts.jobs, &JobRunner::ended, this, [this, source, pyramid] { use(source, pyramid); },
        Qt::ConnectionType(Qt::QueuedConnection | Qt::SingleShotConnection));
    return;
  }
  QString name = QFileInfo(pyramid).fileName();
  const scene::Scene& scene = mParts.session.shown();
  if (isOpen(source) && scene.labels.growths.empty()) {
    emit sourceWanted(tr("Use the pyramid"), session::withPyramid(scene.volume.source, pyramid.toStdString()));
    return mParts.messages.showNote(
        tr("%1 is whole: the open scene takes its voxels from it. Undo goes back.").arg(name));
  }
  if (!mParts.session.file().isOpen()) return emit openWanted(pyramid);
  mParts.messages.showNote(
      isOpen(source) ? tr("%1 is whole. What was grown in the open file stays there; open %1 to use it.").arg(name)
                     : tr("%1 is whole: open it to use it.").arg(name));
}

}  // namespace velum::gui
