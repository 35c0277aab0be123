#include "session/picture/Film.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "core/Error.h"
#include "scene/Navigate.h"
#include "scene/Shown.h"
#include "session/Rest.h"
#include "session/extrusion/Extrusion.h"
#include "session/growth/Growths.h"
#include "session/membrane/Membranes.h"
#include "session/picture/CutPath.h"

namespace velum::session {

namespace {

int timeStepsOf(const scene::Scene& scene) { return scene.volume.data ? scene.volume.data->timeSteps : 1; }

}  // namespace

Motion usualMotion(const scene::Scene& scene) { return timeStepsOf(scene) > 1 ? Motion::Time : Motion::Turn; }

std::string whyStill(const scene::Scene& scene, Motion motion) {
  if (motion == Motion::Time && timeStepsOf(scene) < 2) return "the volume has no time steps";
  if (motion == Motion::Pull && extrusionsOf(scene).empty()) return "no structure is pulled out of a cut";
  if (motion != Motion::Cut) return {};
  bool isCut = !scene::enabledOf(scene.cuts).empty();
  return isCut ? "" : "no cut is on";
}

scene::Scene frameOf(const scene::Scene& scene, Motion motion, int frame, int frames) {
  scene::Scene out = scene;
  double at = frames > 1 ? double(frame) / (frames - 1) : 1.0;  // of those that end with the scene
  switch (motion) {
    case Motion::Turn:
      out.camera = scene::turntable(scene.camera, 2.0 * std::numbers::pi * frame / frames);
      break;
    case Motion::Time:
      out.volume.timeStep = frame * timeStepsOf(scene) / frames;
      break;
    case Motion::Pull:
      out = pulledOut(std::move(out), at);
      break;
    case Motion::Cut:
      out = cutPathAt(std::move(out), at);
      break;
  }
  return out;
}

std::vector<std::filesystem::path> framePaths(const std::filesystem::path& path, int frames) {
  std::vector<std::filesystem::path> paths;
  for (int i = 0; i < frames; ++i)
    paths.push_back(path.parent_path() / fmt::format("{}-{:04}{}", path.stem().string(), i, path.extension().string()));
  return paths;
}

std::vector<std::filesystem::path> filmPaths(const FilmOptions& options, const std::filesystem::path& path) {
  if (!options.motion) return {path};
  if (path == "-") throw ArgumentError("an animation is several files; name one, e.g. turn.png");
  return framePaths(path, options.frames);
}

Film::Film(scene::Scene scene, const FilmOptions& options)
    : mScene(std::move(scene)), mMotion(options.motion), mFrames(options.frames) {
  if (!mMotion) return;
  if (std::string why = whyStill(mScene, *mMotion); !why.empty()) throw ArgumentError("no animation: " + why);
}

Film::Frame Film::at(int frame, Progress& progress) {
  Frame out{mMotion ? frameOf(mScene, *mMotion, frame, mFrames) : mScene, {}};
  settleGrowths(out.scene, mGrowths, progress);
  out.drawn = out.scene;
  if (!hasMembranes(out.scene)) return out;
  mMembranes.follow(out.scene);
  bringToRest(
      mMembranes, [this] { mMembranes.takeRests(); }, progress);
  out.drawn = mMembranes.withShapes(std::move(out.drawn));
  return out;
}

}  // namespace velum::session
