#pragma once
#include <QLabel>
#include <QWidget>
#include <optional>

#include "session/Session.h"

namespace velum::gui {

/// What to do where a structure is about to flow into another; hidden while none is.
class LeakBox : public QWidget {
  Q_OBJECT
 public:
  LeakBox(session::Session& session, QWidget* parent);
  void refresh();

 signals:
  /// In words, once: why something is held.
  void held(const QString& why);
  /// The user is going to show what is not of a structure.
  void notThisAsked(int structure);

 private:
  void goOn();
  QString textOf(const session::Leak& leak) const;
  QString saidOf(const session::Leak& leak) const;

  session::Session& mSession;
  QLabel* mText;
  std::optional<session::Leak> mSaid;
};

}  // namespace velum::gui
