#pragma once
#include <QDialog>
#include <QFormLayout>

#include "gui/service/ActionTable.h"

namespace velum::gui {

/// What the user chooses for the program: appearance and units, mouse and wheel, keys, memory. Every choice takes
/// effect at once, or says when it does.
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
  void addVolumes(QWidget& page, QFormLayout& form);
};

}  // namespace velum::gui
