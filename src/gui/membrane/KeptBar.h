#pragma once
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <optional>
#include <vector>

#include "gui/kit/Length.h"
#include "session/membrane/MembraneMover.h"

namespace velum::gui {

/// A bar over the views: how much of the tissue that the selected membrane protects is kept whole, and, where that is
/// too little, buttons with advice.
class KeptBar : public QFrame {
  Q_OBJECT
 public:
  explicit KeptBar(QWidget* parent);
  /// The shares that were measured last stay, paler, until new ones are there, so that nothing flickers during a drag.
  /// @param attracts  a force draws the sheet towards something
  void showStatus(const session::MembraneStatus& status, const Length& length, bool attracts);

 signals:
  /// @param label  of the button
  void adviceTaken(const session::Advice& advice, const QString& label);

 private:
  static constexpr int kMostAdvice = 2;
  void showAdvice(const std::vector<session::Advice>& advice, const Length& length);
  QLabel* mText;
  QPushButton* mButtons[kMostAdvice];
  std::vector<session::Advice> mAdvice;  ///< for each button that is shown
};

}  // namespace velum::gui
