#include "ActionTable.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QWidget>

#include "Preferences.h"

namespace velum::gui {

ActionTable::ActionTable(QWidget* window) : QObject(window), mWindow(window) {
  readKeys(":/velum/keys.json");
  readKeys(Preferences::folder() + "/keys.json");
}

/// An object of id: list of key sequences; an empty list takes a key away.
void ActionTable::readKeys(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return;
  QJsonParseError error;
  QJsonDocument document = QJsonDocument::fromJson(file.readAll(), &error);
  if (!document.isObject()) {
    mWarning = tr("%1: %2; the usual keys are in force").arg(path, error.errorString());
    return;
  }
  QJsonObject table = document.object();
  for (auto row = table.begin(); row != table.end(); ++row) {
    QList<QKeySequence> keys;
    for (const auto& key : row.value().toArray()) keys << QKeySequence(key.toString(), QKeySequence::PortableText);
    mKeys.insert(row.key(), keys);
  }
}

QAction* ActionTable::add(QMenu* menu, const QString& id, const QString& text, const QString& tip,
                          std::function<void()> slot) {
  QAction* action = menu->addAction(text);
  action->setObjectName(id);
  action->setShortcuts(mKeys.value(id));
  QString keys = action->shortcut().toString(QKeySequence::NativeText);
  action->setToolTip(keys.isEmpty() ? tip : QString("%1 (%2)").arg(tip, keys));
  action->setStatusTip(tip);
  connect(action, &QAction::triggered, mWindow, [slot = std::move(slot)] { slot(); });
  mActions.insert(id, action);
  mOrder << action;
  return action;
}

QAction* ActionTable::addForScene(QMenu* menu, const QString& id, const QString& text, const QString& tip,
                                  std::function<void()> slot) {
  QAction* action = add(menu, id, text, tip, std::move(slot));
  mNeedScene << action;
  return action;
}

void ActionTable::setSceneOpen(bool open) {
  for (QAction* action : mNeedScene) action->setEnabled(open);
}

}  // namespace velum::gui
