#include "gui/look/FinishPanel.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QVBoxLayout>
#include <exception>

#include "gui/kit/CoreWords.h"
#include "gui/service/EditField.h"
#include "scene/SurfaceLook.h"
#include "session/command/Command.h"
#include "session/command/LookCommands.h"
#include "session/document/PaperFile.h"

namespace velum::gui {

namespace {

/// Molecules are round all over: in a picture of a model alone no surface turns sharply.
bool hasCreases(const scene::Scene& scene) {
  bool hasVoxels = (scene.volume.data && scene.volume.visible) || (scene.labels.data && scene.labels.visible);
  return scene::hasData(scene) && (hasVoxels || !scene.model.data || !scene.model.visible);
}

}  // namespace

FinishPanel::FinishPanel(session::Document& document, QWidget* parent)
    : QWidget(parent),
      mDocument(document),
      mFinishes(new FinishGrid(document, this)),
      mSpheres(new LitSphereGrid(document, this)),
      mForm(document, this, "finish.") {
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

/// Lines lie on surfaces: when the look is a haze, the user is offered one of surfaces.
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
  const scene::Scene& scene = mDocument.shown();
  bool drawsLines = scene.finish.contours > 0 || scene.finish.hatching > 0;
  bool isLook = scene.volume.data && !scene.volume.data->isColor && scene.rayCast.mode == scene::RenderMode::Volume;
  mOffer->setVisible(drawsLines && isLook &&
                     scene::isTranslucent(scene::currentTransfer(scene.volume), mHistogram.of(scene.volume)));
}

/// A title, and a grid for the rows that follow.
void FinishPanel::addSection(const QString& title) {
  auto* column = static_cast<QVBoxLayout*>(layout());
  column->addWidget(makeLine(this));
  column->addWidget(makeTitle(title, this));
  QGridLayout* rows = makeFieldGrid(nullptr, 72);
  column->addLayout(rows);
  mForm.setGrid(rows);
}

void FinishPanel::addContours() {
  addSection(tr("Contours"));
  mForm.add("contours", tr("Strength"),
            {.object = "contours", .tip = tr("Lines around structures and along edges, %"), .name = tr("Contours")});
  mForm.add("contourWidth", tr("Width"),
            {.object = "contourWidth",
             .tip = tr("In pixels of a picture of 1000 rows; lines grow with the picture"),
             .name = tr("Width of contours")});
  mForm.add("contourSteps", tr("Outlines"),
            {.object = "contourSteps",
             .tip = tr("How much of them where something ends before what lies behind it, %"),
             .name = tr("Contours of outlines")});
  mForm.add("contourStructures", tr("Structures"),
            {.object = "contourStructures",
             .tip = tr("How much of them between labelled structures, %"),
             .name = tr("Contours between structures")});
  mForm.add("contourCreases", tr("Creases"),
            {.object = "contourCreases",
             .tip = tr("How much of them where the surface turns sharply, %; molecules of models have none"),
             .name = tr("Contours of creases"),
             .isEnabled = [this] { return hasCreases(mDocument.shown()); }});
  mForm.add("contourColor", tr("Ink"), {.object = "contourColor", .tip = tr("Colour of contours and strokes")});
}

void FinishPanel::addSpheres() {
  addSection(tr("Lit sphere"));
  mForm.add("litSphere", tr("Share"),
            {.object = "litSphereShare",
             .tip = tr("How much of the colour is the lit spheres' instead of the light's, %"),
             .name = tr("Share of lit spheres")});
  layout()->addWidget(mSpheres);
  layout()->addWidget(mForm.make(this, "structureSpheres", tr("Structures have their own"),
                                 {.object = "structureSpheres",
                                  .tip = tr("Off: structures have this one, too, whatever their menu says"),
                                  .step = tr("Lit spheres of structures")}));
}

void FinishPanel::addStrokes() {
  addSection(tr("Strokes"));
  mForm.add("hatching", tr("Strength"),
            {.object = "hatching",
             .tip = tr("Hatching round the form, broader where it is darker, %"),
             .name = tr("Strokes")});
  mForm.add("hatchWidth", tr("Distance"),
            {.object = "hatchWidth",
             .tip = tr("From stroke to stroke, in pixels of a picture of 1000 rows"),
             .name = tr("Distance of strokes")});
}

void FinishPanel::addPaper() {
  addSection(tr("Paper"));
  auto* paper = mForm.add(
      "paper", tr("Kind"),
      {.object = "paper",
       .tip = tr("What is behind the picture instead of the background"),
       .name = tr("Paper"),
       .step = tr("Choose paper"),
       .choices = {tr("None"), tr("Smooth"), tr("Rough"), tr("Laid"), tr("Canvas"), tr("Linen"), tr("Parchment")}});
  mPaper = static_cast<QComboBox*>(paper);
  mOwnPaper = new QPushButton(tr("Your own..."), this);
  mOwnPaper->setObjectName("ownPaper");
  mOwnPaper->setProperty("role", "quiet");
  mOwnPaper->setToolTip(tr("A picture of paper or cloth, .png, .tif or .exr, that is laid side by side without seams"));
  mForm.addWidget(mOwnPaper);
  connect(mOwnPaper, &QPushButton::clicked, this, &FinishPanel::askPaper);
  mForm.add("paperGrain", tr("Grain"),
            {.object = "paperGrain", .tip = tr("How much of its grain shows, %"), .name = tr("Grain of the paper")});
  mForm.add("paperScale", tr("Size"),
            {.object = "paperScale",
             .tip = tr("How large its grain or picture is, %"),
             .name = tr("Size of the grain"),
             .inPercent = true});
  mForm.add("paperColor", tr("Colour"),
            {.object = "paperColor",
             .tip = tr("Colour of the paper"),
             .name = tr("Colour of the paper"),
             .isEnabled = [this] { return mDocument.shown().finish.paper != scene::Paper::Own; }});
}

void FinishPanel::askPaper() {
  QString path = QFileDialog::getOpenFileName(this, tr("Choose paper"), {},
                                              tr("Pictures (*.png *.tif *.tiff *.exr);;All files (*)"));
  if (!path.isEmpty()) takePaper(path);
}

void FinishPanel::takePaper(const QString& path) {
  try {
    setField(mDocument, "finish.paper", path.toStdString(), "Choose paper");
  } catch (const std::exception& error) {
    emit failed(inWords(error.what()));
  }
}

/// The user's own paper is the last item of the list, named after its file.
void FinishPanel::listOwnPaper() {
  constexpr int kOwn = static_cast<int>(scene::Paper::Own);
  QString own = QFileInfo(QString::fromStdString(mDocument.shown().finish.ownPaper.source.path)).fileName();
  if (mPaper->itemText(kOwn) == own) return;
  mPaper->removeItem(kOwn);
  if (!own.isEmpty()) mPaper->addItem(own);
}

void FinishPanel::refresh() {
  mFinishes->refresh();
  refreshOffer();
  mSpheres->refresh();
  listOwnPaper();
  bool hasData = scene::hasData(mDocument.shown());
  mForm.setEnabled(hasData);
  mOwnPaper->setEnabled(hasData);
  mForm.refresh();
}

}  // namespace velum::gui
