#pragma once
#include <QFrame>
#include <QLayout>

namespace velum::gui {

class RecentRow;

/// What the window shows before there is data: samples of what the program is for, the files that it opens and the ways
/// to open them, and the recent files. It scrolls when it is higher than the window.
class EmptyState : public QFrame {
  Q_OBJECT
 public:
  explicit EmptyState(QWidget* parent);
  RecentRow* recent() const { return mRecent; }

 signals:
  void openFiles();
  void openFolder();
  /// One of the program's own scenes is to be opened, by its name.
  void openSample(const QString& name);

 private:
  void addSamples(QLayout* layout);
  void addWays(QLayout* layout);
  RecentRow* mRecent;
};

}  // namespace velum::gui
