#pragma once
#include <QComboBox>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>

#include "session/membrane/MembraneEdit.h"

namespace velum::gui {

/// The structures and types that a membrane keeps whole, or that draw its sheet, each with its force; below them a list
/// from which another one is added. The table changes no data itself: it asks by signals.
class StrengthTable : public QWidget {
  Q_OBJECT
 public:
  explicit StrengthTable(QWidget* parent);
  /// @param rows  all that can be protected; where there is nothing the table hides
  void showRows(const std::vector<session::Protectable>& rows);

 signals:
  /// @param strength  0 takes it off
  void strengthAsked(const velum::session::Protectable& what, double strength);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fill();
  void removeSelected();

  QTableWidget* mTable;
  QComboBox* mAdd;
  QPushButton* mRemove;
  std::vector<session::Protectable> mRows;
};

}  // namespace velum::gui
