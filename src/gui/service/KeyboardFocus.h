#pragma once
#include <QObject>
#include <QPointer>
#include <QWidget>
#include <functional>

namespace velum::gui {

/// What the keyboard needs beyond Qt, for a window and its dialogs: a ring round what has the keyboard, while it is
/// used; the keys of a control before commands of the window that have the same; Esc from a panel back to the views.
class KeyboardFocus : public QObject {
  Q_OBJECT
 public:
  /// @param home  the view that Esc goes to; null: none is shown
  KeyboardFocus(QWidget& window, std::function<QWidget*()> home);
  /// What the ring is round, null without one.
  QWidget* marked() const { return mTarget; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool isOurs(const QWidget* widget) const;
  void focusCame(QWidget* widget, Qt::FocusReason reason);
  void focusWent(QWidget* widget, Qt::FocusReason reason);
  bool goHome(QObject* watched);
  void mark(QWidget* target);
  void placeRing();

  QWidget& mWindow;
  std::function<QWidget*()> mHome;
  QPointer<QWidget> mTarget, mRing;
  bool mLastWasKey = false;  ///< and not the mouse
};

}  // namespace velum::gui
