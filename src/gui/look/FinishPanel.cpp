#include "gui/look/FinishPanel.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QVBoxLayout>
#include <exception>

#include "scene/SurfaceLook.h"
#include "session/command/Command.h"
#include "session/command/LookCommands.h"
#include "session/document/PaperFile.h"

namespace velum::gui {

FinishPanel::FinishPanel(session::Document& document, QWidget* parent)
    : QWidget(parent),
      mDocument(document),
      mFinishes(new FinishGrid(document, this)),
      mSpheres(new LitSphereGrid(document, this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(14);
  layout->addWidget(makeTitle(tr("Finish"), this));
  layout->addWidget(mFinishes);
  addOffer();
  addContours();
  addSpheres();
  addStrokes();
  addPaper();
}

/// Lines lie on surfaces: who chooses a finish for a haze is offered one.
void FinishPanel::addOffer() {
  mOffer = new QWidget(this);
  auto* column = new QVBoxLayout(mOffer);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  auto* text = new QLabel(tr("The look lets one see through, and lines lie on all that is seen."), mOffer);
  text->setProperty("role", "muted");
  text->setWordWrap(true);
  column->addWidget(text);
  auto* button = new QPushButton(tr("Make it a surface"), mOffer);
  button->setObjectName("makeSurface");
  button->setProperty("role", "quiet");
  button->setToolTip(tr("Opacities become steep: what is nearly opaque is opaque, veils before it go; colours stay"));
  column->addWidget(button, 0, Qt::AlignLeft);
  layout()->addWidget(mOffer);
  mOffer->hide();
  connect(button, &QPushButton::clicked, this, [this] { session::edit(mDocument, session::MakeSurface{}); });
}

void FinishPanel::refreshOffer() {
  const scene::Scene& scene = mDocument.scene();
  bool drawsLines = scene.finish.contours > 0 || scene.finish.hatching > 0;
  bool isLook = scene.volume.data && !scene.volume.data->isColor && scene.rayCast.mode == scene::RenderMode::Volume;
  mOffer->setVisible(drawsLines && isLook &&
                     scene::isTranslucent(scene::currentTransfer(scene.volume), mHistogram.of(scene.volume)));
}

QGridLayout* FinishPanel::addSection(const QString& title) {
  auto* column = static_cast<QVBoxLayout*>(layout());
  column->addWidget(makeLine(this));
  column->addWidget(makeTitle(title, this));
  auto* rows = new QGridLayout;
  rows->setHorizontalSpacing(10);
  rows->setVerticalSpacing(8);
  rows->setColumnMinimumWidth(0, 72);
  rows->setColumnStretch(1, 1);
  column->addLayout(rows);
  return rows;
}

void FinishPanel::addSlider(QGridLayout* rows, const SliderText& text, double scene::Finish::*field, double min,
                            double max, double unit, const QString& suffix) {
  auto* row = new NumberRow(min, max, unit < 1.0 ? 0 : 1, suffix, this);
  row->setObjectName(text.object);
  row->setName(text.name);
  row->setToolTip(text.tip);
  int at = rows->rowCount();
  rows->addWidget(new QLabel(text.title, this), at, 0);
  rows->addWidget(row, at, 1);
  connect(row, &NumberRow::changed, this, [this, field, unit, step = text.step](double value) {
    mDocument.edit(
        step, [&](scene::Scene& scene) { scene.finish.*field = value * unit; }, true);
  });
  connect(row, &NumberRow::settled, this, [this] { mDocument.endMerge(); });
  mSliders.push_back({row, field, unit});
}

void FinishPanel::addShare(QGridLayout* rows, const SliderText& text, double scene::Finish::*field) {
  addSlider(rows, text, field, 0, 100, 0.01, " %");
}

ColorButton* FinishPanel::makeColor(const char* object, const QString& title, const QString& tip, const char* step,
                                    glm::vec3 scene::Finish::*field) {
  auto* button = new ColorButton(title, this);
  button->setObjectName(object);
  button->setText(title);
  button->setToolTip(tip);
  connect(button, &ColorButton::picked, this, [this, step, field](glm::vec3 color) {
    mDocument.edit(step, [&](scene::Scene& scene) { scene.finish.*field = color; });
  });
  return button;
}

void FinishPanel::addContours() {
  QGridLayout* rows = addSection(tr("Contours"));
  addShare(
      rows,
      {"contours", tr("Strength"), tr("Contours"), tr("Lines around structures and along edges, %"), "Change contours"},
      &scene::Finish::contours);
  addSlider(rows,
            {"contourWidth", tr("Width"), tr("Width of contours"),
             tr("In pixels of a picture of 1000 rows; lines grow with the picture"), "Change width of contours"},
            &scene::Finish::contourWidth, 0.5, 10, 1.0, tr(" px"));
  addShare(rows,
           {"contourSteps", tr("Outlines"), tr("Contours of outlines"),
            tr("How much of them where something ends before what lies behind it, %"), "Change outlines"},
           &scene::Finish::contourSteps);
  addShare(rows,
           {"contourStructures", tr("Structures"), tr("Contours between structures"),
            tr("How much of them between labelled structures, %"), "Change contours between structures"},
           &scene::Finish::contourStructures);
  addShare(rows,
           {"contourCreases", tr("Creases"), tr("Contours of creases"),
            tr("How much of them where the surface turns sharply, %"), "Change creases"},
           &scene::Finish::contourCreases);
  mInk = makeColor("contourColor", tr("Ink"), tr("Colour of contours and strokes"), "Change ink",
                   &scene::Finish::contourColor);
  rows->addWidget(mInk, rows->rowCount(), 1);
}

void FinishPanel::addSpheres() {
  QGridLayout* rows = addSection(tr("Lit sphere"));
  addShare(rows,
           {"litSphereShare", tr("Share"), tr("Share of the lit spheres"),
            tr("How much of the colour is the lit spheres' instead of the light's, %"), "Change share of lit spheres"},
           &scene::Finish::litSphere);
  auto* column = static_cast<QVBoxLayout*>(layout());
  column->addWidget(mSpheres);
  mOwnSpheres = new QCheckBox(tr("Structures have their own"), this);
  mOwnSpheres->setObjectName("structureSpheres");
  mOwnSpheres->setToolTip(tr("Off: structures have this one, too, whatever their menu says"));
  column->addWidget(mOwnSpheres);
  connect(mOwnSpheres, &QCheckBox::clicked, this, [this](bool on) {
    mDocument.edit("Lit spheres of structures", [&](scene::Scene& scene) { scene.finish.structureSpheres = on; });
  });
}

void FinishPanel::addStrokes() {
  QGridLayout* rows = addSection(tr("Strokes"));
  addShare(rows,
           {"hatching", tr("Strength"), tr("Strokes"), tr("Hatching round the form, broader where it is darker, %"),
            "Change strokes"},
           &scene::Finish::hatching);
  addSlider(rows,
            {"hatchWidth", tr("Distance"), tr("Distance of strokes"),
             tr("From stroke to stroke, in pixels of a picture of 1000 rows"), "Change distance of strokes"},
            &scene::Finish::hatchWidth, 2, 30, 1.0, tr(" px"));
}

void FinishPanel::addPaper() {
  QGridLayout* rows = addSection(tr("Paper"));
  mPaper = new QComboBox(this);
  mPaper->setObjectName("paper");
  mPaper->setAccessibleName(tr("Paper"));
  mPaper->setToolTip(tr("What is behind the picture instead of the background"));
  mPaper->addItems({tr("None"), tr("Smooth"), tr("Rough"), tr("Laid"), tr("Canvas"), tr("Linen"), tr("Parchment")});
  int at = rows->rowCount();
  rows->addWidget(new QLabel(tr("Kind"), this), at, 0);
  rows->addWidget(mPaper, at, 1);
  connect(mPaper, &QComboBox::activated, this, [this](int index) {
    mDocument.edit("Choose paper", [&](scene::Scene& scene) { scene.finish.paper = static_cast<scene::Paper>(index); });
  });
  mOwnPaper = new QPushButton(tr("Your own..."), this);
  mOwnPaper->setObjectName("ownPaper");
  mOwnPaper->setProperty("role", "quiet");
  mOwnPaper->setToolTip(tr("A picture of paper or cloth, .png, .tif or .exr, that is laid side by side without seams"));
  rows->addWidget(mOwnPaper, at + 1, 1, Qt::AlignLeft);
  connect(mOwnPaper, &QPushButton::clicked, this, &FinishPanel::askPaper);
  addShare(rows,
           {"paperGrain", tr("Grain"), tr("Grain of the paper"), tr("How much of its grain shows, %"), "Change grain"},
           &scene::Finish::paperGrain);
  addSlider(rows,
            {"paperScale", tr("Size"), tr("Size of the grain"), tr("How large its grain or picture is, %"),
             "Change size of grain"},
            &scene::Finish::paperScale, 10, 1000, 0.01, " %");
  mPaperColor = makeColor("paperColor", tr("Colour"), tr("Colour of the paper"), "Change paper's colour",
                          &scene::Finish::paperColor);
  rows->addWidget(mPaperColor, rows->rowCount(), 1);
}

void FinishPanel::askPaper() {
  QString path = QFileDialog::getOpenFileName(this, tr("Choose paper"), {},
                                              tr("Pictures (*.png *.tif *.tiff *.exr);;All files (*)"));
  if (!path.isEmpty()) takePaper(path);
}

void FinishPanel::takePaper(const QString& path) {
  try {
    mDocument.edit("Choose paper", [&](scene::Scene& scene) { session::takePaper(scene, path.toStdString()); });
  } catch (const std::exception& error) {
    emit failed(QString::fromUtf8(error.what()));
  }
}

/// The user's own is the last one of the list, by the name of its file.
void FinishPanel::showPaper(const scene::Finish& finish) {
  constexpr int kOwn = static_cast<int>(scene::Paper::Own);
  QString own = QFileInfo(QString::fromStdString(finish.ownPaper.source.path)).fileName();
  if (mPaper->itemText(kOwn) != own) {
    mPaper->removeItem(kOwn);
    if (!own.isEmpty()) mPaper->addItem(own);
  }
  mPaper->setCurrentIndex(static_cast<int>(finish.paper));
  mPaperColor->setColor(finish.paperColor);
  mPaperColor->setEnabled(finish.paper != scene::Paper::Own);
}

void FinishPanel::refresh() {
  const scene::Scene& scene = mDocument.scene();
  mFinishes->refresh();
  refreshOffer();
  mSpheres->refresh();
  bool hasData = scene::hasData(scene);
  for (const Slider& slider : mSliders) {
    slider.row->setEnabled(hasData);
    slider.row->setValue(scene.finish.*slider.field / slider.unit);
  }
  mPaper->setEnabled(hasData);
  mOwnPaper->setEnabled(hasData);
  mOwnSpheres->setEnabled(hasData);
  mOwnSpheres->setChecked(scene.finish.structureSpheres);
  mInk->setColor(scene.finish.contourColor);
  showPaper(scene.finish);
}

}  // namespace velum::gui
