#pragma once
#include <QIcon>
#include <QString>
#include <functional>
#include <vector>

#include "gui/view/Room.h"

namespace velum::gui {

/// What the command finder finds: a command, a number of the side panel, a picture to choose, a structure, a type.
struct Findable {
  QString name;    ///< "Cut > Add plane": what it is in, and what it is.
  QString beside;  ///< Said quietly at the right: keys, or a number as it is now.
  QString tip;
  bool isOn = true;
  bool takesNumber = false;  ///< A number typed behind its name is handed over: "shadows 80".
  /// Does it. @param number  as typed; empty when none was
  std::function<void(const QString& number)> act;
  QIcon icon = {};
};

/// "Cut > Add plane": the menus on the way to a command, without mnemonics.
QString fullName(const QAction& action);
/// Each command of the table by the menus on the way to it.
std::vector<Findable> findCommands(const ActionTable& actions);
/// Commands; the numbers and pictures of pages that can be seen now, all presets, structures and types of the scene.
/// They hold until the window changes.
std::vector<Findable> findAll(const WindowParts& parts);

}  // namespace velum::gui
