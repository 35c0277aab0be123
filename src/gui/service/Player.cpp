#include "gui/service/Player.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace velum::gui {

namespace {

constexpr int kTickMs = 8;         ///< half a frame of the fastest screens in use
constexpr qint64 kFollowMs = 250;  ///< after which what keeps the time goes on although the views do not follow
constexpr double kSame = 1e-9;

/// The frame of a moment, counted from the first one.
int frameAt(const scene::FilmFrames& frames, double moment) {
  return int(std::floor((moment - frames.start) * frames.framesPerSecond + kSame));
}

}  // namespace

Player::Player(std::function<bool()> isCurrent) : mIsCurrent(std::move(isCurrent)) {
  mTimer.setInterval(kTickMs);
  mTimer.setTimerType(Qt::PreciseTimer);
  connect(&mTimer, &QTimer::timeout, this, &Player::tick);
}

void Player::setPlaying(const Playable& what, bool playing) {
  if (playing == isPlaying(what)) return;
  if (!playing) return stop();
  scene::FilmFrames frames = what.frames();
  if (frames.count == 0) return;
  double now = what.now();
  bool isWithin = now >= frames.start - kSame && now < frames.timeOf(frames.count - 1) - kSame;
  mWhat = &what;
  mLast = isWithin ? now : frames.start;
  countFrom(mLast);
  what.show(mLast);
  mSinceShown.start();
  mTimer.start();
  emit changed();
}

void Player::stop() {
  if (!isPlaying()) return;
  mTimer.stop();
  mWhat = nullptr;
  emit changed();
}

void Player::refresh() {
  if (isPlaying() && mWhat->frames().count == 0) stop();
}

void Player::countFrom(double moment) {
  mFrom = moment;
  mClock.start();
}

void Player::tick() {
  scene::FilmFrames frames = mWhat->frames();
  if (frames.count == 0) return stop();
  if (double now = mWhat->now(); std::abs(now - mLast) > kSame) countFrom(mLast = now);  // somebody has moved it
  if (!mIsCurrent() && !(mWhat->keepsTime && mSinceShown.elapsed() >= kFollowMs)) return;
  int frame = frameAt(frames, mFrom + double(mClock.nsecsElapsed()) * 1e-9), next = frameAt(frames, mLast) + 1;
  if (!mWhat->keepsTime && frame > next) countFrom(frames.timeOf(frame = next));
  double end = frames.timeOf(frames.count);
  if (frame >= frames.count && !mWhat->loops) {
    mWhat->show(end);
    return stop();
  }
  if (frame >= frames.count) mFrom -= (end - frames.start) * (frame / frames.count);
  double moment = frames.timeOf(std::max(frame, 0) % frames.count);
  if (std::abs(moment - mLast) < kSame) return;
  mLast = moment;
  mSinceShown.start();
  mWhat->show(moment);
}

}  // namespace velum::gui
