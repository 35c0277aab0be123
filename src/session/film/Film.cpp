#include "session/film/Film.h"

#include "session/Rest.h"
#include "session/growth/Growths.h"
#include "session/membrane/Membranes.h"

namespace velum::session {

Film::Film(scene::Scene scene)
    : mScene(std::move(scene)), mFrames(scene::framesOf(mScene.timeline)), mFollows(scene::hasRestsOfFilm(mScene)) {}

scene::Scene Film::sceneOf(int frame, double share, Progress& progress) {
  scene::Scene out = scene::sceneAt(mScene, mFrames.timeOf(frame) + share / mFrames.framesPerSecond);
  settleGrowths(out, mGrowths, progress);
  return out;
}

Film::Frame Film::at(int frame, double share, Progress& progress) {
  scene::Scene scene = sceneOf(frame, share, progress);
  if (!hasMembranes(scene)) return {scene, scene};
  if (!mFollows) return fromRest(std::move(scene), progress);
  goTo(frame - 1, progress);
  Frame out = alongFilm(std::move(scene), progress);
  if (share == 0.0) mRests = out.drawn, mRestsAt = frame;
  return out;
}

/// Where each sheet rests depends on the scene alone. What makes forces is kept from frame to frame.
Film::Frame Film::fromRest(scene::Scene scene, Progress& progress) {
  mMembranes.follow(scene);
  bringToRest(
      mMembranes, [this] { mMembranes.takeRests(); }, progress);
  scene::Scene drawn = mMembranes.withShapes(scene);
  return {std::move(scene), std::move(drawn)};
}

/// Sheets go on from where they rested in the frame before. They are made anew for each frame: from shapes alone it
/// comes out alike wherever the frame is drawn.
Film::Frame Film::alongFilm(scene::Scene scene, Progress& progress) {
  if (mRestsAt >= 0) scene::keepRests(scene, mRests);
  settleMembranes(scene, {}, progress);
  return {scene, scene};
}

/// Brings the sheets to a frame, so that the next one can go on from there.
void Film::goTo(int frame, Progress& progress) {
  if (mRestsAt > frame) mRestsAt = -1;
  while (mRestsAt < frame) {
    scene::Scene next = sceneOf(mRestsAt + 1, 0.0, progress);
    mRests = alongFilm(std::move(next), progress).drawn;
    ++mRestsAt;
  }
}

}  // namespace velum::session
