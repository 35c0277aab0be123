#pragma once
#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>

#include "scene/timeline/SceneAt.h"

namespace velum::gui {

/// What can be played: frames, one of which is shown. Must live as long as it plays.
struct Playable {
  std::function<scene::FilmFrames()> frames;  ///< as they are now; none: there is nothing to play
  std::function<double()> now;                ///< the moment that is shown, seconds
  std::function<void(double)> show;           ///< shows a moment
  bool keepsTime = true;  ///< where the views are slow frames are left out; false: each waits until they show the last
  bool loops = false;     ///< after the last frame comes the first one
};

/// The clock of the window: plays one thing at a time, from frame to frame. One thread.
class Player : public QObject {
  Q_OBJECT
 public:
  /// @param isCurrent  whether the views show what they were last told
  explicit Player(std::function<bool()> isCurrent);

  /// Begins at what is shown; where that is at the end of the frames or outside of them, at the first one. What played
  /// before ends. Without frames nothing begins.
  void setPlaying(const Playable& what, bool playing);
  void stop();
  bool isPlaying() const { return mWhat; }
  bool isPlaying(const Playable& what) const { return mWhat == &what; }
  /// To be called after every change of the document: what has no frames any more ends.
  void refresh();

 signals:
  /// Something has begun or ended.
  void changed();

 private:
  void tick();
  void countFrom(double moment);

  std::function<bool()> mIsCurrent;
  const Playable* mWhat = nullptr;
  QTimer mTimer;
  QElapsedTimer mClock, mSinceShown;
  double mFrom = 0.0;  ///< the moment at which the clock began, seconds
  double mLast = 0.0;  ///< the one that was shown last
};

}  // namespace velum::gui
