#pragma once
#include <QAction>
#include <QHash>
#include <QMenu>
#include <QObject>
#include <functional>

namespace velum::gui {

/// Every command of the window by its id ("cut.addPlane"): menus, tool bar, keys, the command finder and scripts
/// trigger these. The first two parts of an id name the command's icon in resources/icons. Shortcuts are data:
/// resources/keys.json has the usual ones, and the user's own keys.json in the configuration folder takes precedence.
class ActionTable : public QObject {
  Q_OBJECT
 public:
  explicit ActionTable(QWidget* window);

  /// Adds a command to a menu. @param tip  one line, in the imperative; the shortcut is added to it
  QAction* add(QMenu* menu, const QString& id, const QString& text, const QString& tip, std::function<void()> slot);
  /// Adds a command that is enabled only while something is open.
  QAction* addForScene(QMenu* menu, const QString& id, const QString& text, const QString& tip,
                       std::function<void()> slot);
  /// Says what a command does in other words, where these depend on what is open.
  void rename(QAction* action, const QString& text, const QString& tip);
  /// Null for an unknown id.
  QAction* find(const QString& id) const { return mActions.value(id); }
  /// All commands in the order in which they were added.
  const QList<QAction*>& all() const { return mOrder; }
  /// Enables the commands that need something open.
  void setSceneOpen(bool open);
  /// The keys that a command has without the user's own.
  QList<QKeySequence> usualKeys(const QString& id) const { return mUsual.value(id); }
  /// Gives a command keys, takes these keys from other commands, and writes the user's keys.json. @return what went
  /// wrong with the file, one line; empty when nothing did
  QString setKeys(const QString& id, const QList<QKeySequence>& keys);
  /// The command that has a key; null when no command has it.
  QAction* withKey(const QKeySequence& key) const;
  /// What is wrong with the user's keys.json; empty when nothing is.
  QString warning() const { return mWarning; }

 private:
  void readKeys(const QString& path);
  void showKeys(QAction* action);
  QString writeOwnKeys() const;

  QWidget* mWindow;
  QHash<QString, QAction*> mActions;
  /// By id: the keys in force, and the keys without the user's own.
  QHash<QString, QList<QKeySequence>> mKeys, mUsual;
  QList<QAction*> mOrder, mNeedScene;
  QString mWarning;
};

}  // namespace velum::gui
