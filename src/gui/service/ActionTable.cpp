#include "gui/service/ActionTable.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QWidget>

#include "gui/kit/Icons.h"
#include "gui/kit/Preferences.h"

namespace velum::gui {

ActionTable::ActionTable(QWidget* window) : QObject(window), mWindow(window) {
  readKeys(":/velum/keys.json");
  mUsual = mKeys;
  readKeys(Preferences::keysPath());
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
  action->setIcon(makeIcon(id.section('.', 0, 1)));
  action->setStatusTip(tip);
  showKeys(action);
  connect(action, &QAction::triggered, mWindow, [slot = std::move(slot)] { slot(); });
  mActions.insert(id, action);
  mOrder << action;
  return action;
}

void ActionTable::showKeys(QAction* action) {
  action->setShortcuts(mKeys.value(action->objectName()));
  QString keys = action->shortcut().toString(QKeySequence::NativeText), tip = action->statusTip();
  action->setToolTip(keys.isEmpty() ? tip : QString("%1 (%2)").arg(tip, keys));
}

void ActionTable::rename(QAction* action, const QString& text, const QString& tip) {
  if (action->text() == text && action->statusTip() == tip) return;
  action->setText(text);
  action->setStatusTip(tip);
  showKeys(action);
}

QAction* ActionTable::withKey(const QKeySequence& key) const {
  for (QAction* action : mOrder)
    if (mKeys.value(action->objectName()).contains(key)) return action;
  return nullptr;
}

QString ActionTable::setKeys(const QString& id, const QList<QKeySequence>& keys) {
  for (const QKeySequence& key : keys)
    if (QAction* before = withKey(key); before && before->objectName() != id) {
      mKeys[before->objectName()].removeAll(key);
      showKeys(before);
    }
  mKeys[id] = keys;
  if (QAction* action = find(id)) showKeys(action);
  return writeOwnKeys();
}

/// What differs from the usual keys.
QString ActionTable::writeOwnKeys() const {
  QJsonObject table;
  for (auto row = mKeys.begin(); row != mKeys.end(); ++row) {
    if (row.value() == mUsual.value(row.key())) continue;
    QJsonArray keys;
    for (const QKeySequence& key : row.value()) keys << key.toString(QKeySequence::PortableText);
    table.insert(row.key(), keys);
  }
  QDir().mkpath(Preferences::folder());
  QSaveFile file(Preferences::keysPath());
  QByteArray text = QJsonDocument(table).toJson();
  bool isWritten = file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit();
  return isWritten ? QString() : tr("%1: %2; the keys hold until Velum ends").arg(file.fileName(), file.errorString());
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
