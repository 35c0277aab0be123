#include "gui/timeline/FilmPlayer.h"

#include <algorithm>
#include <cmath>

#include "scene/timeline/SceneAt.h"

namespace velum::gui {

namespace {

constexpr int kTickMs = 8;         ///< half a frame of the fastest screens in use
constexpr qint64 kFollowMs = 250;  ///< after which the playhead goes on although the views do not follow
constexpr double kSame = 1e-9;

}  // namespace

FilmPlayer::FilmPlayer(session::Document& document, QObject* parent) : QObject(parent), mDocument(document) {
  mTimer.setInterval(kTickMs);
  mTimer.setTimerType(Qt::PreciseTimer);
  connect(&mTimer, &QTimer::timeout, this, &FilmPlayer::tick);
}

void FilmPlayer::setPlaying(bool playing) {
  if (playing == isPlaying()) return;
  if (playing) {
    scene::FilmFrames frames = scene::framesOf(mDocument.scene().timeline);
    double now = mDocument.playhead().value_or(frames.start), last = frames.timeOf(frames.count - 1);
    mFrom = now < frames.start - kSame || now >= last - kSame ? frames.start : now;
    mLast = mFrom;
    mDocument.setPlayhead(mFrom);
    mClock.start();
    mSinceMoved.start();
    mTimer.start();
  } else {
    mTimer.stop();
  }
  emit playingChanged(playing);
}

void FilmPlayer::refresh() {
  if (isPlaying() && (!mDocument.playhead() || mDocument.scene().timeline.tracks.empty())) setPlaying(false);
}

void FilmPlayer::tick() {
  if (std::abs(mDocument.playhead().value_or(0.0) - mLast) > kSame) {  // somebody has moved it: it goes on from there
    mFrom = mLast = mDocument.playhead().value_or(0.0);
    mClock.restart();
  }
  bool isReady = true;
  emit askReady(isReady);
  if (!isReady && mSinceMoved.elapsed() < kFollowMs) return;
  scene::FilmFrames frames = scene::framesOf(mDocument.scene().timeline);
  double end = frames.timeOf(frames.count), now = mFrom + double(mClock.nsecsElapsed()) * 1e-9;
  if (now >= end && !mLoops) {
    mDocument.setPlayhead(end);
    return setPlaying(false);
  }
  if (now >= end) {
    mFrom = frames.start + std::fmod(now - end, end - frames.start);
    mClock.restart();
    now = mFrom;
  }
  double frame = std::floor((now - frames.start) * frames.framesPerSecond + kSame);
  double shown = frames.start + std::max(frame, 0.0) / frames.framesPerSecond;
  if (std::abs(shown - mLast) < kSame) return;
  mLast = shown;
  mSinceMoved.restart();
  mDocument.setPlayhead(shown);
}

}  // namespace velum::gui
