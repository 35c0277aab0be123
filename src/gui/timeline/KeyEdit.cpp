#include "gui/timeline/KeyEdit.h"

#include <algorithm>

#include "scene/timeline/Tracks.h"

namespace velum::gui {

namespace {

/// The track and place of a key; null where it is not there.
struct Found {
  scene::Track* track = nullptr;
  std::size_t place = 0;
};

Found findKey(Tracks& tracks, const KeyName& name) {
  auto track = std::ranges::find(tracks, name.path, &scene::Track::path);
  if (track == tracks.end()) return {};
  auto place = scene::keyAt(*track, name.time);
  return place ? Found{&*track, *place} : Found{};
}

void put(Tracks& tracks, const KeyClip& clip, double time) {
  scene::Timeline timeline;
  timeline.tracks = std::move(tracks);
  scene::setKey(timeline, clip.path, std::clamp(time, 0.0, scene::kLongestFilm), clip.key.value).ease = clip.key.ease;
  tracks = std::move(timeline.tracks);
}

}  // namespace

bool hasKey(const Tracks& tracks, const KeyName& name) {
  auto track = std::ranges::find(tracks, name.path, &scene::Track::path);
  return track != tracks.end() && scene::keyAt(*track, name.time);
}

std::vector<KeyClip> clipsOf(const Tracks& tracks, const KeyNames& names) {
  std::vector<KeyClip> clips;
  Tracks all = tracks;
  for (const KeyName& name : names)
    if (Found found = findKey(all, name); found.track) clips.push_back({name.path, found.track->keys[found.place]});
  return clips;
}

Tracks withMoved(Tracks tracks, const KeyNames& names, double seconds, bool copies) {
  std::vector<KeyClip> clips = clipsOf(tracks, names);
  // Tracks stay where they are, also while they have no key.
  if (!copies)
    for (const KeyName& name : names)
      if (Found found = findKey(tracks, name); found.track)
        found.track->keys.erase(found.track->keys.begin() + std::ptrdiff_t(found.place));
  for (const KeyClip& clip : clips) put(tracks, clip, clip.key.time + seconds);
  return tracks;
}

Tracks withoutKeys(Tracks tracks, const KeyNames& names) {
  for (const KeyName& name : names)
    if (Found found = findKey(tracks, name); found.track)
      found.track->keys.erase(found.track->keys.begin() + std::ptrdiff_t(found.place));
  std::erase_if(tracks, [](const scene::Track& track) { return track.keys.empty(); });
  return tracks;
}

Tracks withEase(Tracks tracks, const KeyNames& names, scene::Ease ease) {
  for (const KeyName& name : names)
    if (Found found = findKey(tracks, name); found.track) found.track->keys[found.place].ease = ease;
  return tracks;
}

Tracks withPasted(Tracks tracks, const std::vector<KeyClip>& clips, double time) {
  double first = scene::kLongestFilm;
  for (const KeyClip& clip : clips) first = std::min(first, clip.key.time);
  for (const KeyClip& clip : clips) put(tracks, clip, time + clip.key.time - first);
  return tracks;
}

double movable(const KeyNames& names, double seconds, double duration) {
  double first = scene::kLongestFilm, last = 0.0;
  for (const KeyName& name : names) first = std::min(first, name.time), last = std::max(last, name.time);
  return names.empty() ? 0.0 : std::clamp(seconds, -first, std::max(0.0, duration - last));
}

}  // namespace velum::gui
