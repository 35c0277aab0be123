#pragma once
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <vector>

#include "session/document/Recovery.h"

namespace velum::gui {

/// Offers the work of sessions that have died, one after the other; it waits and stops nothing.
class RecoveryBar : public QFrame {
  Q_OBJECT
 public:
  explicit RecoveryBar(QWidget* parent);

  /// Also work that cannot be read: where it lies, and why. Shows itself when there is some.
  void offer(std::vector<session::LostWork> work);
  /// Null when nothing is offered.
  const session::LostWork* current() const { return mWork.empty() ? nullptr : &mWork.front(); }
  /// The current one is settled, one way or the other: shows the next.
  void next();

 signals:
  void restoreWanted();
  void discardWanted();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void elide();
  QPushButton* addButton(const QString& text, const QString& tip, const char* role);
  void refresh();

  std::vector<session::LostWork> mWork;
  QLabel *mTitle, *mText;
  QString mWholeTitle, mWholeText;
  QPushButton *mRestore = nullptr, *mLater = nullptr;
};

}  // namespace velum::gui
