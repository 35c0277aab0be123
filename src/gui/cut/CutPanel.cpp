#include "gui/cut/CutPanel.h"

#include <QMenu>
#include <QVBoxLayout>
#include <algorithm>
#include <memory>

#include "gui/kit/CutTitle.h"
#include "gui/kit/Words.h"
#include "gui/service/SelectedCut.h"
#include "session/command/Command.h"
#include "session/command/CutCommands.h"
#include "session/command/StructureCommands.h"
#include "session/cut/CutEdit.h"
#include "session/cut/ShapeTraits.h"
#include "session/membrane/FirstPlace.h"
#include "session/structure/StructureEdit.h"

namespace velum::gui {

namespace {

constexpr int kButtonHeight = 28;

QString shapeTitle(scene::CutShape shape) { return wordsOf(session::traitsOf(shape).title); }

}  // namespace

CutPanel::CutPanel(session::Document& document, Selection& selection, JobRunner& jobs, QWidget* parent)
    : QWidget(parent),
      mDocument(document),
      mSelection(selection),
      mJobs(jobs),
      mList(new CutList(this)),
      mForm(new CutForm(document, selection, jobs, this)),
      mMembrane(new MembraneForm(document, selection, this)),
      mSpares(new SpareList(this)),
      mTypeSpares(new TypeSpareList(document, selection, this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(10);
  buildHead();
  mEmpty = new QLabel(
      tr("Nothing is cut away. Add a plane (C), a box or a round shape; drag its handles in the picture."), this);
  mEmpty->setWordWrap(true);
  mEmpty->setProperty("role", "muted");
  layout->addWidget(mEmpty);
  layout->addWidget(mTools = buildTools());  // over the list, which grows: a button stays under the pointer
  layout->addWidget(mList);
  layout->addWidget(mForm);
  layout->addWidget(mMembrane);
  layout->addWidget(mLine = makeLine(this));
  layout->addWidget(mSpares, 1000);
  layout->addWidget(mTypeSpares, 1000);
  layout->addStretch(1);  // holds all up where there is no list to fill the height
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
  connect(mList, &QListWidget::currentRowChanged, this, [this](int row) { mSelection.setCut(mList->idAt(row)); });
  connect(mList, &QListWidget::itemClicked, this, &CutPanel::cutClicked);
  connect(&mSelection, &Selection::cutChanged, this, &CutPanel::refresh);
  connect(mList, &CutList::moveAsked, this, &CutPanel::moveSelected);
  connect(mList, &CutList::toggled, this, [this](int id, bool on) {
    session::edit(mDocument, session::EnableCut{key(id), on});
  });
  connect(mList, &CutList::renamed, this, [this](int id, const QString& name) {
    session::edit(mDocument, session::RenameCut{key(id), name.trimmed().toStdString()});
  });
  connect(mSpares, &SpareList::changed, this, [this](const std::vector<int>& ids, bool whole) {
    session::edit(mDocument, session::SpareStructures{session::structureNames(mDocument.shown(), ids), whole,
                                                      key(mSelection.cut())});
  });
  refresh();
}

void CutPanel::buildHead() {
  auto* head = new QHBoxLayout;
  head->setSpacing(6);
  head->addWidget(makeTitle(tr("Cuts"), this), 1);
  auto* add = new QPushButton(tr("Add plane"), this);
  add->setObjectName("addPlane");
  add->setToolTip(tr("Cut away what lies before the crosshair, across the body's axis that faces you (C)"));
  auto* more = new QToolButton(this);
  more->setObjectName("addMore");
  more->setText(tr("Add other"));
  more->setToolTip(tr("Another shape, or a plane that is placed another way"));
  more->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(more);
  for (const auto& shape : session::allShapes())
    if (shape.menuText) menu->addAction(wordsOf(shape.title), this, [this, shape = shape.shape] { addShape(shape); });
  menu->addSeparator();
  QAction* sheet = menu->addAction(shapeTitle(scene::CutShape::Membrane), this, &CutPanel::addMembrane);
  sheet->setToolTip(tr("An elastic sheet that cuts around what matters instead of through it (M)"));
  menu->setToolTipsVisible(true);
  menu->addAction(tr("Cut along the view"), this, &CutPanel::addAlongView);
  menu->addAction(tr("Plane through three points..."), this, &CutPanel::threePointsAsked);
  more->setMenu(menu);
  for (QWidget* button : {static_cast<QWidget*>(add), static_cast<QWidget*>(more)})
    button->setFixedHeight(kButtonHeight);
  head->addWidget(add);
  head->addWidget(more);
  static_cast<QVBoxLayout*>(layout())->addLayout(head);
  connect(add, &QPushButton::clicked, this, &CutPanel::addPlane);
}

QWidget* CutPanel::buildTools() {
  auto* tools = new QWidget(this);
  auto* row = new QHBoxLayout(tools);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  auto add = [&](const QString& text, const QString& name, const QString& tip) {
    auto* button = new QPushButton(text, tools);
    button->setObjectName(name);
    button->setProperty("role", "quiet");
    button->setToolTip(tip);
    row->addWidget(button);
    return button;
  };
  auto* twice = add(tr("Duplicate"), "cutDuplicate", tr("Add a copy of the selected cut"));
  mUp = add(tr("Up"), "cutUp", tr("Move the cut up in the list (Alt+Up)"));
  mDown = add(tr("Down"), "cutDown", tr("Move the cut down in the list (Alt+Down)"));
  row->addStretch(1);
  auto* remove = add(tr("Remove"), "cutRemove", tr("Remove the selected cut (Del)"));
  connect(twice, &QPushButton::clicked, this, &CutPanel::duplicateSelected);
  connect(mUp, &QPushButton::clicked, this, [this] { moveSelected(-1); });
  connect(mDown, &QPushButton::clicked, this, [this] { moveSelected(1); });
  connect(remove, &QPushButton::clicked, this, &CutPanel::removeSelected);
  return tools;
}

bool CutPanel::hasData() const { return scene::hasData(mDocument.shown()); }

bool CutPanel::hasRoom() {
  if (mDocument.shown().cuts.size() < scene::kMostCuts) return true;
  emit refused(tr("A scene holds %1 cuts at most; remove one first.").arg(scene::kMostCuts));
  return false;
}

void CutPanel::addCut(scene::Cut cut, const char* label) {
  if (!hasData() || !hasRoom()) return;
  if (cut.name.empty()) cut.name = session::newCutName(mDocument.shown(), cut.shape);
  int id = 0;
  session::editByHand(mDocument, label, [&](scene::Scene& scene) { id = scene::addCut(scene, cut); });
  mSelection.setCut(id);
}

void CutPanel::addAs(const session::Call& call) {
  if (!hasData() || !hasRoom()) return;
  int id = scene::nextCutId(mDocument.shown());
  session::edit(mDocument, call);
  mSelection.setCut(id);
}

void CutPanel::addShape(scene::CutShape shape) {
  if (shape != scene::CutShape::Membrane) return addAs(session::AddCut{shape, {}});
  if (hasData() && hasRoom()) searchMembrane();
}

void CutPanel::searchMembrane() {
  auto membrane = std::make_shared<scene::Cut>();
  mJobs.startShort(
      tr("Looking for where the membrane keeps what it protects"),
      [membrane, scene = mDocument.shown()](Progress& progress) { *membrane = session::newMembrane(scene, progress); },
      [this, membrane, data = mDocument.shown().volume.data] {
        if (mDocument.shown().volume.data == data) addCut(*membrane, "Add membrane");  // not into what is open by now
      });
}

void CutPanel::addAlongView() { addAs(session::CutAlongView{}); }

std::string CutPanel::key(int id) const { return session::cutKey(mDocument.shown(), id); }

void CutPanel::removeSelected() {
  if (place() >= 0) session::edit(mDocument, session::RemoveCut{key(mSelection.cut())});
}

void CutPanel::flipSelected() {
  if (place() >= 0) session::edit(mDocument, session::FlipCut{key(mSelection.cut())});
}

void CutPanel::duplicateSelected() {
  if (place() >= 0) addAs(session::DuplicateCut{key(mSelection.cut())});
}

void CutPanel::moveSelected(int by) {
  if (place() >= 0) session::edit(mDocument, session::MoveCutInList{key(mSelection.cut()), by});
}

int CutPanel::place() const { return scene::cutPlace(mDocument.shown(), mSelection.cut()); }

void CutPanel::refresh() {
  const scene::Scene& scene = mDocument.shown();
  int count = int(scene.cuts.size()), index = place();
  if (index < 0) {
    // Select the cut that now has the place of the one that was removed.
    int next = std::clamp(mShown.place, 0, std::max(0, count - 1));
    int id = count > 0 ? scene.cuts[std::size_t(next)].id : 0;
    if (id != mSelection.cut()) return mSelection.setCut(id);  // comes back here
  }
  Shown now{scene.cuts,
            scene.labels.structures,
            scene.volume.data.id(),
            scene.labels.data.id(),
            scene.model.data.id(),
            index,
            mDocument.scene().timeline.tracks,
            mDocument.playhead()};
  if (now == mShown) return;
  mShown = std::move(now);
  bool any = index >= 0;
  mList->setCuts(scene.cuts, index);
  for (QWidget* part : {static_cast<QWidget*>(mList), mTools, static_cast<QWidget*>(mForm)}) part->setVisible(any);
  mEmpty->setVisible(!any);
  bool isMembrane = any && scene::isMembrane(scene.cuts[std::size_t(index)]);
  mMembrane->setVisible(isMembrane);
  mLine->setVisible(any && (!scene.labels.structures.empty() || scene.model.data));
  mSpares->setVisible(any);
  mTypeSpares->setVisible(any);
  if (!any) return;
  if (isMembrane) mMembrane->showCut(scene.cuts[std::size_t(index)]);
  mUp->setEnabled(index > 0);
  mDown->setEnabled(index + 1 < count);
  const scene::Cut& cut = scene.cuts[std::size_t(index)];
  mForm->showCut(cut);
  mSpares->showCut(scene.labels.structures, cut);
  mTypeSpares->showCut(scene, cut);
}

}  // namespace velum::gui
