#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/SceneFwd.h"
#include "scene/Timeline.h"

/// What a scene is at a time of its film.
namespace velum::scene {

/// The scene at a time: each field that an enabled track names has the value of its keys then, and the eye is turned by
/// Timeline::orbitDeg, which is 0 afterwards; everything else, the timeline itself, too, is as in the scene. A function
/// of the scene and the time alone. Where a track moves a membrane that is active, the place in which its sheet has
/// come to rest is left out: where it rests follows from the film. Tracks that do not fit the scene change nothing; see
/// tracksThatDoNotFit(). Cost: the tracks and what their keys hold.
/// @param time  seconds; before the beginning as at the beginning
Scene sceneAt(const Scene& scene, double time);

/// By how much the eye is turned at a time, degrees: Timeline::orbitDeg with its track.
double orbitAt(const Scene& scene, double time);

/// What is wrong with tracks, one line each, for people: fields that are not there or cannot change, values that do not
/// fit.
std::vector<std::string> tracksThatDoNotFit(const Scene& scene);

/// True for fields, and for parts of a scene, that a film can change: not sources, names, ids, what takes new data,
/// what is no part of a picture, and the timeline itself.
bool canChange(std::string_view path);

/// Gives all fields that enabled tracks name the values that they have in another scene, where both have them.
void keepTracked(Scene& scene, const Scene& from);

/// True where some membrane rests where the film has taken it, see sceneAt().
bool hasRestsOfFilm(const Scene& scene);
/// Gives membranes whose rest follows from the film, see sceneAt(), the shapes that they have in another scene.
void keepRests(Scene& scene, const Scene& from);

/// Changes the values of all keys as a change of the scene would change the fields that they are of.
void changeKeys(Scene& scene, const std::function<void(Scene&)>& change);
/// Multiplies the lengths in all keys, as scaleLengths() does with those of the scene itself.
void scaleKeys(Scene& scene, double factor);

/// The moments at which a film shows its frames, seconds: frame i is shown at start + i / framesPerSecond.
struct FilmFrames {
  double start = 0.0, framesPerSecond = 30.0;
  int count = 0;
  double timeOf(int frame) const { return start + frame / framesPerSecond; }
};
/// The frames of a timeline's range. The frame at its very end is not one of them: a film that is shown again and again
/// has it as its first.
FilmFrames framesOf(const Timeline& timeline);

}  // namespace velum::scene
