#include "gui/extrusion/ExtrusionPanel.h"

#include <QGridLayout>
#include <QVBoxLayout>

#include "gui/kit/Length.h"
#include "session/command/Command.h"
#include "session/command/CutCommands.h"
#include "session/command/ExtrusionCommands.h"
#include "session/command/StructureCommands.h"
#include "session/extrusion/Pull.h"
#include "session/extrusion/PulledEnd.h"
#include "session/growth/Growths.h"
#include "session/structure/StructureEdit.h"
#include "session/structure/StructureRow.h"

namespace velum::gui {

namespace {

constexpr int kSpacing = 8;

QPushButton* button(QWidget* parent, const QString& text, const char* name, const QString& tip) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName(name);
  made->setToolTip(tip);
  return made;
}

}  // namespace

ExtrusionPanel::ExtrusionPanel(session::Session& session, Selection& selection, QWidget* parent)
    : QWidget(parent), mSession(session), mDocument(session.document()), mSelection(selection) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kSpacing);
  layout->addWidget(mSteps = new PullSteps(this));
  layout->addWidget(makeLine(this));
  auto* head = new QHBoxLayout;
  mPull = button(this, tr("Pull out"), "pullOut",
                 tr("Drag structures out of the cut: press on one in the picture and pull"));
  mSecond =
      button(this, tr("Second plane"), "secondPlane",
             tr("A plane across the selected one: the two open a wedge, and structures can be pulled out of both"));
  head->addWidget(mPull);
  head->addWidget(mSecond);
  layout->addLayout(head);
  layout->addWidget(mList = new ExtrusionList(this));
  layout->addWidget(mForm = buildForm());
  // At the end, so that no field moves when the box appears.
  layout->addWidget(mLeak = new LeakBox(session, this));
  layout->addStretch(1);
  connect(mLeak, &LeakBox::held, this, &ExtrusionPanel::held);
  connect(mLeak, &LeakBox::notThisAsked, this, [this](int structure) {
    mSelection.setStructure(structure);
    emit notThisAsked();
  });
  connect(mSecond, &QPushButton::clicked, this, &ExtrusionPanel::addPlane);
  connect(mList, &ExtrusionList::chosen, this, [this](const session::Extrusion& one) {
    mSelection.setCut(one.cut);
    mSelection.setStructure(one.structure);
    showForm();
  });
  connect(&mSelection, &Selection::structureChanged, this, &ExtrusionPanel::refresh);
  connect(&mSelection, &Selection::cutChanged, this, &ExtrusionPanel::refresh);
  tabInLayoutOrder(this);
}

QWidget* ExtrusionPanel::buildForm() {
  auto* form = new QWidget(this);
  auto* layout = new QVBoxLayout(form);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kSpacing);
  layout->addLayout(buildRow(form));
  auto* grid = new QGridLayout;
  grid->setColumnStretch(1, 1);
  grid->setHorizontalSpacing(10);
  mDistance = new NumberRow(0, 100, 1, " mm", form);
  mDistance->setObjectName("pulledDistance");
  mDistance->setName(tr("How far it stands out"));
  mDistance->setToolTip(tr("How far the structure stands out of the cut's face; 0 puts it back"));
  grid->addWidget(new QLabel(tr("Out by"), form), 0, 0);
  grid->addWidget(mDistance, 0, 1);
  layout->addLayout(grid);
  connect(mDistance, &NumberRow::changed, this, &ExtrusionPanel::setDistance);
  connect(mDistance, &NumberRow::settled, this, [this] { mDocument.endMerge(); });
  layout->addWidget(mGrowth = new GrowthForm(mSession, form));
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

/// Name and colour of the row that is selected.
QLayout* ExtrusionPanel::buildRow(QWidget* form) {
  auto* row = new QHBoxLayout;
  row->setSpacing(10);
  mColor = new ColorButton(tr("Colour of what is pulled out"), form);
  mColor->setObjectName("pulledColor");
  mColor->setToolTip(tr("Its own colour; until it has one, what has grown is coloured by its values"));
  mColor->setFixedSize(40, 26);
  mName = new QLineEdit(form);
  mName->setObjectName("pulledName");
  mName->setAccessibleName(tr("Name of what is pulled out"));
  mName->setToolTip(tr("Its name, as in the list of structures"));
  row->addWidget(mColor);
  row->addWidget(mName, 1);
  connect(mName, &QLineEdit::editingFinished, this, &ExtrusionPanel::rename);
  connect(mColor, &ColorButton::picked, this, &ExtrusionPanel::setColor);
  return row;
}

