#pragma once
#include <QDialog>

namespace velum::gui {

/// Chooses the theme, and says where preferences and keys are stored. Changes show at once.
class PreferencesDialog : public QDialog {
  Q_OBJECT
 public:
  explicit PreferencesDialog(QWidget* parent);
};

}  // namespace velum::gui
