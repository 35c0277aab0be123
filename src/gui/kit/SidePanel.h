#pragma once
#include <QWidget>

#include "gui/kit/SideTabs.h"

namespace velum::gui {

/// The panel beside the views: its pages, and at its left edge a handle by which it is made wider. Nobody else sets its
/// width. It is at least as wide as its pages need, and at most half of the window; a width that the user has chosen is
/// kept for all windows, and stands until a double click on the handle.
class SidePanel : public QWidget {
  Q_OBJECT
 public:
  static constexpr int kLeast = 348;  ///< pixels
  /// @param window  that holds the panel
  SidePanel(QWidget& window, QWidget* parent);
  SideTabs& tabs() { return *mTabs; }
  /// What is open wants more room than other data does, where the window is wide and the user has chosen no width.
  void setRoomy(bool isRoomy);
  /// Chooses a width. @param pixels  0: the width that suits what is open
  void choose(int pixels);
  int chosen() const { return mChosen; }
  /// Keeps what was chosen for the next start.
  void keep() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();

  QWidget& mWindow;
  SideTabs* mTabs;
  QWidget* mHandle;
  int mChosen = 0;
  bool mIsRoomy = false;
};

}  // namespace velum::gui
