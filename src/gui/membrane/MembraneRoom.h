#pragma once
#include "BrushTool.h"
#include "HandTool.h"
#include "KeptBar.h"
#include "MembraneForm.h"
#include "ProtectTool.h"
#include "SheetGrips.h"
#include "Sketch.h"
#include "view/Room.h"

namespace velum::gui {

/// What there is to do with the selected membrane: the tools of its form, what stands on it in the views, its commands.
/// A part of the room of cuts, whose panel holds the form.
class MembraneRoom : public Room {
  Q_OBJECT
 public:
  MembraneRoom(const WindowParts& parts, MembraneForm& form);
  void addActions(QMenu* menu);
  /// Over what is in the toolbox already.
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
