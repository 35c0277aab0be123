#pragma once
#include <QDialog>
#include <QFormLayout>

#include "gui/service/ActionTable.h"

namespace velum::gui {

/// What the user chooses for the program: appearance and units, mouse and wheel, keys, memory. Every choice takes
/// effect at once, but that of memory, which takes effect at the next start.
class PreferencesDialog : public QDialog {
  Q_OBJECT
 public:
  PreferencesDialog(ActionTable& actions, QWidget* parent);

 signals:
  /// A preference has changed that decides how things are shown.
  void changed();

 private:
  QWidget* makeGeneral();
  QWidget* makeHand();
  QWidget* makeMemory();
};

}  // namespace velum::gui
