#pragma once
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTimer>

#include "session/document/Document.h"

namespace velum::gui {

/// The time steps of a series: a slider, and play. Hidden for data without time. While playing, the next step is shown
/// only when the views have drawn the one before, so that no step is left out on a slow machine.
class TimeBar : public QFrame {
  Q_OBJECT
 public:
  TimeBar(session::Document& document, QWidget* parent);
  void refresh();
  /// Hides the bar while a film says which step is seen.
  void setReplaced(bool replaced) { mIsReplaced = replaced; }
  void setPlaying(bool playing);
  bool isPlaying() const { return mTimer.isActive(); }
  /// Goes on by some steps; after the last step comes the first, and the other way round.
  void step(int steps);

 signals:
  /// Asks whether the views show the current step; the answer goes into `ready`.
  void askReady(bool& ready);

 private:
  int timeSteps() const;

  session::Document& mDocument;
  QPushButton* mPlay;
  QSlider* mSlider;
  QLabel* mText;
  QTimer mTimer;
  bool mIsReplaced = false;
};

}  // namespace velum::gui
