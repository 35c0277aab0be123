#pragma once
#include <algorithm>
#include <string>

#include "scene/Scene.h"
#include "scene/timeline/Tracks.h"
#include "session/film/ReadyFilms.h"

namespace velum::session {

/// Writes the keys of a film into a scene.
class FilmKeys {
 public:
  FilmKeys(scene::Scene& scene, FilmSpan span) : mScene(scene), mSpan(span) {
    scene::Timeline& timeline = scene.timeline;
    double end = span.start + span.seconds;
    timeline.duration = timeline.tracks.empty() ? end : std::max(timeline.duration, end);
  }
  /// A time of the film. @param at  0: its beginning, 1: its end
  double timeAt(double at) const { return mSpan.start + at * mSpan.seconds; }
  /// The same where 1 is the last picture of the film.
  double pictureAt(double at) const {
    double frame = std::min(1.0 / mScene.timeline.framesPerSecond, 0.5 * mSpan.seconds);
    return mSpan.start + at * (mSpan.seconds - frame);
  }
  /// Takes away the keys that a field has in the time of the film.
  void clear(const std::string& path) {
    scene::removeKeys(mScene.timeline, path, mSpan.start, mSpan.start + mSpan.seconds);
  }
  void set(const std::string& path, double time, std::string json, scene::Ease ease) {
    scene::setKey(mScene.timeline, path, time, AnyValue{std::move(json)}).ease = ease;
  }
  /// Sets the value that the field has in a scene.
  void setAsIn(const scene::Scene& scene, const std::string& path, double time, scene::Ease ease) {
    set(path, time, scene::valueAt(scene, path).json, ease);
  }

 private:
  scene::Scene& mScene;
  FilmSpan mSpan;
};

}  // namespace velum::session
