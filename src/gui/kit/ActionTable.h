#pragma once
#include <QAction>
#include <QHash>
#include <QMenu>
#include <QObject>
#include <functional>

namespace velum::gui {

/// Every command of the window by its id ("cut.addPlane"): what menus, tool bar, keys, the command finder and scripts
/// trigger. Shortcuts are data: resources/keys.json, over which the user's own keys.json in the configuration folder
/// goes.
class ActionTable : public QObject {
  Q_OBJECT
 public:
  explicit ActionTable(QWidget* window);

  /// Adds a command to a menu. @param tip  one line, in the imperative; the shortcut is added to it
  QAction* add(QMenu* menu, const QString& id, const QString& text, const QString& tip, std::function<void()> slot);
  /// The same, only while something is open.
  QAction* addForScene(QMenu* menu, const QString& id, const QString& text, const QString& tip,
                       std::function<void()> slot);
  /// Null for an unknown id.
  QAction* find(const QString& id) const { return mActions.value(id); }
  /// In the order in which they were added.
  const QList<QAction*>& all() const { return mOrder; }
  /// Enables the commands that need something open.
  void setSceneOpen(bool open);
  /// What is wrong with the user's keys.json; empty when nothing is.
  QString warning() const { return mWarning; }

 private:
  void readKeys(const QString& path);

  QWidget* mWindow;
  QHash<QString, QAction*> mActions;
  QHash<QString, QList<QKeySequence>> mKeys;
  QList<QAction*> mOrder, mNeedScene;
  QString mWarning;
};

}  // namespace velum::gui
