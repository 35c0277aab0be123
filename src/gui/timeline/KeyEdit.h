#pragma once
#include <string>
#include <vector>

#include "scene/Timeline.h"

namespace velum::gui {

/// A key of a film, by its field and its time, seconds.
struct KeyName {
  std::string path;
  double time = 0.0;
  auto operator<=>(const KeyName&) const = default;
};
using KeyNames = std::vector<KeyName>;

/// Keys that are copied: each with the field that it is of.
struct KeyClip {
  std::string path;
  scene::Key key;
};

/// What tracks are when several of their keys are changed at once. Keys that are not there are passed over; tracks
/// without keys go.
using Tracks = std::vector<scene::Track>;

bool hasKey(const Tracks& tracks, const KeyName& name);
/// @param seconds  by how much; keys in the way are replaced  @param copies  the keys stay where they are, too
Tracks withMoved(Tracks tracks, const KeyNames& names, double seconds, bool copies);
Tracks withoutKeys(Tracks tracks, const KeyNames& names);
Tracks withEase(Tracks tracks, const KeyNames& names, scene::Ease ease);
/// @param time  of the first of the pasted keys
Tracks withPasted(Tracks tracks, const std::vector<KeyClip>& clips, double time);
std::vector<KeyClip> clipsOf(const Tracks& tracks, const KeyNames& names);

/// By how much keys can be moved, where somebody wants to move them by so much: none comes before the beginning or,
/// unless it is there already, after the end.
double movable(const KeyNames& names, double seconds, double duration);

}  // namespace velum::gui
