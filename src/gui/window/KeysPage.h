#pragma once
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>

#include "gui/service/ActionTable.h"

namespace velum::gui {

/// Every command with its keys, which are changed here: choose a command, press the keys. Keys that another command has
/// are taken from that command, and the page says so.
class KeysPage : public QWidget {
  Q_OBJECT
 public:
  KeysPage(ActionTable& actions, QWidget* parent);

 private:
  void fill();
  void filter(const QString& words);
  void showChosen();
  void take(const QList<QKeySequence>& keys);
  QString chosen() const;

  ActionTable& mActions;
  QLineEdit* mWords;
  QTreeWidget* mTable;
  QKeySequenceEdit* mKeys;
  QPushButton *mClear, *mUsual;
  QLabel* mSaid;
};

}  // namespace velum::gui
