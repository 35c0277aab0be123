#include "gui/cut/CutRoom.h"

#include <algorithm>

#include "gui/kit/Words.h"
#include "session/cut/ShapeTraits.h"

namespace velum::gui {

CutRoom::CutRoom(const WindowParts& parts)
    : Room(parts),
      mPanel(new CutPanel(parts.document(), parts.selection, parts.jobs, &parts.tabs)),
      mOverPicture(parts.document(), parts.selection, parts.toolbox, nullptr),
      mOnSections(parts.document(), parts.selection, parts.toolbox, nullptr),
      mThreePoints(parts.document(), parts.toolbox, nullptr),
      mMembranes(parts, mPanel->membraneForm()),
      mNothingLeft(parts.session, parts.messages, nullptr) {
  parts.tabs.addPage(mPanel, QT_TRANSLATE_NOOP("Words", "Cuts"), tr("What is cut away"));
  parts.toolbox.add(mOverPicture);
  parts.toolbox.add(mOnSections);
  mMembranes.addManipulators();  // they lie on the cut
  Viewport& viewport = parts.views.viewport();
  connect(&viewport, &Viewport::sheetsMoved, &mOnSections,
          [this] { mOnSections.setSheets(mParts.session.membranes().indices()); });
  Toolbox& toolbox = parts.toolbox;
  connect(mPanel, &CutPanel::threePointsAsked, this, [this, &toolbox] { toolbox.start(mThreePoints); });
  connect(mPanel, &CutPanel::refused, &parts.messages,
          [&bar = parts.messages](const QString& why) { bar.showNote(why); });
  FocusForm& focus = mPanel->focusForm();
  connect(&focus, &FocusForm::lockAsked, &focus, [&focus, &viewport](bool locked) {
    focus.lock(locked, double(viewport.width()) / std::max(1, viewport.height()));
  });
  connect(&parts.selection, &Selection::cutChanged, this, [this, &toolbox] { toolbox.stop(mThreePoints); });
  connect(&mThreePoints, &ThreePointTool::made, mPanel,
          [this](const scene::Cut& cut) { mPanel->addCut(cut, "Plane through three points"); });
  addActions(parts.menu(MenuId::Cut));
}

void CutRoom::refresh(const session::Session& session) {
  mPanel->refresh();
  mMembranes.refresh(session);
  mNothingLeft.refresh();
}

/// Adds a cut, and shows it at once, its page in the side panel, too.
void CutRoom::add(const std::function<void()>& make) {
  make();
  mParts.tabs.showPage(mPanel);
}

void CutRoom::addActions(QMenu* menu) {
  ActionTable& actions = mParts.actions;
  QAction* plane = actions.addForScene(menu, "cut.addPlane", tr("&Add plane"), tr("Cut away the half that faces you"),
                                       [this] { add([this] { mPanel->addPlane(); }); });
  actions.addForScene(menu, "cut.alongView", tr("Cut along the &view"),
                      tr("A plane through the middle that faces you exactly"),
                      [this] { add([this] { mPanel->addAlongView(); }); });
  mParts.toolbox.bind(mThreePoints,
                      *actions.addForScene(menu, "cut.threePoints", tr("Plane through three &points"),
                                           tr("Click three points in the picture or on sections"), [] {}));
  QAction* sheet = actions.addForScene(menu, "cut.addMembrane", tr("Add &membrane"),
                                       tr("An elastic sheet that cuts around what matters instead of through it"),
                                       [this] { add([this] { mPanel->addMembrane(); }); });
  addShapes(menu);
  menu->addSeparator();
  mMembranes.addActions(menu);
  menu->addSeparator();
  actions.addForScene(menu, "cut.flip", tr("&Flip"), tr("Take away the other side"),
                      [this] { mPanel->flipSelected(); });
  actions.addForScene(menu, "cut.duplicate", tr("&Duplicate"), tr("Add a copy of the selected cut"),
                      [this] { mPanel->duplicateSelected(); });
  actions.addForScene(menu, "cut.remove", tr("&Remove"), tr("Remove the selected cut"),
                      [this] { mPanel->removeSelected(); });
  menu->addSeparator();
  addHandles(menu);
  plane->setIconText(tr("Add cut"));
  sheet->setIconText(tr("Membrane"));
}

/// The command that puts handles away, so that the picture is free; when the user selects a cut they come back.
void CutRoom::addHandles(QMenu* menu) {
  Toolbox& toolbox = mParts.toolbox;
  QAction* handles =
      mParts.actions.addForScene(menu, "cut.handles", tr("Show handle&s"),
                                 tr("Handles over the views; a click beside the data puts them away, too"),
                                 [&toolbox] { toolbox.setHandlesShown(!toolbox.handlesShown()); });
  handles->setCheckable(true);
  handles->setChecked(toolbox.handlesShown());
  connect(&toolbox, &Toolbox::handlesShownChanged, handles, &QAction::setChecked);
  connect(&mParts.selection, &Selection::cutChanged, &toolbox, [&toolbox] { toolbox.setHandlesShown(true); });
  connect(mPanel, &CutPanel::cutClicked, &toolbox, [&toolbox] { toolbox.setHandlesShown(true); });
  connect(&mParts.views.viewport(), &Viewport::clickedAt, &toolbox, [&toolbox](const render::Pick& pick) {
    if (!pick.hit) toolbox.setHandlesShown(false);
  });
}

void CutRoom::addShapes(QMenu* menu) {
  for (const auto& shape : session::allShapes())
    if (shape.menuText)
      mParts.actions.addForScene(menu, QString("cut.add%1").arg(shape.title), wordsOf(shape.menuText),
                                 tr("A third of the data in size, where it opens what you see"),
                                 [this, shape = shape.shape] { add([this, shape] { mPanel->addShape(shape); }); });
}

}  // namespace velum::gui
