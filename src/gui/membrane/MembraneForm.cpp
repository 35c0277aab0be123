#include "gui/membrane/MembraneForm.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QVBoxLayout>
#include <cmath>

#include "gui/kit/CoreWords.h"
#include "gui/kit/Length.h"
#include "gui/service/SelectedCut.h"
#include "session/command/Command.h"
#include "session/command/CutCommands.h"
#include "session/command/MembraneCommands.h"
#include "session/command/ModelCommands.h"
#include "session/command/StructureCommands.h"
#include "session/membrane/MembraneEdit.h"
#include "session/model/ModelEdit.h"
#include "session/structure/StructureEdit.h"

namespace velum::gui {

namespace {

constexpr int kLabelWidth = 62;

QPushButton* addButton(QHBoxLayout* row, const QString& name, const QString& text, const QString& tip) {
  auto* button = new QPushButton(text, row->parentWidget());
  button->setObjectName(name);
  button->setToolTip(tip);
  row->addWidget(button, 1);
  return button;
}

}  // namespace

MembraneForm::MembraneForm(session::Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent),
      mDocument(document),
      mSelection(selection),
      mShares(new ShareBar(this)),
      mFigure(new QLabel(this)),
      mDoing(new QLabel(this)),
      mStrength(new StrengthForm(document, selection, this)),
      mStructures(new StrengthTable(this)),
      mNoise(new NoiseForm(document, selection, this)),
      mSketch(new SketchForm(this)),
      mForm(document, this, "cuts.N.membrane.", [this] {
        const scene::Cut* cut = selectedMembrane(mDocument, mSelection);
        return cut ? scene::cutPlace(mDocument.shown(), cut->id) : -1;
      }) {
  mForm.setSteps(tr("Change membrane: %1"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(makeLine(this));
  mFigure->setObjectName("membraneFigure");
  mFigure->setWordWrap(true);
  mFigure->setToolTip(
      tr("Of the pairs of neighbouring protected voxels that the plane separates: those that the sheet leaves "
         "together on the side that stays, those that go together, and as many as the sheet cuts."));
  mDoing->setProperty("role", "muted");
  mDoing->setWordWrap(true);
  layout->addWidget(mStrength);
  layout->addWidget(mNoise);
  layout->addWidget(mStructures);
  layout->addWidget(makeProtect());
  layout->addWidget(mSketch);
  mHands = new SheetHandsForm(document, selection, this);
  layout->addWidget(mHands);
  layout->addWidget(makePlayer());  // over what changes while it plays
  layout->addWidget(mShares);
  layout->addWidget(mFigure);
  layout->addWidget(mDoing);
  auto* picture = new QWidget(this);
  mForm.setGrid(makeFieldGrid(picture, kLabelWidth));
  addPicture();
  layout->addWidget(picture);
  layout->addWidget(makeLast());
  auto* cloth = new QWidget(this);
  mForm.setGrid(makeFieldGrid(cloth, kLabelWidth));
  addCloth();
  cloth->hide();
  layout->addWidget(cloth);
  connect(mMore, &QPushButton::toggled, cloth, &QWidget::setVisible);
  connect(mStructures, &StrengthTable::strengthAsked, this, &MembraneForm::setForceOf);
}

void MembraneForm::setForceOf(const session::Protectable& what, double strength) {
  if (!selectedMembrane(mDocument, mSelection)) return;
  const scene::Scene& scene = mDocument.shown();
  const char* verb = strength != 0 ? "Force of" : "No force of";
  std::string cut = session::cutKey(scene, mSelection.cut());
  if (what.structure)
    session::edit(mDocument,
                  session::ProtectStructures{session::structureNames(scene, {what.structure}), strength, cut}, false,
                  session::structureLabel(scene, verb, {what.structure}));
  else
    session::edit(mDocument, session::ProtectTypes{{what.type}, strength, cut}, false,
                  session::typesLabel(scene, verb, session::typeNumbers(scene, {what.type})));
}

QWidget* MembraneForm::makeProtect() {
  auto* tools = new QWidget(this);
  auto* row = new QHBoxLayout(tools);
  row->setContentsMargins(0, 0, 0, 0);
  mProtect =
      addButton(row, "protectThis", tr("Protect this"),
                tr("Click tissue, a structure or a molecule in any view: the sheet goes around all that is like it"));
  mLetThrough =
      addButton(row, "letThrough", tr("Let through"),
                tr("Click tissue, a structure or a molecule in any view: the sheet may cut all that is like it"));
  return tools;
}

QWidget* MembraneForm::makePlayer() {
  auto* tools = new QWidget(this);
  auto* row = new QHBoxLayout(tools);
  row->setContentsMargins(0, 0, 0, 0);
  mPlay = addButton(row, "membranePlay", tr("Hold"), tr("Let the sheets of all membranes move, or hold them"));
  mStep = addButton(row, "membraneStep", tr("Step"), tr("Hold the sheets and let them go five steps"));
  auto* flat = addButton(row, "membraneFlat", tr("Flat"), tr("Hang the sheet flat again and let it go anew"));
  mPlay->setCheckable(true);
  connect(mPlay, &QPushButton::clicked, this, [this](bool pause) { emit playAsked(!pause); });
  connect(mStep, &QPushButton::clicked, this, &MembraneForm::stepAsked);
  connect(flat, &QPushButton::clicked, this, &MembraneForm::flatAsked);
  return tools;
}

/// The last part of the form: widgets that show the numbers, and buttons that write files.
QWidget* MembraneForm::makeLast() {
  auto* tools = new QWidget(this);
  auto* row = new QHBoxLayout(tools);
  row->setContentsMargins(0, 0, 0, 0);
  mMore = addButton(row, "membraneMore", tr("Advanced"), tr("Show the numbers of the cloth and of the forces"));
  mMore->setProperty("role", "quiet");
  mMore->setCheckable(true);
  auto* files =
      addButton(row, "membraneExport", tr("Export"), tr("Write the sheet, or what it leaves, for other programs"));
  files->setProperty("role", "quiet");
  auto* menu = new QMenu(files);
  menu->setToolTipsVisible(true);
  menu->addAction(tr("Sheet as a surface..."), this, &MembraneForm::exportSheetAsked)
      ->setToolTip(tr("The sheet as a surface, for other programs"));
  menu->addAction(tr("Clipped volume..."), this, &MembraneForm::exportClippedAsked)
      ->setToolTip(tr("A volume for other programs: what the cuts take away is empty"));
  files->setMenu(menu);
  return tools;
}

void MembraneForm::addPicture() {
  auto isInlay = [this] { return mShown.membrane->use == scene::MembraneUse::Inlay; };
  auto reach = [this] { return Range{0.0, 2.0 * mShown.size.z}; };
  mForm.add("use", tr("Use"),
            {.object = "membraneUse",
             .tip = tr("Clip: takes away what lies before the sheet; inlay: a grey image, and what lies between it "
                       "and the sheet"),
             .choices = {tr("Clip"), tr("Inlay")}});
  mForm.add("inlayOpacity", tr("Inlay opacity"), {.isShown = isInlay});
  mForm.add("emphasis", tr("Emphasis"), {.isShown = isInlay});
  mForm.add("falloff", tr("Fade"), {.range = reach, .isShown = isInlay});
  mForm.add("look", tr("Sheet"), {.object = "membraneLook", .choices = {tr("Hidden"), tr("Grid"), tr("Surface")}});
}

/// Adds the values of the cloth. Values that do not decide where a sheet rests by its rule are hidden.
void MembraneForm::addCloth() {
  auto isSided = [this] { return mShown.membrane->field.rule == scene::KernelRule::Sided; };
  auto isPaper = [isSided] { return !isSided(); };
  auto choose = [this](const std::string& rule) {
    return session::ChooseRule{enumValue<scene::KernelRule>(rule).value(),
                               session::cutKey(mDocument.shown(), mSelection.cut())};
  };
  mForm.add("repositioning", tr("Moving"),
            {.object = "membraneMoving",
             .tip = tr("Passive: the sheet starts anew from flat wherever its rest plane is put; active: the frame "
                       "drags it along, and it stays behind on what holds it"),
             .choices = {tr("Passive"), tr("Active")}});
  mForm.add("field.rule", tr("Rule"),
            {.object = "membraneRule",
             .tip = tr("Sided: the least cut says to which side a structure belongs, and it pushes the sheet to the "
                       "other; paper: away from each kernel's middle"),
             .choices = {tr("Sided"), tr("Paper")},
             .call = choose});
  mForm.add("field.side", tr("Passed by"),
            {.object = "membraneSide",
             .tip = tr("What the section would cut and the sheet can pass by: keep it whole, remove it whole, or leave "
                       "it on the side on which more of it lies"),
             .choices = {tr("Keep"), tr("Remove"), tr("Nearest side")},
             .isShown = isSided});
  mForm.add("field.level", tr("Kernels"),
            {.object = "membraneLevel",
             .tip = tr("A kernel for so many times two voxels along each axis: 0 every voxel, 1 every second, 2 every "
                       "fourth"),
             .isShown = isPaper});
  mForm.add("field.areaOfEffect", tr("Area of effect"),
            {.object = "membraneArea", .tip = tr("Half-width of a kernel, in kernels"), .isShown = isPaper});
  mForm.add("cloth.stretch", tr("Stiff"), {.object = "membraneStretch", .inPercent = false});
  mForm.add("cloth.bend", tr("Bending"), {.object = "membraneBend", .inPercent = false, .isShown = isPaper});
  mForm.add("cloth.restoring", tr("Pull back"), {.object = "membraneRestoring"});
  mForm.add("cloth.particles", tr("Particles"), {.object = "membraneParticles", .isShown = isPaper});
  mForm.add("cloth.finest", tr("Finest"), {.object = "membraneFinest", .isShown = isSided});
}

void MembraneForm::showCut(const scene::Cut& cut) {
  mShown = cut;
  const scene::Membrane& m = *cut.membrane;
  mStrength->showField(m.field);
  mHands->showCut(cut);
  mNoise->showField(m.field);
  mStructures->showRows(session::protectables(mDocument.shown(), m.field));
  mSketch->showLength(Length(mDocument.shown()));
  mSketch->showStrokes(m.field.strokes);
  mForm.refresh();
}

QString MembraneForm::figureText(const session::MembraneStatus& status, const Length& length) {
  if (!status.isMeasured) return {};
  if (status.planePairs == 0)
    return tr("The plane cuts nothing of what is protected; the sheet cuts %1 pairs of voxels.").arg(status.sheetPairs);
  auto percent = [](double share) {
    return QLocale().toString(100.0 * share, 'f', share > 0 && share < 0.0995 ? 1 : 0);
  };
  return tr("Of what the plane would cut, %1 % stays whole, %2 % is removed whole, %3 % is cut. The sheet "
            "lies %4 from the "
            "rest plane on average.")
      .arg(percent(status.shares.kept), percent(status.shares.removed), percent(status.shares.cut),
           length.text(status.meanDistance));
}

void MembraneForm::showStatus(const std::optional<session::MembraneStatus>& status, bool isPlaying) {
  using Phase = session::MembraneStatus::Phase;
  mPlay->setChecked(!isPlaying);
  mPlay->setText(isPlaying ? tr("Hold") : tr("Let move"));
  if (!status) return;
  // The old figure stays until there is a new one, so that the panel does not jump.
  if (QString text = figureText(*status, Length(mDocument.shown())); !text.isEmpty()) mFigure->setText(text);
  mFigure->setEnabled(status->isMeasured);
  mShares->setEnabled(status->isMeasured);
  if (status->isMeasured) {
    mNoise->showLeftOut(status->leftOut, status->voxels.volume, Length(mDocument.shown()));
    mShares->setShares(status->shares);
  }
  QString kernels = tr("%1 kernels, %2 \u00d7 %3 particles")
                        .arg(QLocale().toString(qulonglong(status->kernels)))
                        .arg(status->particles.x)
                        .arg(status->particles.y);
  QString doing = status->phase == Phase::Resting     ? tr("At rest")
                  : status->phase == Phase::Computing ? tr("Computing forces")
                  : status->phase == Phase::Paused    ? tr("Paused at step %1").arg(status->steps)
                                                      : tr("Settling, step %1").arg(status->steps);
  mDoing->setText(status->error.empty() ? doing + "." : inWords(status->error));
  const auto& volume = mDocument.shown().volume.data;
  if (volume && volume->finer)
    kernels += "\n" + tr("Forces and figures come from level %1 (0 is the finest)").arg(status->voxels.level);
  mDoing->setToolTip(kernels + "\n" +
                     tr("Forces took %1 ms, a step takes %L2 ms; largest speed %L3 %4/s")
                         .arg(status->forcesMs, 0, 'f', 0)
                         .arg(status->stepMs, 0, 'f', 1)
                         .arg(status->speed, 0, 'g', 3)
                         .arg(Length(mDocument.shown()).sceneUnit()));
}

}  // namespace velum::gui
