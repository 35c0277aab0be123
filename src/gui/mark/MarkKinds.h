#pragma once
#include <span>

#include "scene/Mark.h"

namespace velum::gui {

/// A kind of mark as the window shows it.
struct MarkKindRow {
  scene::MarkKind kind;
  const char* id;    ///< of the command that takes up its tool, and of its icon; null: it has no tool
  const char* menu;  ///< title of the command, with its letter
  const char* tip;
  const char* sign;  ///< for paintIcon(): lines in a square from -8 to 8, y down
};

/// One row for each kind, in the order of MarkKind.
std::span<const MarkKindRow> markKinds();
const MarkKindRow& rowOf(scene::MarkKind kind);

}  // namespace velum::gui
