#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/Fields.h"

namespace velum::scene {

/// The path of Timeline::orbitDeg.
inline constexpr std::string_view kOrbitPath = "timeline.orbitDeg";

/// How a field gets from a key to the next one. Hold: not before the next key's time. Linear: evenly. In: slowly at
/// first. Out: slowly towards the end. Both: slowly at first and towards the end. Smooth: along cubic curves that begin
/// and end at rest, pass the keys between without a stop, and never swing beyond a key.
enum class Ease { Hold, Linear, In, Out, Both, Smooth };

/// Longest film, seconds; most keys of a track; most tracks.
constexpr double kLongestFilm = 86'400.0;
constexpr std::size_t kMostKeys = 10'000, kMostTracks = 10'000;

/// What a field is to be at a time.
struct Key {
  double time = 0.0;         ///< seconds from the beginning of the film
  AnyValue value;            ///< as the field stands in scene files; members that it leaves out are as in the scene
  Ease ease = Ease::Smooth;  ///< on the way to the next key
  bool operator==(const Key&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("time", o.time, FieldInfo{"s", {0, kLongestFilm}, "From the beginning of the film."});
    visit("value", o.value, FieldInfo{"", {}, "Value of the field then, as it stands in scene files."});
    visit("ease", o.ease,
          FieldInfo{"", {}, "How it gets to the next key: smooth passes keys without a stop, both stops at each."});
  }
};

/// A field that changes in a film.
struct Track {
  static constexpr std::string_view kKey = "path";  ///< that a bare value stands for on the command line

  std::string path;  ///< of the field; items of lists by id or key: "cuts[#2].centre", see stablePath()
  bool enabled = true;
  std::vector<Key>
      keys;  ///< ascending by time, each time once; before the first and after the last key nothing changes
  bool operator==(const Track&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("path", o.path, FieldInfo{"", {}, "Field that changes; items of lists by their ids: cuts[#2].centre."});
    visit("enabled", o.enabled, FieldInfo{"", {}, "Off: the field is as in the scene.", true});
    visit("keys", o.keys, FieldInfo{"", {}, "What it is when, in the order of time.", false, false, kMostKeys});
  }
};

/// A film: fields of the scene over time. The scene itself holds what the tracks leave alone; see sceneAt().
struct Timeline {
  double duration = 8.0;  ///< seconds
  double framesPerSecond = 30.0;
  double rangeStart = 0.0, rangeEnd = 0.0;  ///< part that is played and drawn, seconds; an end of 0: to the end
  double orbitDeg = 0.0;      ///< by how much the eye is turned about the upright axis through the camera's target
  std::vector<Track> tracks;  ///< one for each field
  bool operator==(const Timeline&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("duration", o.duration, FieldInfo{"s", {0.01, kLongestFilm}, "How long the film is."});
    visit("framesPerSecond", o.framesPerSecond, FieldInfo{"1/s", {0.01, 1000}, "Pictures in a second."});
    visit("rangeStart", o.rangeStart,
          FieldInfo{"s", {0, kLongestFilm}, "Where the part begins that is played and drawn.", true});
    visit("rangeEnd", o.rangeEnd, FieldInfo{"s", {0, kLongestFilm}, "Where it ends; 0: with the film.", true});
    visit("orbitDeg", o.orbitDeg,
          FieldInfo{"deg",
                    {-1e6, 1e6},
                    "By how much the eye is turned about the upright axis through the camera's target, beyond what the "
                    "camera says; 720: twice round.",
                    true});
    visit("tracks", o.tracks, FieldInfo{"", {}, "Fields that change, each once.", false, false, kMostTracks});
  }
};

}  // namespace velum::scene

template <>
struct velum::EnumNames<velum::scene::Ease> {
  static constexpr std::string_view kNames[] = {"hold", "linear", "in", "out", "both", "smooth"};
};
