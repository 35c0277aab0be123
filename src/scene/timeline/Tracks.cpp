#include "scene/timeline/Tracks.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "core/Error.h"
#include "scene/ModelLayer.h"
#include "scene/Scene.h"
#include "scene/json/Paths.h"
#include "scene/timeline/AtPath.h"
#include "scene/timeline/SceneAt.h"

namespace velum::scene {

namespace {

constexpr double kSameKey = 5e-4;  ///< seconds

void appendStable(std::string& out, const auto& target, std::string_view rest);

template <detail::List T>
void appendStableItem(std::string& out, const T& target, std::string_view rest) {
  std::size_t place = 0;
  std::string_view tail;
  if (rest.starts_with('[')) {
    detail::PathKey key = detail::takeKey(rest, out);
    place = detail::findInBrackets(target, key.name, out);
    tail = key.rest;
  } else {
    detail::PathPart part = detail::takePart(rest);
    auto index = numberIn(part.head);
    if (!index || !(*index >= 0 && *index < double(target.size())))
      throw ArgumentError(fmt::format("{} has {} items; '{}' is none of them", out, target.size(), part.head));
    place = std::size_t(*index);
    tail = part.tail;
  }
  using Item = typename detail::ListTraits<T>::Item;
  detail::NamedItem named = detail::namedItem(target[place]);
  if constexpr (detail::Keyed<Item>)
    out += fmt::format("[{}]", named.id >= 0 ? std::to_string(named.id) : named.name);
  else if (named.id > 0)
    out += fmt::format("[#{}]", named.id);
  else
    out += fmt::format(".{}", place);
  appendStable(out, target[place], tail);
}

void appendStable(std::string& out, const auto& target, std::string_view rest) {
  using T = std::remove_cvref_t<decltype(target)>;
  if (rest.empty()) return;
  if constexpr (detail::Maybe<T>) {
    typename detail::MaybeTraits<T>::Value value = target.value_or(typename detail::MaybeTraits<T>::Value{});
    appendStable(out, value, rest);
  } else if constexpr (detail::List<T>) {
    appendStableItem(out, target, rest);
  } else if constexpr (detail::Fielded<T>) {
    detail::PathPart part = detail::takePart(rest);
    std::vector<std::string> known;
    bool found = false;
    std::string before = out;
    auto visit = [&](std::string_view name, const auto& member, const FieldInfo&) {
      known.emplace_back(name);
      if (name != part.head || found) return;
      found = true;
      out += (out.empty() ? "" : ".") + std::string(name);
      appendStable(out, member, part.tail);
    };
    T::fields(target, visit);
    if (!found) detail::failNoField(part.head, before, known);
  } else {
    throw ArgumentError(fmt::format("{} has no part '{}'", out, rest));
  }
}

/// "cuts[#3].centre": the list, the key and what follows.
struct ItemPath {
  std::string_view list, key, field;
};
std::optional<ItemPath> itemPath(std::string_view path) {
  std::size_t open = path.find('[');
  if (open == path.npos) return std::nullopt;
  detail::PathKey key = detail::takeKey(path.substr(open), std::string(path.substr(0, open)));
  return ItemPath{path.substr(0, open), key.name, key.rest};
}

/// "faceOpacity" as people read it: "face opacity"; of a path its last two parts, and what is in brackets.
std::string asWords(std::string_view path) {
  std::string words;
  for (char c : path) {
    bool isCapital = c >= 'A' && c <= 'Z';
    if (isCapital) words += ' ';
    words += c == '.' ? std::string(": ") : std::string(1, isCapital ? char(c - 'A' + 'a') : c);
  }
  if (words.ends_with(" deg")) words.resize(words.size() - 4);
  return words;
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = char(text[0] - 'a' + 'A');
  return text;
}

/// Gives a track the keys of another one of the same field, too. @return what was done, for people
std::string join(Track& track, const Track& other) {
  std::string told = fmt::format("timeline: {} has two tracks; they are one now, with the keys of both", track.path);
  track.enabled |= other.enabled;
  auto& keys = track.keys;
  keys.insert(keys.end(), other.keys.begin(), other.keys.end());
  std::ranges::stable_sort(keys, {}, &Key::time);
  std::size_t lost = 0;
  auto isSame = [&](const Key& key, const Key& next) {
    bool isAtOneTime = next.time - key.time < kSameKey;
    lost += isAtOneTime && !(next == key);
    return isAtOneTime;
  };
  keys.erase(std::unique(keys.begin(), keys.end(), isSame), keys.end());
  if (lost > 0) told += fmt::format("; where both had one at a time, the first one's stays (left out: {})", lost);
  if (keys.size() <= kMostKeys) return told;
  keys.resize(kMostKeys);
  return told + fmt::format("; of these only the first {}, more there cannot be", kMostKeys);
}

}  // namespace

std::vector<std::string> joinTracks(Scene& scene) {
  std::vector<std::string> told;
  std::vector<Track> tracks;
  std::map<std::string, std::size_t> places;
  for (Track& track : scene.timeline.tracks) {
    try {
      track.path = stablePath(scene, track.path);
    } catch (const ArgumentError&) {  // of a field that is not there, or not yet
    }
    auto [there, isNew] = places.try_emplace(track.path, tracks.size());
    if (isNew)
      tracks.push_back(std::move(track));
    else
      told.push_back(join(tracks[there->second], track));
  }
  scene.timeline.tracks = std::move(tracks);
  return told;
}

std::string stablePath(const Scene& scene, std::string_view path) {
  std::string out;
  appendStable(out, scene, path);
  return out;
}

std::optional<std::string> trackPathOf(const Scene& scene, std::string_view leaf) {
  // Parts that people set as one thing.
  for (std::string_view whole : {"camera"})
    if (leaf.starts_with(whole) && (leaf.size() == whole.size() || leaf[whole.size()] == '.'))
      return std::string(whole);
  for (std::string_view curve : {".opacities", ".gradientOpacities", ".colors", ".byValue", ".byGradient", ".pins",
                                 ".kernels", ".strokes", ".byLabel", ".byType"})
    if (std::size_t at = leaf.find(curve); at != leaf.npos) leaf = leaf.substr(0, at + curve.size());
  try {
    std::string path = stablePath(scene, leaf);
    return canChange(path) ? std::optional(path) : std::nullopt;
  } catch (const ArgumentError&) {
    return std::nullopt;
  }
}

int cutOfPath(std::string_view path) {
  if (!path.starts_with("cuts[#")) return 0;
  int id = 0;
  std::from_chars(path.data() + 6, path.data() + path.size(), id);
  return id;
}

std::string trackTitle(const Scene& scene, std::string_view path) {
  if (path == kOrbitPath) return "Orbit";
  if (path == "volume.timeStep") return "Time step";
  std::optional<ItemPath> item;
  try {
    item = itemPath(path);
  } catch (const ArgumentError&) {
  }
  if (!item) return capitalised(asWords(path));
  std::string name(item->key);
  auto nameIn = [&](const auto& list) {
    for (const auto& one : list)
      if (name == "#" + std::to_string(one.id) && !one.name.empty()) return void(name = one.name);
  };
  if (item->list == "cuts") nameIn(scene.cuts);
  if (item->list == "labels.structures") nameIn(scene.labels.structures);
  std::string field(item->field);
  if (auto inner = itemPath(field)) {  // a spare of a cut
    std::string of(inner->key);
    for (const Structure& structure : scene.labels.structures)
      if (of == std::to_string(structure.id) && !structure.name.empty()) of = structure.name;
    return fmt::format("{}: {}: {}", name, of, asWords(inner->field));
  }
  return fmt::format("{}: {}", name, asWords(field));
}

Track* findTrack(Timeline& timeline, std::string_view path) {
  auto found = std::ranges::find(timeline.tracks, path, &Track::path);
  return found == timeline.tracks.end() ? nullptr : &*found;
}
const Track* findTrack(const Timeline& timeline, std::string_view path) {
  return findTrack(const_cast<Timeline&>(timeline), path);
}

std::optional<std::size_t> keyAt(const Track& track, double time) {
  for (std::size_t i = 0; i < track.keys.size(); ++i)
    if (std::abs(track.keys[i].time - time) < kSameKey) return i;
  return std::nullopt;
}

AnyValue valueAt(const Scene& scene, std::string_view path) {
  Scene copy = scene;
  AnyValue value;
  detail::atPath(copy, path, [&](auto& member, const FieldInfo&) { value.json = detail::write(member).dump(); });
  return value;
}

Key& setKey(Timeline& timeline, std::string_view path, double time, AnyValue value) {
  Track* track = findTrack(timeline, path);
  if (!track) {
    if (timeline.tracks.size() >= kMostTracks)
      throw ArgumentError(fmt::format("timeline.tracks has {} items, and more it cannot have", kMostTracks));
    track = &timeline.tracks.emplace_back();
    track->path = path;
  }
  if (auto there = keyAt(*track, time)) {
    track->keys[*there].value = std::move(value);
    return track->keys[*there];
  }
  if (track->keys.size() >= kMostKeys)
    throw ArgumentError(fmt::format("the track of {} has {} keys, and more it cannot have", path, kMostKeys));
  auto later = std::find_if(track->keys.begin(), track->keys.end(), [&](const Key& key) { return key.time > time; });
  Ease ease = later == track->keys.begin() ? Key{}.ease : (later - 1)->ease;
  return *track->keys.insert(later, {time, std::move(value), ease});
}

std::size_t moveKey(Track& track, std::size_t key, double time) {
  Key moved = std::move(track.keys[key]);
  track.keys.erase(track.keys.begin() + std::ptrdiff_t(key));
  moved.time = std::clamp(time, 0.0, kLongestFilm);
  if (auto there = keyAt(track, moved.time)) {
    track.keys[*there] = std::move(moved);
    return *there;
  }
  auto later = std::find_if(track.keys.begin(), track.keys.end(), [&](const Key& k) { return k.time > moved.time; });
  return std::size_t(track.keys.insert(later, std::move(moved)) - track.keys.begin());
}

void removeKeys(Timeline& timeline, std::string_view path, double from, double to) {
  Track* track = findTrack(timeline, path);
  if (!track) return;
  std::erase_if(track->keys, [&](const Key& key) { return key.time > from - kSameKey && key.time < to + kSameKey; });
  if (track->keys.empty()) timeline.tracks.erase(timeline.tracks.begin() + (track - timeline.tracks.data()));
}

void dropLostTracks(Scene& scene) {
  std::erase_if(scene.timeline.tracks, [&](const Track& track) {
    try {
      valueAt(scene, track.path);
      return false;
    } catch (const ArgumentError&) {
      return true;
    }
  });
}

Timeline recorded(const Scene& before, const Scene& after, double time) {
  Timeline timeline = after.timeline;
  std::vector<std::string> done;
  for (const FieldValue& change : fieldChanges(before, after)) {
    auto path = trackPathOf(after, change.path);
    // A change within a part that has a track as a whole is a change of that part.
    for (const Track& track : timeline.tracks)
      if (path && path->starts_with(track.path + ".")) path = track.path;
    if (!path || std::ranges::find(done, *path) != done.end()) continue;
    done.push_back(*path);
    if (!findTrack(timeline, *path) && time > kSameKey) setKey(timeline, *path, 0.0, valueAt(before, *path));
    setKey(timeline, *path, time, valueAt(after, *path));
  }
  return timeline;
}

}  // namespace velum::scene
