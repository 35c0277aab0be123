#pragma once
#include <QActionGroup>
#include <QBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <vector>

#include "gui/rows/RowPaint.h"

/// What stands around the list of a page: above the list an eye and a name, a search field and a menu of orders; below
/// the list buttons and a number.
namespace velum::gui {

constexpr int kListFieldHeight = 28;

/// Without margins. @param spacing  pixels
QVBoxLayout* makeColumn(QWidget* widget, int spacing);
/// A button without a frame.
QPushButton* makeQuiet(const QString& text, const char* name, const QString& tip, QWidget* parent);

/// The name of the listed things, and an eye that shows or hides all of them. Widgets that are added to the row stand
/// to the right.
struct ListHead {
  QHBoxLayout* row = nullptr;
  QLabel* name = nullptr;
  EyeButton* shown = nullptr;
};
/// @param eyeName, eyeTitle  names of the eye, for tests and for screen readers
ListHead makeListHead(const char* eyeName, const QString& eyeTitle, const QString& tip, QWidget* parent);

/// A field to search in, and a menu of orders.
struct ListSearch {
  QHBoxLayout* row = nullptr;
  QLineEdit* field = nullptr;
  QToolButton* sort = nullptr;
  QMenu* menu = nullptr;

  /// Adds a switch between the search field and the menu's button.
  QToolButton* addSwitch(const char* name, const QString& text, const QString& tip) const;
  /// Adds one of a group of choices to the menu. @param isFirst  this choice is chosen at first
  QAction* addChoice(QActionGroup* group, const QString& text, bool isFirst) const;
};
/// @param name  as in "modelSearch" and "modelSort"
ListSearch makeListSearch(const QString& name, QWidget* bar);

/// @return the number on the right, whose text says how many are shown
QLabel* makeListFoot(const std::vector<QPushButton*>& buttons, const QString& tip, QWidget* foot);

}  // namespace velum::gui
