#pragma once
#include "gui/membrane/BrushTool.h"
#include "gui/membrane/HandTool.h"
#include "gui/membrane/KeptBar.h"
#include "gui/membrane/MembraneForm.h"
#include "gui/membrane/ProtectTool.h"
#include "gui/membrane/SheetGrips.h"
#include "gui/membrane/Sketch.h"
#include "gui/view/Room.h"

namespace velum::gui {

/// What can be done with the selected membrane: the tools of its form, the pins, kernels and strokes in the views, its
/// commands. It is a part of the room of cuts, whose panel holds the form.
class MembraneRoom : public Room {
  Q_OBJECT
 public:
  MembraneRoom(const WindowParts& parts, MembraneForm& form);
  void addActions(QMenu* menu);
  /// Adds pins, kernels and strokes to the toolbox, over the manipulators that are there already.
  void addManipulators();
  Sketch& sketch() { return mSketch; }
  void refresh(const session::Session&) override { showKept(); }

 signals:
  void exportSheetAsked();
  void exportClippedAsked();

 private:
  void bindButtons(MembraneForm& form);
  void connectSheets(MembraneForm& form);
  void connectSketch(SketchForm& form);
  void showKept();
  void take(const session::Advice& advice, const QString& label);

  SheetGrips mGrips;
  Sketch mSketch;
  HandTool mPin, mPush, mPull;
  BrushTool mKeep, mAvoid;
  ProtectTool mProtect, mLetThrough;
  KeptBar* mKept;
};

}  // namespace velum::gui
