#pragma once
#include "gui/kit/Messages.h"
#include "gui/tool/Toolbox.h"
#include "session/document/Document.h"

namespace velum::gui {

/// A click in any view shows the tissue there; with Shift in addition to what is shown already; with Ctrl the tissue is
/// hidden. The tool stays active until it is laid down.
class ShowThisTool : public ClickTool {
  Q_OBJECT
 public:
  ShowThisTool(session::Document& document, MessageBar& messages, QObject* parent)
      : ClickTool(parent), mDocument(document), mMessages(messages) {}

  void click(const PointerEvent& event) override;

 private:
  session::Document& mDocument;
  MessageBar& mMessages;
};

}  // namespace velum::gui
