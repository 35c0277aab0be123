#pragma once
#include <QTabWidget>

namespace velum::gui {

/// The side panel: a page for each part of the window that has a panel. A page scrolls where the window is too low for
/// it.
class SideTabs : public QTabWidget {
  Q_OBJECT
 public:
  explicit SideTabs(QWidget* parent);
  /// Adds a panel as a page. A panel with a list takes all of the page's height. @param title  for wordsOf()
  void addPage(QWidget* panel, const char* title, const QString& tip);
  /// A page that has nothing to say has no tab.
  void setPageShown(const QWidget* panel, bool shown);
  /// Brings the page of a panel to the front.
  void showPage(const QWidget* panel);
  /// Brings the page with a title, in English or as it is shown, to the front, whatever the title's case. @return false
  /// when no page has that title
  bool showPage(const QString& title);
};

}  // namespace velum::gui
