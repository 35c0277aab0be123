#pragma once
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <vector>

#include "session/document/Recovery.h"

namespace velum::gui {

/// Offers the work of sessions that have died, one after the other. The bar waits for an answer and blocks nothing.
class RecoveryBar : public QFrame {
  Q_OBJECT
 public:
  explicit RecoveryBar(QWidget* parent);

  /// Offers work, and shows the bar when there is any. Of work that cannot be read the bar says where it lies, and why.
  void offer(std::vector<session::LostWork> work);
  /// The work that is offered now; null when nothing is offered.
  const session::LostWork* current() const { return mWork.empty() ? nullptr : &mWork.front(); }
  /// The current work is restored or given up: offers the next.
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
