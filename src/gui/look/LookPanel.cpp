#include "gui/look/LookPanel.h"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/kit/Words.h"
#include "session/command/Command.h"
#include "session/command/LookCommands.h"

namespace velum::gui {

namespace {

constexpr int kLabelWidth = 72;

/// Decimals that are needed to show a thousandth of a span.
int decimalsFor(double span) { return std::clamp(int(std::ceil(2.0 - std::log10(std::max(span, 1e-9)))), 0, 6); }

QVBoxLayout* makeSection(QWidget* section, const QString& title) {
  auto* layout = new QVBoxLayout(section);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(makeTitle(title, section));
  return layout;
}

}  // namespace

LookPanel::LookPanel(session::Document& document, QWidget* parent)
    : QWidget(parent),
      mDocument(document),
      mChannels(new ChannelList(document, this)),
      mPresets(new PresetGrid(document, this)),
      mEditor(new TransferEditor(document, this)),
      mForm(document, this) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(14);
  layout->addWidget(mChannels);
  layout->addWidget(mPresets);
  layout->addWidget(mEditor);
  layout->addWidget(makeLine(this));
  layout->addWidget(makeLook());
  layout->addWidget(makeLine(this));
  layout->addWidget(makeLight());
  layout->addWidget(makeLine(this));
  layout->addWidget(makeBackground());
}

QWidget* LookPanel::makeLook() {
  auto* section = new QWidget(this);
  QGridLayout* rows = makeFieldGrid(nullptr, kLabelWidth);
  makeSection(section, tr("Rendering"))->addLayout(rows);
  mForm.setGrid(rows);
  auto volume = [this]() -> const scene::VolumeLayer& { return mDocument.shown().volume; };
  mForm.add(
      "rayCast.mode", tr("Render"),
      {.object = "mode",
       .tip = tr("Volume: lit, with opacity. Maximum: the brightest value along each ray. Surface: one value"),
       .name = tr("Rendering"),
       .choices = {tr("Volume"), tr("Maximum (MIP)"), tr("Surface (iso)")},
       .isEnabled = [volume] { return bool(volume().data); },
       .call =
           [](const std::string& mode) { return session::ChooseMode{enumValue<scene::RenderMode>(mode).value()}; }});
  auto* iso = mForm.add(
      "rayCast.isoValue", tr("Value"),
      {.object = "iso",
       .tip = tr("Value at which the surface lies%1").arg(QString()),
       .name = tr("Value of the surface"),
       .step = tr("Change surface value"),
       .range =
           [volume] {
             return volume().data ? Range{volume().data->range.x, volume().data->range.y} : Range{0, 1};
           },
       .isShown = [this,
                   volume] { return volume().data && mDocument.shown().rayCast.mode == scene::RenderMode::Iso; }});
  mIso = static_cast<NumberRow*>(iso);
  mForm.add(
      "volume.smooth", tr("Smooth"),
      {.object = "smooth",
       .tip = tr("Cubic between voxels, not linear: no stairs where voxels are long. Takes more memory"),
       .step = tr("Change smoothing"),
       .isEnabled = [volume] { return volume().data && !volume().data->isColor && !scene::mixesChannels(volume()); }});
  return section;
}

QWidget* LookPanel::makeLight() {
  auto* section = new QWidget(this);
  QGridLayout* rows = makeFieldGrid(nullptr, kLabelWidth);
  makeSection(section, tr("Light"))->addLayout(rows);
  mForm.setGrid(rows);
  mForm.add("lighting.shadow", tr("Shadows"), {.tip = tr("Strength of the shadows that the key light casts, %")});
  mForm.add("lighting.occlusion", tr("Occlusion"),
            {.tip = tr("Darkening of hollows and grooves (ambient occlusion), %")});
  return section;
}

QWidget* LookPanel::makeBackground() {
  auto* section = new QWidget(this);
  auto* layout = makeSection(section, tr("Background"));
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(mForm.make(section, "background.top", tr("Top"), {.step = tr("Change background")}), 1);
  row->addWidget(mForm.make(section, "background.bottom", tr("Bottom"), {.step = tr("Change background")}), 1);
  struct Ready {
    QString name;
    glm::vec3 top, bottom;
  };
  const scene::Background studio;
  for (const Ready& ready :
       {Ready{tr("Studio"), studio.top, studio.bottom}, Ready{tr("White"), glm::vec3(1), glm::vec3(1)},
        Ready{tr("Black"), glm::vec3(0), glm::vec3(0)}}) {
    auto* button = new QPushButton(ready.name, section);
    button->setProperty("role", "quiet");
    button->setToolTip(tr("Background for %1").arg(ready.name == tr("White") ? tr("print") : inSentence(ready.name)));
    connect(button, &QPushButton::clicked, this, [this, ready] {
      session::edit(mDocument, session::SetBackground{ready.top, ready.bottom});
    });
    row->addWidget(button);
  }
  layout->addLayout(row);
  return section;
}

void LookPanel::showIso(const Volume& volume) {
  QString unit = QString::fromStdString(volume.unit);
  mIso->setDecimals(decimalsFor(volume.range.y - volume.range.x));
  mIso->setSuffix(unit.isEmpty() ? QString() : " " + unit);
  mIso->setToolTip(tr("Value at which the surface lies%1").arg(unit.isEmpty() ? QString() : ", " + unit));
}

void LookPanel::refresh() {
  mChannels->refresh();
  mPresets->refresh();
  mEditor->refresh();
  if (const auto& volume = mDocument.shown().volume.data) showIso(*volume);
  mForm.refresh();
}

}  // namespace velum::gui
