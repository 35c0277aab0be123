#include "gui/membrane/MembraneForm.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/kit/Length.h"
#include "gui/service/Job.h"
#include "gui/service/SelectedCut.h"
#include "session/membrane/MembraneEdit.h"
#include "session/model/ModelEdit.h"
#include "session/structure/StructureEdit.h"

namespace velum::gui {

namespace {

QGridLayout* makeGrid(QWidget* parent) {
  auto* grid = new QGridLayout(parent);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(8);
  grid->setColumnMinimumWidth(0, 62);
  grid->setColumnStretch(1, 1);
  return grid;
}

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
      mCanvas(new StrengthCanvas(this)),
      mStructures(new StrengthTable(this)),
      mNoise(new NoiseForm(document, selection, this)),
      mSketch(new SketchForm(this)) {
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
  layout->addWidget(makeFieldHead());
  layout->addWidget(mCanvas);
  mCanvas->setObjectName("strengthCanvas");
  mCanvas->setAccessibleName(tr("Force by value: above the line what the sheet protects"));
  mCanvas->setToolTip(tr(
      "Force of each value, -1000 to 1000. Above the line: the sheet goes around it, and where it must cut it cuts "
      "what "
      "is weaker; below: the sheet is drawn to it, to what is stronger from farther away.\n"
      "Click: add a point. Drag: move it. Right click or Del: remove it.\nKeys: PgUp and PgDn go from one to the next, "
      "arrows move, Ins adds."));
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
  makePicture(makeGrid(picture));
  layout->addWidget(picture);
  layout->addWidget(makeLast());
  mCloth = new QWidget(this);
  makeCloth(makeGrid(mCloth));
  mCloth->hide();
  layout->addWidget(mCloth);
  connect(mMore, &QPushButton::toggled, mCloth, &QWidget::setVisible);
  connect(mStructures, &StrengthTable::strengthAsked, this, [this](int id, double strength) {
    const scene::Scene& scene = mDocument.scene();
    const char* verb = strength != 0 ? "Force of" : "No force of";
    std::string label = session::protectsTypes(scene) ? session::typesLabel(scene, verb, {std::uint32_t(id - 1)})
                                                      : session::structureLabel(scene, verb, {id});
    edit(QString::fromStdString(label), [&](scene::Membrane& m) { session::protectStructure(m, id, strength); });
  });
  connect(mCanvas, &StrengthCanvas::settled, this, [this] { mDocument.endMerge(); });
  connect(mCanvas, &StrengthCanvas::edited, this, [this](const QString& label, const StrengthCurve& next, bool merge) {
    bool gradient = byGradient();
    edit(
        label, [&](scene::Membrane& m) { (gradient ? m.field.byGradient : m.field.byValue) = next; }, merge);
  });
}

MembraneForm::~MembraneForm() { mJob.reset(); }

void MembraneForm::edit(const QString& label, const Change& change, bool merge) {
  editSelectedMembrane(mDocument, mSelection, label.toStdString(), change, merge);
}

QWidget* MembraneForm::makeFieldHead() {
  auto* head = new QWidget(this);
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(0, 0, 0, 0);
  mFieldTitle = makeTitle(tr("Protect"), head);
  mFieldTitle->setObjectName("protectTitle");
  row->addWidget(mFieldTitle, 1);
  mAttribute = new QComboBox(head);
  mAttribute->setObjectName("strengthBy");
  mAttribute->addItems({tr("By value"), tr("By gradient")});
  mAttribute->setAccessibleName(tr("Force by"));
  mAttribute->setToolTip(tr("Which property of the data the curve is over; forces of both add up"));
  row->addWidget(mAttribute);
  connect(mAttribute, &QComboBox::activated, this, [this] { showCurve(); });
  return head;
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

/// What shows the numbers, and what writes files.
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

NumberRow* MembraneForm::addNumber(QGridLayout* grid, const QString& name, const QString& tip, double min, double max,
                                   int decimals, const QString& suffix,
                                   std::function<void(scene::Membrane&, double)> set) {
  auto* row = new NumberRow(min, max, decimals, suffix, grid->parentWidget());
  row->setToolTip(tip);
  row->setName(name);
  int line = grid->rowCount();
  grid->addWidget(new QLabel(name, grid->parentWidget()), line, 0);
  grid->addWidget(row, line, 1);
  connect(row, &NumberRow::changed, this, [this, name, set = std::move(set)](double value) {
    edit(
        tr("Change membrane: %1").arg(name.toLower()), [&](scene::Membrane& m) { set(m, value); }, true);
  });
  connect(row, &NumberRow::settled, this, [this] { mDocument.endMerge(); });
  return row;
}

QComboBox* MembraneForm::addChoice(QGridLayout* grid, const QString& name, const QString& tip, const QStringList& items,
                                   std::function<void(scene::Membrane&, int)> set) {
  auto* box = new QComboBox(grid->parentWidget());
  box->addItems(items);
  box->setToolTip(tip);
  box->setAccessibleName(name);
  int line = grid->rowCount();
  grid->addWidget(new QLabel(name, grid->parentWidget()), line, 0);
  grid->addWidget(box, line, 1);
  connect(box, &QComboBox::activated, this, [this, name, set = std::move(set)](int index) {
    edit(tr("Change membrane: %1").arg(name.toLower()), [&](scene::Membrane& m) { set(m, index); });
  });
  return box;
}

void MembraneForm::addLastRow(const QGridLayout* grid, Rows& rows) {
  int line = grid->rowCount() - 1;
  rows.emplace_back(grid->itemAtPosition(line, 0)->widget(), grid->itemAtPosition(line, 1)->widget());
}

void MembraneForm::makePicture(QGridLayout* grid) {
  mUse = addChoice(grid, tr("Use"),
                   tr("Clip: takes away what lies before the sheet; inlay: a grey image, and what lies "
                      "between it and the sheet"),
                   {tr("Clip"), tr("Inlay")}, [](auto& m, int i) { m.use = static_cast<scene::MembraneUse>(i); });
  mUse->setObjectName("membraneUse");
  mInlayOpacity = addNumber(grid, tr("Inlay opacity"), tr("Opacity of the inlay's image, %"), 0, 100, 0, " %",
                            [](auto& m, double v) { m.inlayOpacity = v / 100.0; });
  addLastRow(grid, mInlayRows);
  mEmphasis =
      addNumber(grid, tr("Emphasis"), tr("-1: only what lies behind the rest plane; 1: only what lies before it"), -1,
                1, 2, {}, [](auto& m, double v) { m.emphasis = v; });
  addLastRow(grid, mInlayRows);
  mFalloff =
      addNumber(grid, tr("Fade"), tr("Distance from the rest plane at which structures have faded; 0: the reach"), 0,
                200, 1, {}, [](auto& m, double v) { m.falloff = v; });
  addLastRow(grid, mInlayRows);
  mLook = addChoice(grid, tr("Sheet"), tr("How the sheet itself is drawn"), {tr("Hidden"), tr("Grid"), tr("Surface")},
                    [](auto& m, int i) { m.look = static_cast<scene::SheetLook>(i); });
  mLook->setObjectName("membraneLook");
}

void MembraneForm::makeCloth(QGridLayout* grid) {
  mRepositioning =
      addChoice(grid, tr("Moving"),
                tr("Passive: the sheet starts anew from flat wherever its rest plane is put; active: the frame "
                   "drags it along, and it stays behind on what holds it"),
                {tr("Passive"), tr("Active")}, [](auto& m, int i) {
                  m.repositioning = static_cast<scene::Repositioning>(i);
                  if (m.repositioning == scene::Repositioning::Passive) m.shape = {};
                });
  mRepositioning->setObjectName("membraneMoving");
  mRule = addChoice(grid, tr("Rule"),
                    tr("Sided: the least cut says to which side a structure belongs, and it pushes the sheet to the "
                       "other; paper: away from each kernel's middle"),
                    {tr("Sided"), tr("Paper")},
                    [](auto& m, int i) { session::setRule(m, static_cast<scene::KernelRule>(i)); });
  mRule->setObjectName("membraneRule");
  mSide = addChoice(grid, tr("Passed by"),
                    tr("What the section would cut and the sheet can pass by: keep it whole, remove it whole, or leave "
                       "it on the side on which more of it lies"),
                    {tr("Keep"), tr("Remove"), tr("Nearest side")},
                    [](auto& m, int i) { m.field.side = static_cast<scene::MembraneSide>(i); });
  mSide->setObjectName("membraneSide");
  addLastRow(grid, mSidedRows);
  mLevel = addNumber(grid, tr("Kernels"),
                     tr("A kernel for so many times two voxels along each axis: 0 every voxel, 1 "
                        "every second, 2 every fourth"),
                     0, 6, 0, {}, [](auto& m, double v) { m.field.level = int(std::lround(v)); });
  mLevel->setObjectName("membraneLevel");
  addLastRow(grid, mPaperRows);
  mReach = addNumber(grid, tr("Area of effect"), tr("Half-width of a kernel, in kernels"), 1, 4, 1, {},
                     [](auto& m, double v) { m.field.areaOfEffect = v; });
  mReach->setObjectName("membraneArea");
  addLastRow(grid, mPaperRows);
  mStretch = addNumber(grid, tr("Stiff"), tr("Stiffness of the mesh against stretching, 0 to 1"), 0, 1, 2, {},
                       [](auto& m, double v) { m.cloth.stretch = v; });
  mStretch->setObjectName("membraneStretch");
  mBend = addNumber(grid, tr("Bending"), tr("Stiffness of the mesh against folding, 0 to 1"), 0, 1, 2, {},
                    [](auto& m, double v) { m.cloth.bend = v; });
  mBend->setObjectName("membraneBend");
  addLastRow(grid, mPaperRows);
  mRestoring = addNumber(grid, tr("Pull back"), tr("Pull back to the rest plane, 1/s\u00b2"), 0, 2000, 0, {},
                         [](auto& m, double v) { m.cloth.restoring = v; });
  mRestoring->setObjectName("membraneRestoring");
  mParticles = addNumber(grid, tr("Particles"), tr("Particles of the sheet along each edge"), 3, 260, 0, {},
                         [](auto& m, double v) { m.cloth.particles = glm::ivec2(int(std::lround(v))); });
  mParticles->setObjectName("membraneParticles");
  addLastRow(grid, mPaperRows);
  mFinest = addNumber(grid, tr("Finest"), tr("At rest the sheet is refined up to so many particles along an edge"), 3,
                      1024, 0, {}, [](auto& m, double v) { m.cloth.finest = int(std::lround(v)); });
  mFinest->setObjectName("membraneFinest");
  addLastRow(grid, mSidedRows);
}

void MembraneForm::showCut(const scene::Cut& cut) {
  mShown = *cut.membrane;
  const scene::Membrane& m = mShown;
  showCurve();
  mHands->showCut(cut);
  mNoise->showField(m.field);
  mStructures->showStrengths(session::protectableStructures(mDocument.scene()), m.field.byLabel);
  mSketch->showLength(Length(mDocument.scene()));
  mSketch->showStrokes(m.field.strokes);
  mUse->setCurrentIndex(int(m.use));
  auto showRows = [](const Rows& rows, bool isShown) {
    for (auto [label, control] : rows) {
      label->setVisible(isShown);
      control->setVisible(isShown);
    }
  };
  showRows(mInlayRows, m.use == scene::MembraneUse::Inlay);
  // What has no say in where a sheet rests is not offered.
  showRows(mSidedRows, m.field.rule == scene::KernelRule::Sided);
  showRows(mPaperRows, m.field.rule == scene::KernelRule::Paper);
  mInlayOpacity->setValue(m.inlayOpacity * 100.0);
  mEmphasis->setValue(m.emphasis);
  mFalloff->setLength(Length(mDocument.scene()));
  mFalloff->setRange(0.0, 2.0 * cut.size.z);
  mFalloff->setValue(m.falloff);
  mLook->setCurrentIndex(int(m.look));
  mRepositioning->setCurrentIndex(int(m.repositioning));
  mRule->setCurrentIndex(int(m.field.rule));
  mSide->setCurrentIndex(int(m.field.side));
  mLevel->setValue(m.field.level);
  mReach->setValue(m.field.areaOfEffect);
  mStretch->setValue(m.cloth.stretch);
  mBend->setValue(m.cloth.bend);
  mRestoring->setValue(m.cloth.restoring);
  mParticles->setValue(m.cloth.particles.x);
  mFinest->setValue(m.cloth.finest);
}

void MembraneForm::showCurve() {
  const auto& layer = mDocument.scene().volume;
  for (QWidget* part : {static_cast<QWidget*>(mCanvas), static_cast<QWidget*>(mAttribute)})
    part->setEnabled(bool(layer.data));
  mCanvas->setCurve(byGradient() ? mShown.field.byGradient : mShown.field.byValue);
  if (!layer.data) return;
  QString unit = QString::fromStdString(layer.data->unit);
  mCanvas->setUnit(byGradient() ? unit + "/" + Length(mDocument.scene()).sceneUnit() : unit);
  // Of several channels the sheet goes by the one that is edited.
  bool hasSeveral = layer.channels.size() > 1;
  auto channel = std::size_t(std::clamp(layer.channel, 0, layer.data->channels - 1));
  mFieldTitle->setText(hasSeveral ? tr("Protect in %1").arg(QString::fromStdString(layer.channels[channel].name))
                                  : tr("Protect"));
  mFieldTitle->setToolTip(hasSeveral ? tr("The channel that is chosen on the page Look: what the sheet goes by")
                                     : QString());
  if (mCounted != std::pair(layer.data.id(), layer.channel)) countHistogram();
  session::AxisView view = byGradient() ? session::AxisView{0.0, mGradients.range.y}
                                        : session::AxisView{layer.data->range.x, layer.data->range.y};
  mCanvas->setHistogram(byGradient() ? mGradients : mValues, view);
}

void MembraneForm::countHistogram() {
  if (mJob) return;
  auto values = std::make_shared<Histogram>(), gradients = std::make_shared<Histogram>();
  Shared<Volume> volume = mDocument.scene().volume.data;
  const auto& layer = mDocument.scene().volume;
  int channel = std::clamp(layer.channel, 0, volume->channels - 1),
      timeStep = std::clamp(layer.timeStep, 0, volume->timeSteps - 1);
  mJob = std::make_unique<Job>(
      [=](Progress&) {
        *values = session::valueHistogram(*volume, channel, timeStep);
        *gradients = session::gradientHistogram(*volume, channel, timeStep);
      },
      nullptr);
  connect(mJob.get(), &Job::finished, this,
          [this, values, gradients, of = std::pair(volume.id(), layer.channel)](bool done) {
            mJob.release()->deleteLater();
            if (!done) return;
            mValues = std::move(*values);
            mGradients = std::move(*gradients);
            mCounted = of;
            showCurve();
          });
  mJob->start();
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
  // The figure stays until there is another, so that the panel does not jump.
  if (QString text = figureText(*status, Length(mDocument.scene())); !text.isEmpty()) mFigure->setText(text);
  mFigure->setEnabled(status->isMeasured);
  mShares->setEnabled(status->isMeasured);
  if (status->isMeasured) {
    const auto& volume = mDocument.scene().volume.data;
    double voxelSize = volume ? std::abs(glm::determinant(glm::dmat3(volume->worldFromVoxel))) : 0.0;
    mNoise->showLeftOut(status->leftOut, voxelSize, Length(mDocument.scene()));
  }
  if (status->isMeasured) mShares->setShares(status->shares);
  QString kernels = tr("%1 kernels, %2 \u00d7 %3 particles")
                        .arg(QLocale().toString(qulonglong(status->kernels)))
                        .arg(status->particles.x)
                        .arg(status->particles.y);
  QString doing = status->phase == Phase::Resting     ? tr("At rest")
                  : status->phase == Phase::Computing ? tr("Computing forces")
                  : status->phase == Phase::Paused    ? tr("Paused at step %1").arg(status->steps)
                                                      : tr("Settling, step %1").arg(status->steps);
  mDoing->setText(status->error.empty() ? doing + "." : QString::fromStdString(status->error));
  mDoing->setToolTip(kernels + "\n" +
                     tr("Forces took %1 ms, a step takes %2 ms; largest speed %3 %4/s")
                         .arg(status->forcesMs, 0, 'f', 0)
                         .arg(status->stepMs, 0, 'f', 1)
                         .arg(status->speed, 0, 'g', 3)
                         .arg(Length(mDocument.scene()).sceneUnit()));
}

}  // namespace velum::gui
