#pragma once
#include "gui/kit/Messages.h"
#include "gui/service/NewestJob.h"
#include "session/Session.h"

namespace velum::gui {

/// Says over the views when cuts leave nothing of what the scene shows, as soon as the hand pauses; takes it back when
/// they leave something again. Looks in a thread.
class NothingLeftNote : public QObject {
  Q_OBJECT
 public:
  NothingLeftNote(session::Session& session, MessageBar& messages, QObject* parent);
  /// After every change.
  void refresh();

 private:
  void tell(bool isNothingLeft);

  session::Session& mSession;
  MessageBar& mMessages;
  NewestJob mLook;
  scene::Scene mLooked;  ///< What was last looked at, or will be.
};

}  // namespace velum::gui
