#pragma once
#include <QIcon>
#include <QString>
#include <functional>
#include <vector>

#include "gui/view/Room.h"

namespace velum::gui {

/// One thing that the command finder finds: a command, a number of the side panel, a picture to choose, a structure, a
/// type.
struct Findable {
  QString name;    ///< "Cut > Add plane": the menu or page, and the name in it.
  QString beside;  ///< Shown less prominently at the right: the command's keys, or the number's present value.
  QString tip;
  bool isOn = true;
  bool takesNumber = false;  ///< A number typed behind its name is handed over: "shadows 80".
  /// Runs the command, or goes to the thing that was found. @param number  as typed; empty when none was typed
  std::function<void(const QString& number)> act;
  QIcon icon = {};
};

/// "Cut > Add plane": the menus on the way to a command, without mnemonics.
QString fullName(const QAction& action);
/// Each command of the table by the menus on the way to it.
std::vector<Findable> findCommands(const ActionTable& actions);
/// Commands; the numbers and pictures of pages that can be seen now, all presets, structures and types of the scene.
/// The entries are valid until the window changes.
std::vector<Findable> findAll(const WindowParts& parts);

}  // namespace velum::gui
