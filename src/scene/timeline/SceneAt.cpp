#include "scene/timeline/SceneAt.h"

#include <algorithm>
#include <cmath>

#include "core/Error.h"
#include "scene/Navigate.h"
#include "scene/Scene.h"
#include "scene/Units.h"
#include "scene/timeline/AtPath.h"
#include "scene/timeline/Mix.h"
#include "scene/timeline/Tracks.h"

namespace velum::scene {

namespace {

using detail::Four;
using detail::Json;
using detail::Moment;

constexpr double kSameTime = 1e-9;  ///< seconds

double eased(Ease ease, double t) {
  switch (ease) {
    case Ease::Hold:
      return 0.0;
    case Ease::In:
      return t * t;
    case Ease::Out:
      return t * (2.0 - t);
    case Ease::Both:
      return t * t * (3.0 - 2.0 * t);
    default:
      return t;
  }
}

/// A key's value as a field of a type, which begins as the field is in the scene.
template <class T>
T valueOf(const Key& key, T value, const std::string& path, const FieldInfo& info) {
  detail::read(value, Json::parse(key.value.json, nullptr, false), path, info);
  return value;
}

/// Puts a track's value into the field that it names.
template <class T>
void setAt(T& member, const FieldInfo& info, const Track& track, double time) {
  const auto& keys = track.keys;
  auto read = [&](std::size_t i) { return valueOf(keys[i], member, track.path, info); };
  auto later = std::find_if(keys.begin(), keys.end(), [&](const Key& key) { return key.time > time + kSameTime; });
  std::size_t to = std::size_t(later - keys.begin());
  if (to == 0) return void(member = read(0));
  std::size_t from = to - 1;
  const Key& key = keys[from];
  double span = to < keys.size() ? keys[to].time - key.time : 0.0;
  double t = span > 0.0 ? (time - key.time) / span : 0.0;
  bool isStill = to == keys.size() || t <= kSameTime || key.value == keys[to].value || key.ease == Ease::Hold;
  T a = read(from);
  if (isStill) return void(member = std::move(a));
  T b = read(to);
  Moment moment{eased(key.ease, t), key.ease == Ease::Smooth, 0.0, span, 0.0};
  Four<T> four{nullptr, &a, &b, nullptr};
  std::optional<T> before, after;
  if (moment.isSmooth && from > 0) {
    before = read(from - 1), four.before = &*before;
    moment.before = key.time - keys[from - 1].time;
  }
  if (moment.isSmooth && to + 1 < keys.size()) {
    after = read(to + 1), four.after = &*after;
    moment.after = keys[to + 1].time - keys[to].time;
  }
  detail::mixInto(member, four, moment, info);
}

/// @throw ArgumentError, InputError
void apply(Scene& scene, const Track& track, double time) {
  if (!canChange(track.path)) throw ArgumentError(fmt::format("{} cannot change in a film", track.path));
  if (track.keys.empty()) return;
  detail::atPath(scene, track.path, [&](auto& member, const FieldInfo& info) { setAt(member, info, track, time); });
}

void applyWhereItFits(Scene& scene, const Track& track, double time) {
  try {
    apply(scene, track, std::max(time, 0.0));
  } catch (const ArgumentError&) {  // as tracksThatDoNotFit() tells
  } catch (const InputError&) {
  }
}

/// True for an active sheet, which is dragged along, whose rest follows from how the film has moved it.
bool restsByFilm(const Timeline& timeline, const Cut& cut) {
  if (!cut.membrane || cut.membrane->repositioning != Repositioning::Active) return false;
  return std::ranges::any_of(timeline.tracks, [&](const Track& track) {
    return track.enabled && !track.keys.empty() && (cutOfPath(track.path) == cut.id || track.path == "volume.timeStep");
  });
}

}  // namespace

double orbitAt(const Scene& scene, double time) {
  Scene turned;
  turned.timeline.orbitDeg = scene.timeline.orbitDeg;
  const Track* track = findTrack(scene.timeline, kOrbitPath);
  if (track && track->enabled) applyWhereItFits(turned, *track, time);
  return turned.timeline.orbitDeg;
}

Scene sceneAt(const Scene& scene, double time) {
  Scene out = scene;
  for (const Track& track : scene.timeline.tracks)
    if (track.enabled) applyWhereItFits(out, track, time);
  double orbit = glm::radians(out.timeline.orbitDeg);
  if (orbit != 0.0) out.camera = turntable(out.camera, orbit);
  out.timeline = scene.timeline;
  out.timeline.orbitDeg = 0.0;
  completeItems(out);
  for (Cut& cut : out.cuts)
    if (restsByFilm(out.timeline, cut)) cut.membrane->shape = {};
  return out;
}

bool hasRestsOfFilm(const Scene& scene) {
  return std::ranges::any_of(scene.cuts, [&](const Cut& cut) { return restsByFilm(scene.timeline, cut); });
}

void keepRests(Scene& scene, const Scene& from) {
  for (Cut& cut : scene.cuts) {
    const Cut* was = findCut(from, cut.id);
    if (was && was->membrane && restsByFilm(scene.timeline, cut)) cut.membrane->shape = was->membrane->shape;
  }
}

std::vector<std::string> tracksThatDoNotFit(const Scene& scene) {
  std::vector<std::string> lines;
  Scene tried = scene;
  for (const Track& track : scene.timeline.tracks) {
    try {
      for (const Key& key : track.keys) apply(tried, track, key.time);
    } catch (const Error& error) {
      lines.push_back(fmt::format("timeline: {}", error.what()));
    }
  }
  return lines;
}

bool canChange(std::string_view path) {
  if (path == kOrbitPath) return true;
  constexpr std::string_view kNever[] = {"timeline",
                                         "unit",
                                         "volume",
                                         "labels",
                                         "model",
                                         "surfaces",
                                         "labels.structures",
                                         "labels.growths",
                                         "cuts",
                                         "volume.bodyOnly",
                                         "model.completes",
                                         "finish.ownPaper",
                                         "finish",
                                         "finish.spheres",
                                         "sections.layout",
                                         "sections.beside",
                                         ""};
  constexpr std::string_view kNames[] = {".id",    ".name",    ".source",    ".smoothing", ".shape",
                                         ".types", ".targets", ".structure", ".type",      ".fileId"};
  if (std::ranges::find(kNever, path) != std::end(kNever)) return false;
  if (path.starts_with("timeline.") || path.find(".source.") != path.npos || path.starts_with("finish.spheres") ||
      path.starts_with("finish.ownPaper"))
    return false;
  if (path.ends_with(']')) return false;  // a whole item
  return std::ranges::none_of(kNames, [&](std::string_view name) { return path.ends_with(name); });
}

void keepTracked(Scene& scene, const Scene& from) {
  Scene other = from;
  for (const Track& track : scene.timeline.tracks) {
    if (!track.enabled || track.keys.empty() || !canChange(track.path)) continue;
    try {
      void* value = nullptr;
      const std::type_info* type = nullptr;
      detail::atPath(other, track.path, [&](auto& member, const FieldInfo&) {
        value = &member;
        type = &typeid(member);
      });
      detail::atPath(scene, track.path, [&](auto& member, const FieldInfo&) {
        if (*type == typeid(member)) member = *static_cast<std::remove_reference_t<decltype(member)>*>(value);
      });
    } catch (const ArgumentError&) {  // one of the two has no such field
    }
  }
}

void changeKeys(Scene& scene, const std::function<void(Scene&)>& change) {
  for (Track& track : scene.timeline.tracks) {
    for (Key& key : track.keys) {
      try {
        Scene changed = scene;
        detail::atPath(changed, track.path,
                       [&](auto& member, const FieldInfo& info) { member = valueOf(key, member, track.path, info); });
        change(changed);
        detail::atPath(changed, track.path,
                       [&](auto& member, const FieldInfo&) { key.value.json = detail::write(member).dump(); });
      } catch (const Error&) {  // a track that does not fit stays as it is
      }
    }
  }
}

void scaleKeys(Scene& scene, double factor) {
  changeKeys(scene, [factor](Scene& changed) { scaleLengths(changed, factor); });
}

FilmFrames framesOf(const Timeline& timeline) {
  double end =
      timeline.rangeEnd > timeline.rangeStart ? std::min(timeline.rangeEnd, timeline.duration) : timeline.duration;
  double start = std::min(timeline.rangeStart, end);
  return {start, timeline.framesPerSecond, std::max(1, int(std::lround((end - start) * timeline.framesPerSecond)))};
}

}  // namespace velum::scene
