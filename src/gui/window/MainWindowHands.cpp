// The main window's wiring of a membrane's pins and kernels.
#include "MainWindow.h"
#include "cut/CutPanel.h"
#include "membrane/ProtectTool.h"
#include "membrane/SheetTool.h"
#include "membrane/SketchTool.h"

namespace velum::gui {

/// One tool at a time has the pointer: whichever is taken up lays the others down.
void MainWindow::buildHands() {
  MembraneForm& form = mCuts->membraneForm();
  SheetHandsForm& panel = form.hands();
  mSheetTool = new SheetTool(mDocument, *mViews, *mSelection, *mMessages, this);
  connect(&panel, &SheetHandsForm::modeAsked, mSheetTool, &SheetTool::start);
  connect(&panel, &SheetHandsForm::selectAsked, mSheetTool, &SheetTool::select);
  connect(mSheetTool, &SheetTool::selectedChanged, &panel, &SheetHandsForm::showSelected);
  connect(mSheetTool, &SheetTool::modeChanged, &panel, [this, &panel](SheetTool::Mode mode) {
    panel.showMode(mode);
    if (mode == SheetTool::Mode::None) return;
    mProtect->stop();
    mSketch->stop();
    mViews->setPointing(true);
  });
  connect(&form, &MembraneForm::protectAsked, mSheetTool, [this](bool on) {
    if (!on) return;
    mSheetTool->stop();
    mViews->setPointing(true);
  });
  connect(&form.sketch(), &SketchForm::brushAsked, mSheetTool, [this](bool on) {
    if (!on) return;
    mSheetTool->stop();
    mViewport->setPointing(mSketch->isActive());
  });
}

}  // namespace velum::gui
