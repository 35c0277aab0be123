#include "SavePictureDialog.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

namespace velum::gui {

namespace {

QSpinBox* makeSpin(QWidget* parent, int min, int max, int value, const QString& suffix, const QString& tip) {
  auto* spin = new QSpinBox(parent);
  spin->setRange(min, max);
  spin->setValue(value);
  spin->setSuffix(suffix);
  spin->setToolTip(tip);
  spin->setAlignment(Qt::AlignRight);
  spin->setMinimumWidth(110);
  return spin;
}

}  // namespace

SavePictureDialog::SavePictureDialog(glm::ivec2 viewSize, const scene::Scene& scene, QWidget* parent)
    : QDialog(parent) {
  setWindowTitle(tr("Save picture"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(20, 18, 20, 16);
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(10);
  mWidth = makeSpin(this, 1, 65536, viewSize.x, tr(" px"), tr("Width of the picture, pixels"));
  mHeight = makeSpin(this, 1, 65536, viewSize.y, tr(" px"), tr("Height of the picture, pixels"));
  mSamples = makeSpin(this, 1, 256, std::max(4, scene.rayCast.samplesPerPixel), {},
                      tr("Pictures that are averaged: more are smoother and take longer"));
  mTransparent = new QCheckBox(tr("Transparent background"), this);
  mTransparent->setToolTip(tr("No background, with an alpha channel: for layouts"));
  mTransparent->setChecked(scene.background.transparent);
  mLayers = new QCheckBox(tr("Layers: depth, normal, structure, position"), this);
  mLayers->setToolTip(tr("Inside an .exr file; as pictures beside a .png or .tif file"));
  auto* size = new QHBoxLayout;
  size->addWidget(mWidth);
  size->addWidget(new QLabel(QString::fromUtf8("\u00d7"), this));
  size->addWidget(mHeight);
  grid->addWidget(new QLabel(tr("Size"), this), 0, 0);
  grid->addLayout(size, 0, 1);
  auto* ready = new QHBoxLayout;
  auto addReady = [&](const QString& name, double factor) {
    auto* button = new QPushButton(name, this);
    button->setProperty("role", "quiet");
    button->setAutoDefault(false);
    button->setToolTip(tr("%1 times the size of the view").arg(factor));
    connect(button, &QPushButton::clicked, this, [this, viewSize, factor] {
      mWidth->setValue(int(viewSize.x * factor));
      mHeight->setValue(int(viewSize.y * factor));
    });
    ready->addWidget(button);
  };
  addReady(tr("As the view"), 1);
  addReady(tr("2 x"), 2);
  addReady(tr("4 x"), 4);
  ready->addStretch(1);
  grid->addLayout(ready, 1, 1);
  grid->addWidget(new QLabel(tr("Samples"), this), 2, 0);
  grid->addWidget(mSamples, 2, 1, Qt::AlignLeft);
  grid->addWidget(mTransparent, 3, 1);
  grid->addWidget(mLayers, 4, 1);
  auto* note = new QLabel(tr("PNG and EXR pictures carry the scene: open one to go on with it."), this);
  note->setProperty("role", "muted");
  grid->addWidget(note, 5, 0, 1, 2);
  auto* buttons = new QDialogButtonBox(this);
  auto* save = buttons->addButton(tr("Choose file..."), QDialogButtonBox::AcceptRole);
  save->setDefault(true);
  buttons->addButton(QDialogButtonBox::Cancel);
  grid->addWidget(buttons, 6, 0, 1, 2);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

session::PictureOptions SavePictureDialog::options() const {
  return {{mWidth->value(), mHeight->value()}, mSamples->value(), mTransparent->isChecked(), mLayers->isChecked()};
}

}  // namespace velum::gui
