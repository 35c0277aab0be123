#pragma once
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <optional>
#include <vector>

#include "gui/kit/Length.h"
#include "session/membrane/MembraneMover.h"

namespace velum::gui {

/// Over the views: what becomes of what the selected membrane protects, and, where too little of it is kept, what
/// helps.
class KeptBar : public QFrame {
  Q_OBJECT
 public:
  explicit KeptBar(QWidget* parent);
  /// What was last measured stays, paler, until there is something new, so that nothing flickers while one drags.
  /// @param attracts  something draws the sheet
  void showStatus(const session::MembraneStatus& status, const Length& length, bool attracts);

 signals:
  /// @param label  of the button
  void adviceTaken(const session::Advice& advice, const QString& label);

 private:
  static constexpr int kMostAdvice = 2;
  void showAdvice(const std::vector<session::Advice>& advice, const Length& length);
  QLabel* mText;
  QPushButton* mButtons[kMostAdvice];
  std::vector<session::Advice> mAdvice;  ///< of each button that is shown
};

}  // namespace velum::gui
