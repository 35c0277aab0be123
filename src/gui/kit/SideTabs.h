#pragma once
#include <QTabWidget>

namespace velum::gui {

/// The side panel: a page for each part of the window that has one, which scrolls where the window is low.
class SideTabs : public QTabWidget {
  Q_OBJECT
 public:
  explicit SideTabs(QWidget* parent);
  /// A panel with a list takes all of the height.
  void addPage(QWidget* panel, const QString& title, const QString& tip);
  /// A page that has nothing to say has no tab.
  void setPageShown(const QWidget* panel, bool shown);
  /// Brings the page of a panel to the front.
  void showPage(const QWidget* panel);
  /// The same by its title, whatever the case; false when there is none.
  bool showPage(const QString& title);
};

}  // namespace velum::gui
