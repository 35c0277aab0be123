#pragma once
#include <QFrame>
#include <QLayout>

namespace velum::gui {

class RecentRow;

/// What the window shows before there is data: samples of what the program is for, what it takes and how, and the
/// recent files. What is higher than the window scrolls.
class EmptyState : public QFrame {
  Q_OBJECT
 public:
  explicit EmptyState(QWidget* parent);
  RecentRow* recent() const { return mRecent; }

 signals:
  void openFiles();
  void openFolder();
  /// A scene of the program's own, by its name.
  void openSample(const QString& name);

 private:
  void addSamples(QLayout* layout);
  void addWays(QLayout* layout);
  RecentRow* mRecent;
};

}  // namespace velum::gui
