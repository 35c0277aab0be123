#include "ExtrusionPanel.h"

#include <QGridLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>

#include "kit/Length.h"
#include "velum/session/extrusion/Pull.h"
#include "velum/session/structure/StructureEdit.h"

namespace velum::gui {

namespace {

constexpr int kSpacing = 8;

QPushButton* button(QWidget* parent, const QString& text, const char* name, const QString& tip) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName(name);
  made->setToolTip(tip);
  return made;
}

QLabel* quietLabel(QWidget* parent, const char* name) {
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setProperty("role", "muted");
  label->setWordWrap(true);
  return label;
}

}  // namespace

ExtrusionPanel::ExtrusionPanel(session::Session& session, Selection& selection, QWidget* parent)
    : QWidget(parent), mSession(session), mDocument(session.document()), mSelection(selection) {
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(kSpacing);
  auto* head = new QHBoxLayout;
  mPull = button(this, tr("Pull out"), "pullOut",
                 tr("Drag structures out of the cut: press on one in the picture and pull"));
  mSecond =
      button(this, tr("Second plane"), "secondPlane",
             tr("A plane across the selected one: the two open a wedge, and structures can be pulled out of both"));
  head->addWidget(mPull);
  head->addWidget(mSecond);
  layout->addLayout(head);
  mEmpty = quietLabel(this, "nothingPulled");
  mEmpty->setText(
      tr("Nothing stands out of a cut. Press Pull out, then drag a bone, a vessel or an organ out of the cut in the "
         "picture. What has no label yet is found from its values as you pull."));
  layout->addWidget(mEmpty);
  mList = new ExtrusionList(this);
  layout->addWidget(mList, 1);
  buildLeak(layout);
  mForm = buildForm();
  layout->addWidget(mForm);
  layout->addStretch(0);
  connect(mSecond, &QPushButton::clicked, this, &ExtrusionPanel::addPlane);
  connect(mList, &ExtrusionList::chosen, this, [this](const session::Extrusion& one) {
    mSelection.setCut(one.cut);
    mSelection.setStructure(one.structure);
    showForm();
  });
  auto follow = [this] {
    mList->select(mSelection.cut(), mSelection.structure());
    showForm();
  };
  connect(&mSelection, &Selection::structureChanged, this, follow);
  connect(&mSelection, &Selection::cutChanged, this, follow);
  tabInLayoutOrder(this);
}

QWidget* ExtrusionPanel::buildForm() {
  auto* form = new QWidget(this);
  auto* layout = new QVBoxLayout(form);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kSpacing);
  auto* grid = new QGridLayout;
  grid->setColumnStretch(1, 1);
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(kSpacing);
  mDistance = new NumberRow(0, 100, 1, " mm", form);
  mDistance->setObjectName("pulledDistance");
  mDistance->setName(tr("How far it stands out"));
  mDistance->setToolTip(tr("How far the structure stands out of the cut's face; 0 puts it back"));
  grid->addWidget(new QLabel(tr("Out by"), form), 0, 0);
  grid->addWidget(mDistance, 0, 1);
  layout->addLayout(grid);
  connect(mDistance, &NumberRow::changed, this, &ExtrusionPanel::setDistance);
  connect(mDistance, &NumberRow::settled, this, [this] { mDocument.endMerge(); });
  mGrown = new QWidget(form);
  auto* grown = new QGridLayout(mGrown);
  grown->setContentsMargins(0, 0, 0, 0);
  buildGrowth(grown);
  layout->addWidget(mGrown);
  auto* foot = new QHBoxLayout;
  mBack = button(form, tr("Put back"), "putBack", tr("The selected structures go back into the cut"));
  mAllBack = button(form, tr("Put all back"), "putAllBack", tr("Everything goes back into the cuts"));
  foot->addWidget(mBack);
  foot->addWidget(mAllBack);
  layout->addLayout(foot);
  connect(mBack, &QPushButton::clicked, this, &ExtrusionPanel::putBack);
  connect(mAllBack, &QPushButton::clicked, this, &ExtrusionPanel::putAllBack);
  return form;
}

