#include "gui/membrane/MembraneRoom.h"

#include "gui/service/SelectedCut.h"

namespace velum::gui {

MembraneRoom::MembraneRoom(const WindowParts& parts, MembraneForm& form)
    : Room(parts),
      mGrips(parts.document(), parts.selection, parts.toolbox, nullptr),
      mSketch(parts.document(), parts.selection, parts.toolbox, nullptr),
      mPin(HandTool::Kind::Pin, parts, mGrips),
      mPush(HandTool::Kind::Push, parts, mGrips),
      mPull(HandTool::Kind::Pull, parts, mGrips),
      mKeep(false, parts, mSketch),
      mAvoid(true, parts, mSketch),
      mProtect(false, parts),
      mLetThrough(true, parts),
      mKept(new KeptBar(parts.floating.host())) {
  parts.floating.addToBottom(*mKept);
  bindButtons(form);
  connect(&form.hands(), &SheetHandsForm::selectAsked, &mGrips, &SheetGrips::select);
  connect(&mGrips, &SheetGrips::selectedChanged, &form.hands(), &SheetHandsForm::showSelected);
  connect(&form, &MembraneForm::exportSheetAsked, this, &MembraneRoom::exportSheetAsked);
  connect(&form, &MembraneForm::exportClippedAsked, this, &MembraneRoom::exportClippedAsked);
  connectSketch(form.sketch());
  connectSheets(form);
}

void MembraneRoom::bindButtons(MembraneForm& form) {
  Toolbox& toolbox = mParts.toolbox;
  toolbox.bind(mPin, form.hands().pinButton());
  toolbox.bind(mPush, form.hands().pushButton());
  toolbox.bind(mPull, form.hands().pullButton());
  toolbox.bind(mKeep, form.sketch().keepButton());
  toolbox.bind(mAvoid, form.sketch().avoidButton());
  toolbox.bind(mProtect, form.protectButton());
  toolbox.bind(mLetThrough, form.letThroughButton());
}

void MembraneRoom::addManipulators() {
  mParts.toolbox.add(mSketch);
  mParts.toolbox.add(mGrips);
}

/// Connects the form to the sheets, and the sheets to the form.
void MembraneRoom::connectSheets(MembraneForm& form) {
  Viewport& viewport = mParts.views.viewport();
  Selection& selection = mParts.selection;
  auto tell = [this, &form, &selection] {
    const session::MembraneMover& sheets = mParts.session.membranes();
    if (selection.cut() != 0) form.showStatus(sheets.status(selection.cut()), sheets.isPlaying());
    showKept();
  };
  connect(&mParts.toolbox, &Toolbox::handlesShownChanged, this, &MembraneRoom::showKept);
  connect(mKept, &KeptBar::adviceTaken, this, &MembraneRoom::take);
  connect(&viewport, &Viewport::sheetsTold, &form, tell);
  connect(&selection, &Selection::cutChanged, &form, tell);
  connect(&form, &MembraneForm::playAsked, &viewport, &Viewport::playMembranes);
  connect(&form, &MembraneForm::stepAsked, &viewport, &Viewport::stepMembranes);
  connect(&form, &MembraneForm::flatAsked, &viewport,
          [&viewport, &selection] { viewport.resetMembrane(selection.cut()); });
}

/// Shows the bar of what is kept as long as the handles are over the views.
void MembraneRoom::showKept() {
  const scene::Cut* cut = selectedMembrane(mParts.document(), mParts.selection);
  auto status = cut ? mParts.session.membranes().status(cut->id) : std::nullopt;
  bool isSeen = status && cut->enabled && !scene::isInlay(*cut) && mParts.toolbox.handlesShown();
  if (isSeen) mKept->showStatus(*status, Length(mParts.document().shown()), membrane::attracts(cut->membrane->field));
  // Before the first measurement there is nothing to show.
  mKept->setVisible(isSeen && (status->isMeasured || mKept->isVisible()));
}

void MembraneRoom::take(const session::Advice& advice, const QString& label) {
  editSelectedCut(mParts.document(), mParts.selection, label.toStdString(), [&](scene::Cut& cut) {
    cut.centre = advice.cut.centre;
    cut.size = advice.cut.size;
    if (cut.membrane) cut.membrane->field = advice.cut.membrane->field;
  });
}

void MembraneRoom::connectSketch(SketchForm& form) {
  connect(&form, &SketchForm::radiusAsked, &mSketch, &Sketch::setRadius);
  connect(&form, &SketchForm::radiusSettled, &mSketch, &Sketch::settleRadius);
  connect(&form, &SketchForm::strokeSelected, &mSketch, &Sketch::select);
  connect(&form, &SketchForm::removeAsked, &mSketch, &Sketch::remove);
  connect(&mSketch, &Sketch::radiusChanged, &form, &SketchForm::showRadius);
  connect(&mSketch, &Sketch::selectedChanged, &form, &SketchForm::showSelected);
}

void MembraneRoom::addActions(QMenu* menu) {
  auto add = [&](Tool& tool, const char* id, const QString& text, const QString& tip) {
    mParts.toolbox.bind(tool, *mParts.actions.addForScene(menu, id, text, tip, [] {}));
  };
  add(mPin, "membrane.pin", tr("P&in the sheet"),
      tr("Click the sheet of the membrane and hold it there, or drag it on"));
  add(mPush, "membrane.push", tr("P&ush sheet"),
      tr("Drag a ball in a section, or click in the picture: the sheet goes around it"));
  add(mPull, "membrane.pull", tr("Pu&ll sheet"),
      tr("Drag a ball in a section, or click in the picture: the sheet is drawn to its middle"));
}

}  // namespace velum::gui
