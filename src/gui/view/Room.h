#pragma once
#include <QMenu>
#include <array>

#include "gui/kit/FloatingBars.h"
#include "gui/kit/Messages.h"
#include "gui/kit/SidePanel.h"
#include "gui/service/ActionTable.h"
#include "gui/service/JobRunner.h"
#include "gui/service/Player.h"
#include "gui/service/Selection.h"
#include "gui/tool/Toolbox.h"
#include "gui/view/ViewGrid.h"
#include "session/Session.h"

namespace velum::gui {

/// The menus of the window, in their order.
enum class MenuId { File, Edit, View, Look, Cut, Structures, Mark, Time, Film, Help };
using Menus = std::array<QMenu*, std::size_t(MenuId::Help) + 1>;  ///< By MenuId.

/// The window as its rooms see it: the places into which rooms build their parts, and the objects that they work with.
/// Must live as long as the rooms.
struct WindowParts {
  QWidget& window;
  session::Session& session;
  Selection& selection;
  Toolbox& toolbox;
  ViewGrid& views;
  MessageBar& messages;
  FloatingBars& floating;
  JobRunner& jobs;
  Player& player;
  ActionTable& actions;
  SideTabs& tabs;
  SidePanel& side;  ///< holds the tabs
  Menus menus;

  QMenu* menu(MenuId id) const { return menus[std::size_t(id)]; }
  session::Document& document() const { return session.document(); }
};

/// A part of the window with all that belongs to it: a page of the side panel, menu entries and their actions, tools. A
/// room builds these in its constructor. The window makes the rooms, and tells them of every change.
class Room : public QObject {
  Q_OBJECT
 public:
  explicit Room(const WindowParts& parts) : QObject(&parts.window), mParts(parts) {}
  /// Shows the session as it is now.
  virtual void refresh(const session::Session&) {}

 protected:
  const WindowParts& mParts;
};

}  // namespace velum::gui
