#include "gui/look/PresetGrid.h"

#include "gui/kit/Length.h"
#include "gui/kit/Widgets.h"
#include "gui/kit/Words.h"
#include "scene/Presets.h"
#include "scene/Shown.h"
#include "session/command/Command.h"
#include "session/command/LookCommands.h"
#include "session/picture/PresetPictures.h"

namespace velum::gui {

namespace {

/// A preset's title, without the modality in front of it where the group tells the modality already.
QString titleOf(const scene::Preset& preset, bool withModality) {
  QString text = wordsOf(preset.title);
  int colon = text.indexOf(": ");
  if (colon < 0) return text;
  if (withModality) return text.replace(": ", " ");
  text = text.mid(colon + 2);
  return text.left(1).toUpper() + text.mid(1);
}

/// The modality of a volume, or, where the file does not tell it, what the data seems to be.
Modality kindOf(const Volume& volume) {
  if (volume.modality != Modality::Unknown) return volume.modality;
  std::string_view fitting = scene::choosePreset(volume);
  for (const auto& preset : scene::presets())
    if (preset.name == fitting) return preset.modality;
  return Modality::Unknown;
}

}  // namespace

PresetGrid::PresetGrid(session::Document& document, QWidget* parent)
    : PictureGrid(document, {.pictureHeight = 64, .draw = session::drawPresetPictures, .patienceMs = 4000}, parent),
      mMore(new QPushButton(tr("More"), this)) {
  column().setSpacing(4);
  auto* header = new QHBoxLayout;
  header->addWidget(makeTitle(tr("Preset"), this), 1);
  header->addWidget(mMore);
  column().insertLayout(0, header);
  list().setObjectName("preset");
  list().setAccessibleName(tr("Preset"));
  list().setToolTip(tr("Colours, opacity and light made for a kind of data"));
  mMore->setObjectName("morePresets");
  mMore->setProperty("role", "quiet");
  mMore->setCheckable(true);
  mMore->setToolTip(tr("Presets made for other kinds of data"));
  connect(&list(), &PictureList::chosen, this, &PresetGrid::choose);
  connect(mMore, &QPushButton::toggled, this, [this](bool on) {
    mMore->setText(on ? tr("Fewer") : tr("More"));
    fill();
    refresh();
    drawPictures();
  });
  fill();
}

void PresetGrid::choose(const QString& name) { session::edit(document(), session::ChoosePreset{name.toStdString()}); }

/// Lists the presets for this kind of data and the preset that is chosen; with "More" all others, too.
void PresetGrid::fill() {
  bool mixes = scene::mixesChannels(document().shown().volume);
  Modality first = mixes ? Modality::Microscopy : mVolume ? kindOf(*mVolume) : Modality::Unknown;
  // A patient's scan of which nothing is known is an MR more often than anything else.
  bool isPatient = mVolume && hasPatientLetters(document().shown());
  Modality second = first == Modality::Unknown && isPatient ? Modality::MR : first;
  std::string current = scene::currentTransfer(document().shown().volume).preset;
  list().clear();
  for (bool others : {false, true})
    for (const auto& preset : scene::presets()) {
      bool isFirst = preset.modality == first || preset.modality == second || preset.name == current;
      if (isFirst == others || (others && !mMore->isChecked())) continue;
      QString name = textOf(preset.name);
      list().add(name, titleOf(preset, preset.modality != first), titleOf(preset, true), picture(name));
    }
  list().fit(width());
}

void PresetGrid::refresh() {
  const scene::VolumeLayer& layer = document().shown().volume;
  setEnabled(bool(layer.data));
  int channel = layer.data ? scene::shownChannel(layer) : -1;
  if (!(mVolume == layer.data) || mChannel != channel) {
    mVolume = layer.data;
    mChannel = channel;
    renew(bool(mVolume));
    fill();
  }
  list().mark(QString::fromStdString(scene::currentTransfer(layer).preset));
}

}  // namespace velum::gui