void ExtrusionPanel::buildGrowth(QGridLayout* grid) {
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(2, 1);
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(kSpacing);
  auto number = [&](const char* name, const QString& spoken, const QString& tip) {
    auto* spin = new QDoubleSpinBox(mGrown);
    spin->setObjectName(name);
    spin->setAccessibleName(spoken);
    spin->setToolTip(tip);
    spin->setKeyboardTracking(false);
    connect(spin, &QDoubleSpinBox::editingFinished, this, [this] { mDocument.endMerge(); });
    return spin;
  };
  mLow = number("growLow", tr("Smallest value that belongs to it"),
                tr("Smallest value that belongs to the structure: it grows anew as it changes"));
  mHigh = number("growHigh", tr("Largest value that belongs to it"),
                 tr("Largest value that belongs to the structure: it grows anew as it changes"));
  mSteepest = number("growSteepest", tr("Gradient at which it stops"),
                     tr("Growing stops where the values change by more than this from voxel to voxel; at 0 it does not "
                        "ask.\nOf use where two structures of like values touch"));
  mSteepest->setSpecialValueText(tr("off"));
  grid->addWidget(new QLabel(tr("Values"), mGrown), 0, 0);
  grid->addWidget(mLow, 0, 1);
  grid->addWidget(mHigh, 0, 2);
  grid->addWidget(new QLabel(tr("Edges"), mGrown), 1, 0);
  grid->addWidget(mSteepest, 1, 1);
  mBarrier = button(mGrown, tr("Barrier"), "barrierTool",
                    tr("Draw a stroke that the structure does not grow through, where it would leak into another"));
  grid->addWidget(mBarrier, 1, 2);
  mText = quietLabel(mGrown, "growText");
  grid->addWidget(mText, 2, 0, 1, 3);
  connect(mLow, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    changeGrowth(tr("Change its values"), [&](scene::Growth& g) { g.low = std::min(value, g.high); });
  });
  connect(mHigh, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    changeGrowth(tr("Change its values"), [&](scene::Growth& g) { g.high = std::max(value, g.low); });
  });
  connect(mSteepest, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    changeGrowth(tr("Stop at edges"),
                 [&](scene::Growth& g) { g.steepest = value > 0.0 ? value : scene::Growth::kEndless; });
  });
}

/// What to do where a structure is about to flow into another.
void ExtrusionPanel::buildLeak(QVBoxLayout* layout) {
  mLeak = new QWidget(this);
  auto* box = new QVBoxLayout(mLeak);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(kSpacing);
  mLeakText = new QLabel(mLeak);
  mLeakText->setObjectName("leakText");
  mLeakText->setWordWrap(true);
  box->addWidget(mLeakText);
  auto* row = new QHBoxLayout;
  auto* here = button(mLeak, tr("As far as here"), "leakHere", tr("It stays as it is, however far it is pulled"));
  auto* on = button(mLeak, tr("Go on"), "leakGoOn", tr("It is no leak: the structure goes on there"));
  row->addWidget(here);
  row->addWidget(on);
  box->addLayout(row);
  layout->addWidget(mLeak);
  mLeak->hide();
  connect(here, &QPushButton::clicked, this, [this] {
    mSession.growth().acceptLeak();
    showLeak();
  });
  connect(on, &QPushButton::clicked, this, [this] {
    session::GrowthPlayer& player = mSession.growth();
    if (auto leak = player.status().leak) {
      player.trust(leak->structure);
      mDocument.edit(tr("Grow on").toStdString(),
                     [&](scene::Scene& scene) { session::growOn(scene, leak->structure); });
    }
    showLeak();
  });
}

void ExtrusionPanel::refresh() {
  const scene::Scene& scene = mDocument.scene();
  auto extrusions = session::extrusionsOf(scene);
  mList->showScene(scene, extrusions);
  mList->select(mSelection.cut(), mSelection.structure());
  if (!mList->current() && !extrusions.empty()) mList->select(extrusions[0].cut, extrusions[0].structure);
  mList->setVisible(!extrusions.empty());
  mEmpty->setVisible(extrusions.empty());
  const scene::Cut* cut = scene::findCut(scene, mSelection.cut());
  mSecond->setEnabled(cut && cut->shape == scene::CutShape::Plane);
  mPull->setEnabled(scene::hasData(scene));
  mAllBack->setEnabled(!extrusions.empty());
  showForm();
  showLeak();
}

const scene::Growth* ExtrusionPanel::growth() const {
  auto one = mList->current();
  return one ? session::lastGrowth(mDocument.scene(), one->structure) : nullptr;
}

