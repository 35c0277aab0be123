#pragma once
#include <QObject>
#include <QPointer>
#include <QWidget>
#include <functional>

namespace velum::gui {

/// What the keyboard needs beyond Qt, for a window and its dialogs: a ring round the widget that has the keyboard,
/// while the keyboard is used; the keys of a control go before commands of the window that have the same keys; Esc
/// leads from a panel back to the views.
class KeyboardFocus : public QObject {
  Q_OBJECT
 public:
  /// @param home  the view that Esc goes to; null: no view is shown
  KeyboardFocus(QWidget& window, std::function<QWidget*()> home);
  /// The widget that the ring is round; null while there is no ring.
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
  bool mLastWasKey = false;  ///< the keyboard was used last, not the mouse
};

}  // namespace velum::gui
