#pragma once
#include "gui/kit/Messages.h"
#include "gui/service/NewestJob.h"
#include "session/Session.h"

namespace velum::gui {

/// Shows a note over the views when cuts leave nothing of what the scene shows, as soon as the user pauses; takes the
/// note back when the cuts leave something again. The check runs in a thread of its own.
class NothingLeftNote : public QObject {
  Q_OBJECT
 public:
  NothingLeftNote(session::Session& session, MessageBar& messages, QObject* parent);
  /// To be called after every change of the session.
  void refresh();

 private:
  void tell(bool isNothingLeft);

  session::Session& mSession;
  MessageBar& mMessages;
  NewestJob mLook;
  scene::Scene mLooked;  ///< The scene that was checked last, or will be next.
};

}  // namespace velum::gui
