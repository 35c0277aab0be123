#pragma once
#include <QLabel>
#include <QWidget>

#include "velum/session/Session.h"

namespace velum::gui {

/// What to do where a structure is about to flow into another; hidden while none is.
class LeakBox : public QWidget {
  Q_OBJECT
 public:
  LeakBox(session::Session& session, QWidget* parent);
  void refresh();

 private:
  void goOn();

  session::Session& mSession;
  QLabel* mText;
};

}  // namespace velum::gui
