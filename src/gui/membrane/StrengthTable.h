#pragma once
#include <QComboBox>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>

#include "scene/Membrane.h"
#include "scene/Structure.h"

namespace velum::gui {

/// The structures that a membrane keeps whole, or that draw its sheet, each with its force; below them a list from
/// which another structure is added. The table changes no data itself: it asks by signals.
class StrengthTable : public QWidget {
  Q_OBJECT
 public:
  explicit StrengthTable(QWidget* parent);
  /// @param structures  all of the scene's structures; where there are none the table hides
  void showStrengths(const std::vector<scene::Structure>& structures,
                     const std::vector<scene::LabelStrength>& strengths);

 signals:
  /// @param strength  0 takes the structure off
  void strengthAsked(int id, double strength);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fill();
  void removeSelected();

  QTableWidget* mTable;
  QComboBox* mAdd;
  QPushButton* mRemove;
  std::vector<scene::Structure> mStructures;
  std::vector<scene::LabelStrength> mStrengths;
};

}  // namespace velum::gui
