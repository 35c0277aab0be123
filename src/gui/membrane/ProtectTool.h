#pragma once
#include "gui/view/Room.h"

namespace velum::gui {

/// One click in any view says what the selected membrane is to keep whole, or what its sheet may pass through: a
/// structure where labels are shown, else tissue by its values. With Shift the tool stays active for the next click.
class ProtectTool : public ClickTool {
  Q_OBJECT
 public:
  ProtectTool(bool letThrough, const WindowParts& parts);

  bool start() override;
  void click(const PointerEvent& event) override;

 private:
  bool mLetThrough;
  session::Document& mDocument;
  Selection& mSelection;
  Toolbox& mToolbox;
  MessageBar& mMessages;
};

}  // namespace velum::gui
