#pragma once
#include <QLabel>
#include <QWidget>
#include <optional>

#include "session/Session.h"

namespace velum::gui {

/// Offers what to do when a structure that grows is about to flow into another; hidden while no structure does.
class LeakBox : public QWidget {
  Q_OBJECT
 public:
  LeakBox(session::Session& session, QWidget* parent);
  void refresh();

 signals:
  /// In words, once for each leak: why a structure's growth is held.
  void held(const QString& why);
  /// The user is going to show which parts do not belong to a structure.
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
