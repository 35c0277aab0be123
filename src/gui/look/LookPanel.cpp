#include "gui/look/LookPanel.h"
#include "session/command/Command.h"
#include "session/command/LookCommands.h"

#include <QGridLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace velum::gui {

namespace {

/// Decimals with which a thousandth of a span can be told.
int decimalsFor(double span) { return std::clamp(int(std::ceil(2.0 - std::log10(std::max(span, 1e-9)))), 0, 6); }

QVBoxLayout* makeSection(QWidget* section, const QString& title) {
  auto* layout = new QVBoxLayout(section);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(makeTitle(title, section));
  return layout;
}

QGridLayout* makeRows(QVBoxLayout* parent) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(8);
  grid->setColumnMinimumWidth(0, 72);
  grid->setColumnStretch(1, 1);
  parent->addLayout(grid);
  return grid;
}

}  // namespace

LookPanel::LookPanel(session::Document& document, QWidget* parent)
    : QWidget(parent),
      mDocument(document),
      mChannels(new ChannelList(document, this)),
      mPresets(new PresetGrid(document, this)),
      mEditor(new TransferEditor(document, this)) {
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
  QGridLayout* rows = makeRows(makeSection(section, tr("Rendering")));
  mMode = new QComboBox(section);
  mMode->setObjectName("mode");
  mMode->setAccessibleName(tr("Rendering"));
  mMode->addItems({tr("Volume"), tr("Maximum (MIP)"), tr("Surface (iso)")});
  mMode->setToolTip(tr("Volume: lit, with opacity. Maximum: the brightest value along each ray. Surface: one value"));
  mIso = new NumberRow(0, 1, 2, {}, section);
  mIso->setObjectName("iso");
  mIso->setName(tr("Value of the surface"));
  mIsoLabel = new QLabel(tr("Value"), section);
  rows->addWidget(new QLabel(tr("Render"), section), 0, 0);
  rows->addWidget(mMode, 0, 1);
  rows->addWidget(mIsoLabel, 1, 0);
  rows->addWidget(mIso, 1, 1);
  mSmooth = new QCheckBox(tr("Smooth"), section);
  mSmooth->setObjectName("smooth");
  mSmooth->setAccessibleName(tr("Smooth"));
  mSmooth->setToolTip(tr("Cubic between voxels, not linear: no stairs where voxels are long. Takes more memory"));
  rows->addWidget(mSmooth, 2, 1);
  connect(mSmooth, &QCheckBox::clicked, this, [this](bool on) {
    mDocument.edit("Change smoothing", [on](scene::Scene& scene) { scene.volume.smooth = on; });
  });
  connect(mMode, &QComboBox::activated, this, &LookPanel::chooseMode);
  connect(mIso, &NumberRow::changed, this, [this](double value) {
    mDocument.edit(
        "Change surface value", [&](scene::Scene& scene) { scene.rayCast.isoValue = value; }, true);
  });
  connect(mIso, &NumberRow::settled, this, [this] { mDocument.endMerge(); });
  return section;
}

QWidget* LookPanel::makeLight() {
  auto* section = new QWidget(this);
  QGridLayout* rows = makeRows(makeSection(section, tr("Light")));
  mShadow = new NumberRow(0, 100, 0, " %", section);
  mShadow->setToolTip(tr("Strength of the shadows that the key light casts, %"));
  mShadow->setName(tr("Shadows"));
  mOcclusion = new NumberRow(0, 100, 0, " %", section);
  mOcclusion->setName(tr("Occlusion"));
  mOcclusion->setToolTip(tr("Darkening of hollows and grooves (ambient occlusion), %"));
  rows->addWidget(new QLabel(tr("Shadows"), section), 0, 0);
  rows->addWidget(mShadow, 0, 1);
  rows->addWidget(new QLabel(tr("Occlusion"), section), 1, 0);
  rows->addWidget(mOcclusion, 1, 1);
  auto drive = [this](NumberRow* row, const char* label, double scene::Lighting::*field) {
    connect(row, &NumberRow::changed, this, [this, label, field](double value) {
      mDocument.edit(
          label, [&](scene::Scene& scene) { scene.lighting.*field = value / 100.0; }, true);
    });
    connect(row, &NumberRow::settled, this, [this] { mDocument.endMerge(); });
  };
  drive(mShadow, "Change shadows", &scene::Lighting::shadow);
  drive(mOcclusion, "Change occlusion", &scene::Lighting::occlusion);
  return section;
}

QWidget* LookPanel::makeBackground() {
  auto* section = new QWidget(this);
  auto* layout = makeSection(section, tr("Background"));
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  mTop = new ColorButton(tr("Top"), section);
  mTop->setText(tr("Top"));
  mBottom = new ColorButton(tr("Bottom"), section);
  mBottom->setText(tr("Bottom"));
  row->addWidget(mTop, 1);
  row->addWidget(mBottom, 1);
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
    button->setToolTip(tr("Background for %1").arg(ready.name == tr("White") ? tr("print") : ready.name.toLower()));
    connect(button, &QPushButton::clicked, this, [this, ready] { setBackground(ready.top, ready.bottom); });
    row->addWidget(button);
  }
  layout->addLayout(row);
  connect(mTop, &ColorButton::picked, this,
          [this](glm::vec3 color) { setBackground(color, mDocument.scene().background.bottom); });
  connect(mBottom, &ColorButton::picked, this,
          [this](glm::vec3 color) { setBackground(mDocument.scene().background.top, color); });
  return section;
}

void LookPanel::setBackground(glm::vec3 top, glm::vec3 bottom) {
  session::edit(mDocument, session::SetBackground{top, bottom});
}

void LookPanel::chooseMode(int index) {
  session::edit(mDocument, session::ChooseMode{static_cast<scene::RenderMode>(index)});
}

void LookPanel::refresh() {
  const scene::Scene& scene = mDocument.scene();
  const auto& volume = scene.volume.data;
  mChannels->refresh();
  mPresets->refresh();
  mEditor->refresh();
  mMode->setCurrentIndex(static_cast<int>(scene.rayCast.mode));
  mMode->setEnabled(bool(volume));
  mSmooth->setChecked(scene.volume.smooth);
  mSmooth->setEnabled(volume && !volume->isColor && !scene::mixesChannels(scene.volume));
  bool iso = scene.rayCast.mode == scene::RenderMode::Iso && volume;
  mIsoLabel->setVisible(iso);
  mIso->setVisible(iso);
  if (volume) {
    mIso->setDecimals(decimalsFor(volume->range.y - volume->range.x));
    mIso->setRange(volume->range.x, volume->range.y);
    mIso->setSuffix(volume->unit.empty() ? QString() : " " + QString::fromStdString(volume->unit));
    mIso->setToolTip(tr("Value at which the surface lies%1")
                         .arg(volume->unit.empty() ? QString() : ", " + QString::fromStdString(volume->unit)));
  }
  mIso->setValue(scene.rayCast.isoValue);
  mShadow->setValue(scene.lighting.shadow * 100.0);
  mOcclusion->setValue(scene.lighting.occlusion * 100.0);
  mTop->setColor(scene.background.top);
  mBottom->setColor(scene.background.bottom);
}

}  // namespace velum::gui
