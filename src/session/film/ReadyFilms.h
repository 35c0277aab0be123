#pragma once
#include <string>
#include <string_view>

#include "core/Fields.h"
#include "scene/Caption.h"
#include "scene/SceneFwd.h"

/// Ready-made films: each writes ordinary keys into the scene's timeline, in the place of keys that the same fields
/// have at those times, and makes the timeline long enough. The last picture of a film that ends with the scene as it
/// is shows the scene as it is.
namespace velum::session {

/// Turn: the eye goes round the data. Cut: the cuts come in from where the data ends. Membrane: membranes sink in.
/// Pull: structures come out of the cuts one after the other. Equalize: a model goes from whole over all that its cuts
/// can take to what the cuts leave ([VE] fig. 4). Fly: the eye goes to a structure. Time: the volume goes through its
/// time steps. Compare: whole, then cut open. Title: words come and go.
enum class ReadyFilm { Turn, Cut, Membrane, Pull, Equalize, Fly, Time, Compare, Title };

/// When a ready-made film is to play.
struct FilmSpan {
  double start = 0.0, seconds = 8.0;
};

/// Time where the volume has several time steps, else Turn.
ReadyFilm usualFilm(const scene::Scene& scene);
/// Why a scene has no such film, for people; empty where it has one. @param structure  for Fly; empty: any
std::string whyNoFilm(const scene::Scene& scene, ReadyFilm film);

/// A scene with a ready-made film of so many pictures in the place of the film that it has.
/// @throw ArgumentError where whyNoFilm() says why there is none
scene::Scene withReadyFilm(scene::Scene scene, ReadyFilm film, int frames);

/// Adds a film as it is by default. @throw ArgumentError where whyNoFilm() says why there is none
void addReadyFilm(scene::Scene& scene, ReadyFilm film, FilmSpan span);

// The films, each with what can be set. @throw ArgumentError where there is no such film

/// @param turns  how often the eye goes round; negative: the other way  @param gently  begins and ends at rest
void addTurn(scene::Scene& scene, FilmSpan span, double turns, bool gently);
/// @param cut  id of the cut that comes in; 0: all that are on  @param back  goes out again in the second half
void addCutting(scene::Scene& scene, FilmSpan span, int cut, bool back);
/// The same for membranes.
void addSinking(scene::Scene& scene, FilmSpan span, int cut, bool back);
/// @param overlap  0: each begins when the one before has come out; 1: all at once  @param hold  share of the time that
/// all stand out, 0..0.9
void addPulling(scene::Scene& scene, FilmSpan span, double overlap, double hold);
/// @param hold  share of the time in which nothing changes, at the beginning, the turning point and the end, 0..0.9
void addEqualizing(scene::Scene& scene, FilmSpan span, double hold);
/// @param structure  id  @param fill  how much of the picture's height the ball about its box fills, 0.1..1
void addFlight(scene::Scene& scene, FilmSpan span, int structure, double fill);
/// @param rounds  how often the volume goes through its time steps
void addTimeSteps(scene::Scene& scene, FilmSpan span, double rounds);
/// @param hold  share of the time that each of the two is seen, 0.1..0.9
void addComparison(scene::Scene& scene, FilmSpan span, double hold);
/// Adds a caption. @param fade  seconds that it takes to come, and to go; at most half of the time
void addTitle(scene::Scene& scene, FilmSpan span, const std::string& text, double fade, scene::CaptionPlace place);

}  // namespace velum::session

template <>
struct velum::EnumNames<velum::session::ReadyFilm> {
  static constexpr std::string_view kNames[] = {"turn", "cut",  "membrane", "pull", "equalize",
                                                "fly",  "time", "compare",  "title"};
};