void ExtrusionPanel::rename() {
  auto one = mList->current();
  QString name = mName->text().trimmed();
  mName->setModified(false);
  const scene::Scene& scene = mDocument.shown();
  if (!one || name.toStdString() == session::structureName(scene, one->structure)) return;
  session::edit(mDocument,
                session::RenameStructure{session::structureNames(scene, {one->structure})[0], name.toStdString()});
}

void ExtrusionPanel::setColor(glm::vec3 color) {
  auto one = mList->current();
  if (!one) return;
  session::edit(mDocument,
                session::ColorStructures{session::structureNames(mDocument.shown(), {one->structure}), color});
}

ExtrusionPanel::Shown ExtrusionPanel::shownOf(const scene::Scene& scene) const {
  Shown shown{session::extrusionsOf(scene), scene.labels.structures, scene.labels.growths, {}, {}, {}};
  for (const auto& cut : scene.cuts) shown.cuts.emplace_back(cut.id, cut.name);
  shown.isGrown = session::isGrown(scene);
  shown.data.push_back(scene.volume.data ? scene.volume.data.id() : scene.labels.data.id());
  for (const auto& surface : scene.surfaces) shown.data.push_back(surface.data.id());
  const scene::Cut* cut = scene::findCut(scene, mSelection.cut());
  shown.isPlane = cut && cut->shape == scene::CutShape::Plane;
  shown.cut = mSelection.cut();
  shown.structure = mSelection.structure();
  return shown;
}

void ExtrusionPanel::refresh() {
  const scene::Scene& scene = mDocument.shown();
  mSteps->showScene(scene);
  if (Shown now = shownOf(scene); !(now == mShown)) {
    mShown = std::move(now);
    showRows();
  }
  mGrowth->showProgress();
  mLeak->refresh();
}

void ExtrusionPanel::showRows() {
  const scene::Scene& scene = mDocument.shown();
  const auto& extrusions = mShown.extrusions;
  mList->showScene(scene, extrusions);
  mList->select(mSelection.cut(), mSelection.structure());
  if (!mList->current() && !extrusions.empty()) mList->select(extrusions[0].cut, extrusions[0].structure);
  mList->setVisible(!extrusions.empty());
  mForm->setVisible(!extrusions.empty());
  mSecond->setEnabled(mShown.isPlane);
  mPull->setEnabled(scene::hasData(scene));
  mAllBack->setEnabled(!extrusions.empty());
  showForm();
}

void ExtrusionPanel::showForm() {
  const scene::Scene& scene = mDocument.shown();
  auto one = mList->current();
  mDistance->setEnabled(bool(one));
  mBack->setEnabled(bool(one));
  mGrowth->showStructure(one ? one->structure : 0);
  if (!one) return;
  const scene::Structure* row = session::findStructure(scene, one->structure);
  mName->setEnabled(row);
  mColor->setEnabled(row);
  QString name = row ? QString::fromStdString(session::structureName(scene, one->structure)) : QString();
  if (!mName->hasFocus() || !mName->isModified()) mName->setText(name);
  mColor->setColor(row ? row->color : glm::vec3(0.6f));
  const scene::Cut* cut = scene::findCut(scene, one->cut);
  mDistance->setLength(Length(scene));
  mDistance->setRange(0.0, std::max(cut ? session::pulledEnd(scene, *cut, one->structure) : 0.0, one->distance));
  mDistance->setValue(one->distance);
}

void ExtrusionPanel::setDistance(double distance) {
  auto one = mList->current();
  if (!one) return;
  QString name = QString::fromStdString(session::structureName(mDocument.shown(), one->structure));
  auto pull = session::pullAgain(mDocument.shown(), *one);
  session::editByHand(
      mDocument, tr("Pull out %1").arg(name).toStdString(),
      [&](scene::Scene& scene) { session::pullTo(scene, pull, distance); }, true);
}

void ExtrusionPanel::addPlane() {
  std::optional<int> id;
  session::editByHand(mDocument, "Second plane",
                      [&](scene::Scene& scene) { id = session::addJoinedPlane(scene, mSelection.cut()); });
  if (id)
    mSelection.setCut(*id);
  else
    emit refused(tr("Select a plane first: the second one is put across it."));
}

void ExtrusionPanel::putBack() {
  auto chosen = mList->selected();
  if (chosen.empty()) return;
  std::vector<int> ids;
  bool areOfOne = true;
  for (const auto& one : chosen) {
    ids.push_back(one.structure);
    areOfOne &= one.cut == chosen.front().cut;
  }
  std::string cut = areOfOne ? session::cutKey(mDocument.shown(), chosen.front().cut) : std::string();
  session::edit(mDocument, session::PutBack{session::structureNames(mDocument.shown(), ids), cut});
}

void ExtrusionPanel::putAllBack() { session::edit(mDocument, session::PutAllBack{}); }

}  // namespace velum::gui
