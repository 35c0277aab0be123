#pragma once
#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "session/document/Document.h"

namespace velum::gui {

/// Plays a scene's film: the clock drives the playhead from frame to frame through the range. Where the views are
/// slower than the film, frames are left out; the time is kept. It ends with the range, or begins it anew.
class FilmPlayer : public QObject {
  Q_OBJECT
 public:
  FilmPlayer(session::Document& document, QObject* parent);

  /// Begins at the playhead; where that is at the end of the range or outside of it, at the range's beginning.
  void setPlaying(bool playing);
  bool isPlaying() const { return mTimer.isActive(); }
  void setLooping(bool looping) { mLoops = looping; }
  bool isLooping() const { return mLoops; }
  /// To be called after every change of the document: another scene, or one without a film, ends it.
  void refresh();

 signals:
  void playingChanged(bool playing);
  /// Asks whether the views show what they were last told; the answer goes into `ready`.
  void askReady(bool& ready);

 private:
  void tick();

  session::Document& mDocument;
  QTimer mTimer;
  QElapsedTimer mClock, mSinceMoved;
  double mFrom = 0.0;  ///< where the playhead was when the clock began, seconds
  double mLast = 0.0;  ///< where it was moved to last
  bool mLoops = false;
};

}  // namespace velum::gui
