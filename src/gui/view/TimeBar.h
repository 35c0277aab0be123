#pragma once
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QSlider>

#include "gui/service/Player.h"
#include "session/document/Document.h"

namespace velum::gui {

/// The time steps of a series: a slider, and play. Hidden for data without time. Playing leaves no step out, however
/// slow the machine.
class TimeBar : public QFrame {
  Q_OBJECT
 public:
  TimeBar(session::Document& document, Player& player, QWidget* parent);
  void refresh();
  /// Hides the bar while a film says which step is seen.
  void setReplaced(bool replaced) { mIsReplaced = replaced; }
  void setPlaying(bool playing) { mPlayer.setPlaying(mSeries, playing); }
  bool isPlaying() const { return mPlayer.isPlaying(mSeries); }
  /// Goes on by some steps; after the last step comes the first, and the other way round.
  void step(int steps);

 private:
  int timeSteps() const;
  void show(int timeStep);
  void showPlaying();

  session::Document& mDocument;
  Player& mPlayer;
  Playable mSeries;
  QPushButton* mPlay;
  QSlider* mSlider;
  QLabel* mText;
  bool mIsReplaced = false;
};

}  // namespace velum::gui
