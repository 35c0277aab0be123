#pragma once
#include <QTimer>
#include <memory>

#include "kit/Bars.h"
#include "kit/Job.h"
#include "velum/session/Session.h"

namespace velum::gui {

/// Says over the views when cuts leave nothing of what the scene shows, as soon as the hand pauses; takes it back when
/// they leave something again. Looks in a thread.
class NothingLeftNote : public QObject {
  Q_OBJECT
 public:
  NothingLeftNote(session::Session& session, MessageBar& messages, QObject* parent);
  ~NothingLeftNote() override;
  /// After every change.
  void refresh();

 private:
  void look();
  void tell(bool isNothingLeft);

  session::Session& mSession;
  MessageBar& mMessages;
  QTimer mPause;
  std::unique_ptr<Job> mJob;
  scene::Scene mLooked;  ///< What was last looked at, or will be.
};

}  // namespace velum::gui
