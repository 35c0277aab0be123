#pragma once
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QStackedWidget>
#include <array>

#include "gui/kit/FloatingBars.h"
#include "gui/kit/Messages.h"
#include "gui/kit/SidePanel.h"
#include "gui/timeline/TimelineStrip.h"
#include "gui/view/Room.h"
#include "gui/view/TimeBar.h"
#include "gui/window/EmptyState.h"
#include "gui/window/RecoveryBar.h"
#include "gui/window/ToolStrip.h"

namespace velum::gui {

/// The frame of the window: menus, tool bar, the bars over the views, the side panel. The constructor builds them,
/// empty.
struct WindowFrame {
  WindowFrame(QMainWindow& window, session::Document& document, Player& player);

  /// Puts the views in the middle of the window, where the empty state is shown while nothing is open.
  void setViews(QWidget* views) { pages->addWidget(views); }
  /// Shows the views and the side panel; false: the empty state.
  void showViews(bool open);

  RecoveryBar* recovery;
  MessageBar* messages;
  FloatingBars* floating;  ///< these bars and others over the views
  QStackedWidget* pages;
  EmptyState* empty;
  TimeBar* time;
  TimelineStrip* timeline;
  ProgressStrip* progress;
  QDockWidget* dock;  ///< Holds the side panel; hidden while nothing is open.
  SidePanel* side;
  SideTabs* tabs;
  ToolStrip* bar;
  Menus menus;

 private:
  void buildSide(QMainWindow& window);
};

}  // namespace velum::gui
