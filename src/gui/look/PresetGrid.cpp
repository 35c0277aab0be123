#include "gui/look/PresetGrid.h"

#include <QVBoxLayout>
#include <algorithm>

#include "gui/kit/Length.h"
#include "gui/kit/Widgets.h"
#include "gui/service/CallLater.h"
#include "scene/Presets.h"
#include "scene/Shown.h"
#include "session/command/Command.h"
#include "session/command/LookCommands.h"
#include "session/picture/PresetPictures.h"

namespace velum::gui {

namespace {

constexpr int kColumns = 3, kPictureHeight = 64;
constexpr int kPatienceMs = 4000;  // a view that is busy for longer does not keep the pictures away

/// Without the modality in front, which the group says already.
QString titleOf(const scene::Preset& preset, bool withModality) {
  QString text = QString::fromUtf8(preset.title.data(), int(preset.title.size()));
  int colon = text.indexOf(": ");
  if (colon < 0) return text;
  if (withModality) return text.replace(": ", " ");
  text = text.mid(colon + 2);
  return text.left(1).toUpper() + text.mid(1);
}

/// What the data seems to be where the file does not say.
Modality kindOf(const Volume& volume) {
  if (volume.modality != Modality::Unknown) return volume.modality;
  std::string_view fitting = scene::choosePreset(volume);
  for (const auto& preset : scene::presets())
    if (preset.name == fitting) return preset.modality;
  return Modality::Unknown;
}

}  // namespace

PresetGrid::PresetGrid(session::Document& document, QWidget* parent)
    : QWidget(parent),
      mDocument(document),
      mList(new PictureList(kColumns, kPictureHeight, this)),
      mMore(new QPushButton(tr("More"), this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  auto* header = new QHBoxLayout;
  header->addWidget(makeTitle(tr("Preset"), this), 1);
  header->addWidget(mMore);
  layout->addLayout(header);
  layout->addWidget(mList);
  mList->setObjectName("preset");
  mList->setAccessibleName(tr("Preset"));
  mList->setToolTip(tr("Colours, opacity and light made for a kind of data"));
  mMore->setObjectName("morePresets");
  mMore->setProperty("role", "quiet");
  mMore->setCheckable(true);
  mMore->setToolTip(tr("Presets made for other kinds of data"));
  mPatience.setSingleShot(true);
  mPatience.setInterval(kPatienceMs);
  connect(mList, &PictureList::chosen, this, &PresetGrid::choose);
  connect(&mPatience, &QTimer::timeout, this, &PresetGrid::drawPictures);
  connect(mMore, &QPushButton::toggled, this, [this](bool on) {
    mMore->setText(on ? tr("Fewer") : tr("More"));
    fill();
    refresh();
    drawPictures();
  });
  fill();
}

PresetGrid::~PresetGrid() { mJob.reset(); }

void PresetGrid::choose(const QString& name) { session::edit(mDocument, session::ChoosePreset{name.toStdString()}); }

/// The presets for this kind of data and the one that is chosen; where they are wanted, all others.
void PresetGrid::fill() {
  bool mixes = scene::mixesChannels(mDocument.scene().volume);
  Modality first = mixes ? Modality::Microscopy : mVolume ? kindOf(*mVolume) : Modality::Unknown;
  // A patient's scan of which nothing is known is an MR more often than anything else.
  bool isPatient = mVolume && hasPatientLetters(mDocument.scene());
  Modality second = first == Modality::Unknown && isPatient ? Modality::MR : first;
  std::string current = scene::currentTransfer(mDocument.scene().volume).preset;
  mList->clear();
  for (bool others : {false, true})
    for (const auto& preset : scene::presets()) {
      bool isFirst = preset.modality == first || preset.modality == second || preset.name == current;
      if (isFirst == others || (others && !mMore->isChecked())) continue;
      QString name = QString::fromUtf8(preset.name.data(), int(preset.name.size()));
      mList->add(name, titleOf(preset, preset.modality != first), titleOf(preset, true), mPictures.value(name));
    }
  mList->fit(width());
}

void PresetGrid::resizeEvent(QResizeEvent*) { mList->fit(width()); }

void PresetGrid::refresh() {
  const scene::VolumeLayer& layer = mDocument.scene().volume;
  setEnabled(bool(layer.data));
  int channel = layer.data ? scene::shownChannel(layer) : -1;
  if (!(mVolume == layer.data) || mChannel != channel) {
    if (mJob) mJob->cancel();
    mVolume = layer.data;
    mChannel = channel;
    mPictures.clear();
    fill();
    if (layer.data) mPatience.start();
  }
  QString current = QString::fromStdString(scene::currentTransfer(layer).preset);
  mList->mark(current);
}

QStringList PresetGrid::missing() const {
  QStringList names;
  for (const QString& name : mList->names())
    if (!mPictures.contains(name)) names << name;
  return names;
}

bool PresetGrid::isComplete() const { return !mVolume || (!mJob && missing().isEmpty()); }

void PresetGrid::drawPictures() {
  QStringList names = missing();
  if (mJob || !mVolume || names.isEmpty()) return;
  mPatience.stop();
  std::vector<std::string> wanted;
  for (const QString& name : names) wanted.push_back(name.toStdString());
  glm::ivec2 size(mList->pictureSize().width(), mList->pictureSize().height());
  auto key = std::make_pair(mVolume.id(), mChannel);
  auto work = [this, scene = mDocument.scene(), wanted, size, key](Progress& progress) {
    session::drawPresetPictures(
        scene, wanted, size,
        [&](const std::string& name, const Image& image) {
          callLater(this, [this, key, name = QString::fromStdString(name), picture = toQImage(image)] {
            if (key == std::make_pair(mVolume.id(), mChannel)) takePicture(name, picture);
          });
        },
        progress);
  };
  mJob = std::make_unique<Job>(work, nullptr);
  // Without a driver for pictures in the background the names alone must do: the error has no place in the window.
  connect(mJob.get(), &Job::finished, this, [this, key](bool done) {
    mJob.release()->deleteLater();
    if (done || key != std::make_pair(mVolume.id(), mChannel)) drawPictures();
  });
  mJob->start();
}

void PresetGrid::takePicture(const QString& name, const QImage& picture) {
  QPixmap pixmap = QPixmap::fromImage(picture);
  mPictures.insert(name, pixmap);
  mList->setPicture(name, pixmap);
}

}  // namespace velum::gui