void ExtrusionPanel::showForm() {
  const scene::Scene& scene = mDocument.scene();
  auto one = mList->current();
  mForm->setVisible(mList->isVisibleTo(this));
  mDistance->setEnabled(bool(one));
  mBack->setEnabled(bool(one));
  if (one) {
    scene::Bounds bounds = scene::computeBounds(scene);
    mDistance->setLength(Length(scene));
    mDistance->setRange(0.0, std::max(glm::length(bounds.max - bounds.min), one->distance));
    mDistance->setValue(one->distance);
  }
  const scene::Growth* grown = growth();
  mGrown->setVisible(grown && scene.volume.data);
  if (!grown || !scene.volume.data) return;
  const Volume& volume = *scene.volume.data;
  double range = double(volume.range.y) - double(volume.range.x);
  bool isWhole = volume.type != SampleType::Float32 && volume.scale == 1.0;
  QString unit = volume.unit.empty() ? QString() : " " + QString::fromStdString(volume.unit);
  for (QDoubleSpinBox* spin : {mLow, mHigh, mSteepest}) {
    const QSignalBlocker quiet(spin);
    spin->setDecimals(
        isWhole && spin != mSteepest ? 0 : std::max(0, 3 - int(std::floor(std::log10(std::max(range, 1e-12))))));
    spin->setRange(spin == mSteepest ? 0.0 : double(volume.range.x), spin == mSteepest ? 1e6 : double(volume.range.y));
    spin->setSingleStep(range / 200.0);
    spin->setSuffix(spin == mSteepest ? unit + "/" + Length(scene).unit() : unit);
  }
  const QSignalBlocker a(mLow), b(mHigh), c(mSteepest);
  mLow->setValue(grown->low);
  mHigh->setValue(grown->high);
  mSteepest->setValue(std::isfinite(grown->steepest) ? grown->steepest : 0.0);
  session::GrowthStatus status = mSession.growth().status();
  mText->setText(status.isGrowing && status.structure == one->structure
                     ? tr("Growing: %1 voxels so far. Esc stops it.").arg(QLocale().toString(qlonglong(status.voxels)))
                     : tr("Grown from its values. %1 barriers.").arg(grown->barriers.size()));
}

void ExtrusionPanel::showLeak() {
  auto leak = mSession.growth().status().leak;
  mLeak->setVisible(bool(leak));
  if (!leak) return;
  const scene::Scene& scene = mDocument.scene();
  mLeakText->setText(tr("%1 would flow into something else: %2 out its section becomes %3 times as large. It is held "
                        "there. Narrow its "
                        "values, draw a barrier, or stop at edges; or:")
                         .arg(QString::fromStdString(session::structureName(scene, leak->structure)),
                              Length(scene).text(leak->distance))
                         .arg(leak->times, 0, 'f', 1));
}

void ExtrusionPanel::changeGrowth(const QString& label, const std::function<void(scene::Growth&)>& change) {
  auto one = mList->current();
  if (!one) return;
  mDocument.edit(
      label.toStdString(), [&](scene::Scene& scene) { session::changeGrowth(scene, one->structure, change); }, true);
}

void ExtrusionPanel::setDistance(double distance) {
  auto one = mList->current();
  if (!one) return;
  auto pull = session::pullAgain(mDocument.scene(), *one);
  QString name = QString::fromStdString(session::structureName(mDocument.scene(), one->structure));
  mDocument.edit(
      tr("Pull out %1").arg(name).toStdString(), [&](scene::Scene& scene) { session::pullTo(scene, pull, distance); },
      true);
}

void ExtrusionPanel::addPlane() {
  std::optional<int> id;
  mDocument.edit("Second plane", [&](scene::Scene& scene) { id = session::addJoinedPlane(scene, mSelection.cut()); });
  if (id)
    mSelection.setCut(*id);
  else
    emit refused(tr("Select a plane first: the second one is put across it."));
}

void ExtrusionPanel::putBack() {
  auto chosen = mList->selected();
  if (chosen.empty()) return;
  std::vector<int> ids;
  for (const auto& one : chosen) ids.push_back(one.structure);
  mDocument.edit(session::structureLabel(mDocument.scene(), "Put back", ids), [&](scene::Scene& scene) {
    for (const auto& one : chosen)
      if (scene::Cut* cut = scene::findCut(scene, one.cut)) session::setExtrusion(*cut, one.structure, 0.0);
  });
}

void ExtrusionPanel::putAllBack() {
  mDocument.edit("Put all back", [](scene::Scene& scene) { session::resetExtrusions(scene); });
}

}  // namespace velum::gui
