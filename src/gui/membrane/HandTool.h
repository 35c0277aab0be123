#pragma once
#include "gui/membrane/SheetGrips.h"
#include "gui/view/Room.h"

namespace velum::gui {

/// Puts a pin or a kernel on the selected membrane's sheet; the drag that follows the press moves or resizes it. The
/// tool ends with one pin or kernel; with Shift held it stays for more.
class HandTool : public Tool {
  Q_OBJECT
 public:
  enum class Kind { Pin, Push, Pull };

  HandTool(Kind kind, const WindowParts& parts, SheetGrips& grips);

  /// Selects a membrane where none is selected.
  bool start() override;
  void stop() override;
  bool press(const PointerEvent& event) override;
  void drag(const PointerEvent& event) override { mGrips.drag(event); }
  void release(const PointerEvent& event) override;

 private:
  std::optional<session::SheetPoint> sheetUnder(const ViewPoint& at) const;
  bool putPin(const PointerEvent& event);
  bool putKernel(const PointerEvent& event);

  Kind mKind;
  session::Document& mDocument;
  Selection& mSelection;
  const session::MembraneMover& mSheets;
  SheetGrips& mGrips;
  Toolbox& mToolbox;
  MessageBar& mMessages;
  bool mHasPut = false;  ///< This press has put a pin or a kernel.
};

}  // namespace velum::gui
