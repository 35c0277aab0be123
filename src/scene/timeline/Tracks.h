#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/SceneFwd.h"
#include "scene/Timeline.h"

/// Tracks and keys: found, set and told.
namespace velum::scene {

/// A path by which a field stays known when other items of a list come and go, or are renamed: items by their ids or
/// keys: "cuts.0.centre" and "cuts[Front].centre" become "cuts[#3].centre". @throw ArgumentError where no field is
std::string stablePath(const Scene& scene, std::string_view path);

/// For films from outside: gives tracks the stable paths of their fields, and makes one track of several of one field,
/// with the keys of all; where these have keys at the same time, that of the first stays.
/// @return what was joined, one line each, for people
std::vector<std::string> joinTracks(Scene& scene);

/// The field of which a key is made when a field changes: the camera as a whole, curves as a whole, else the field
/// itself; by its stable path. Nothing where a film cannot change it.
/// @param leaf  path of a field as fieldChanges() gives it
std::optional<std::string> trackPathOf(const Scene& scene, std::string_view leaf);

/// The id of the cut that a stable path leads into; 0: none.
int cutOfPath(std::string_view path);

/// What people call the field of a track: "Front: centre", "Camera", "aorta: opacity".
std::string trackTitle(const Scene& scene, std::string_view path);

/// The track of a field, by its path; null where there is none.
Track* findTrack(Timeline& timeline, std::string_view path);
const Track* findTrack(const Timeline& timeline, std::string_view path);
/// The place in a track of the key at a time, to a thousandth of a second; nothing where there is none.
std::optional<std::size_t> keyAt(const Track& track, double time);

/// The value of a field as a key holds it. @throw ArgumentError
AnyValue valueAt(const Scene& scene, std::string_view path);

/// Sets a key of a field, in the place of one at that time. A new key has the ease of the key before it.
/// @return the key
Key& setKey(Timeline& timeline, std::string_view path, double time, AnyValue value);
/// Moves a key to another time: in the place of one that is there. @return its place among the keys now
std::size_t moveKey(Track& track, std::size_t key, double time);
/// Removes keys of a field between two times, both included, and the track with its last key.
void removeKeys(Timeline& timeline, std::string_view path, double from, double to);
/// Removes the tracks of fields that a scene does not have any more.
void dropLostTracks(Scene& scene);

/// The timeline with a key at a time for each field that differs between two scenes and that a film can change. A field
/// without a track gets a key at the beginning, too, with the value that it had, unless the time is the beginning.
/// @param before, after  scenes at that time
Timeline recorded(const Scene& before, const Scene& after, double time);

}  // namespace velum::scene
