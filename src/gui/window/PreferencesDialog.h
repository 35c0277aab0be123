#pragma once
#include <QDialog>
#include <QFormLayout>

#include "gui/service/ActionTable.h"

namespace velum::gui {

/// What the user chooses for the program: appearance and units, mouse and wheel, keys, memory. Everything counts at
/// once, but memory, which counts from the next start on.
class PreferencesDialog : public QDialog {
  Q_OBJECT
 public:
  PreferencesDialog(ActionTable& actions, QWidget* parent);

 signals:
  /// How things are shown has changed.
  void changed();

 private:
  QWidget* makeGeneral();
  QWidget* makeHand();
  QWidget* makeMemory();
};

}  // namespace velum::gui
