#pragma once
#include <string>
#include <string_view>

#include "scene/Caption.h"
#include "scene/Timeline.h"
#include "session/command/CutCommands.h"
#include "session/command/StructureCommands.h"

/// The arguments of commands of films: keys, the playhead, ready-made films.
namespace velum::session {

class Document;

inline constexpr FieldInfo kFilmStartInfo{"s", {0, scene::kLongestFilm}, "When it begins."};
inline constexpr FieldInfo kFilmSecondsInfo{"s", {0.001, scene::kLongestFilm}, "How long it takes."};
inline constexpr FieldInfo kKeyPathInfo{"", {}, "Field of the scene, such as camera or cuts[Front].centre."};
inline constexpr FieldInfo kKeyTimeInfo{"s", {-1, scene::kLongestFilm}, "When; -1: at the playhead."};

struct SetFilmKey {
  static constexpr std::string_view kName = "film.key";
  static constexpr std::size_t kTakesRest = 3;
  std::string field;
  double time = -1.0;
  std::string value;
  static void fields(auto& o, auto& visit) {
    visit("field", o.field, kKeyPathInfo);
    visit("time", o.time, kKeyTimeInfo);
    visit("value", o.value, FieldInfo{"", {}, "What it is then, as of set; nothing: what is seen."});
  }
};

struct RemoveFilmKey {
  static constexpr std::string_view kName = "film.removeKey";
  std::string field;
  double time = -1.0;
  static void fields(auto& o, auto& visit) {
    visit("field", o.field, kKeyPathInfo);
    visit("time", o.time, kKeyTimeInfo);
  }
};

struct MoveFilmKey {
  static constexpr std::string_view kName = "film.moveKey";
  std::string field;
  double time = 0.0, to = 0.0;
  bool copy = false;
  static void fields(auto& o, auto& visit) {
    visit("field", o.field, kKeyPathInfo);
    visit("time", o.time, FieldInfo{"s", {0, scene::kLongestFilm}, "Of the key."});
    visit("to", o.to, FieldInfo{"s", {0, scene::kLongestFilm}, "Its new time; a key that is there is replaced."});
    visit("copy", o.copy, FieldInfo{"", {}, "On: the key stays where it is, too."});
  }
};

struct EaseFilmKey {
  static constexpr std::string_view kName = "film.ease";
  std::string field;
  double time = -1.0;
  scene::Ease ease = scene::Ease::Smooth;
  static void fields(auto& o, auto& visit) {
    visit("field", o.field, kKeyPathInfo);
    visit("time", o.time, kKeyTimeInfo);
    visit("ease", o.ease, FieldInfo{"", {}, "How it gets from this key to the next one."});
  }
};

struct RemoveFilmTrack {
  static constexpr std::string_view kName = "film.removeTrack";
  std::string field;
  static void fields(auto& o, auto& visit) { visit("field", o.field, kKeyPathInfo); }
};

struct ClearFilm {
  static constexpr std::string_view kName = "film.clear";
  static void fields(auto&, auto&) {}
};

struct MovePlayhead {
  static constexpr std::string_view kName = "film.at";
  double time = 0.0;
  static void fields(auto& o, auto& visit) {
    visit("time", o.time, FieldInfo{"s", {-1, scene::kLongestFilm}, "What is shown; -1: the scene without its film."});
  }
};

struct RecordFilm {
  static constexpr std::string_view kName = "film.record";
  bool on = true;
  static void fields(auto& o, auto& visit) {
    visit("on", o.on, FieldInfo{"", {}, "Whether what is changed at the playhead becomes a key."});
  }
};

struct AddTurn {
  static constexpr std::string_view kName = "film.turn";
  double seconds = 8.0, turns = 1.0, start = 0.0;
  bool gently = false;
  static void fields(auto& o, auto& visit) {
    visit("seconds", o.seconds, kFilmSecondsInfo);
    visit("turns", o.turns, FieldInfo{"", {-100, 100}, "How often the eye goes round; below 0: the other way."});
    visit("gently", o.gently, FieldInfo{"", {}, "Begins and ends at rest."});
    visit("start", o.start, kFilmStartInfo);
  }
};

/// Of films in which cuts come in.
struct CutFilm {
  double seconds = 6.0;
  std::string cut;
  bool back = false;
  double start = 0.0;
  static void fields(auto& o, auto& visit) {
    visit("seconds", o.seconds, kFilmSecondsInfo);
    visit("cut", o.cut, FieldInfo{"", {}, "Which one comes in; nothing: all that are on."});
    visit("back", o.back, FieldInfo{"", {}, "Goes out again in the second half."});
    visit("start", o.start, kFilmStartInfo);
  }
};
struct AddCutting : CutFilm {
  static constexpr std::string_view kName = "film.cut";
};
struct AddSinking : CutFilm {
  static constexpr std::string_view kName = "film.membrane";
};

struct AddPulling {
  static constexpr std::string_view kName = "film.pull";
  double seconds = 8.0, overlap = 0.2, hold = 0.1, start = 0.0;
  static void fields(auto& o, auto& visit) {
    visit("seconds", o.seconds, kFilmSecondsInfo);
    visit("overlap", o.overlap, FieldInfo{"", {0, 1}, "0: one after the other; 1: all at once."});
    visit("hold", o.hold, FieldInfo{"", {0, 0.9}, "Share of the time that all stand out at the end."});
    visit("start", o.start, kFilmStartInfo);
  }
};

struct AddEqualizing {
  static constexpr std::string_view kName = "film.equalize";
  double seconds = 10.0, hold = 0.2, start = 0.0;
  static void fields(auto& o, auto& visit) {
    visit("seconds", o.seconds, kFilmSecondsInfo);
    visit("hold", o.hold, FieldInfo{"", {0, 0.9}, "Share of the time in which nothing changes."});
    visit("start", o.start, kFilmStartInfo);
  }
};

struct AddFlight {
  static constexpr std::string_view kName = "film.fly";
  std::string structure;
  double seconds = 5.0, fill = 0.9, start = 0.0;
  static void fields(auto& o, auto& visit) {
    visit("structure", o.structure, FieldInfo{"", {}, "Its name or number."});
    visit("seconds", o.seconds, kFilmSecondsInfo);
    visit("fill", o.fill, FieldInfo{"", {0.1, 1}, "How much of the picture's height the ball about it is to fill."});
    visit("start", o.start, kFilmStartInfo);
  }
};

struct AddTimeSteps {
  static constexpr std::string_view kName = "film.time";
  double seconds = 5.0, rounds = 1.0, start = 0.0;
  static void fields(auto& o, auto& visit) {
    visit("seconds", o.seconds, kFilmSecondsInfo);
    visit("rounds", o.rounds, FieldInfo{"", {1, 1000}, "How often it goes through its time steps."});
    visit("start", o.start, kFilmStartInfo);
  }
};

struct AddComparison {
  static constexpr std::string_view kName = "film.compare";
  double seconds = 6.0, hold = 0.35, start = 0.0;
  static void fields(auto& o, auto& visit) {
    visit("seconds", o.seconds, kFilmSecondsInfo);
    visit("hold", o.hold, FieldInfo{"", {0.1, 0.49}, "Share of the time that whole and cut are seen, each."});
    visit("start", o.start, kFilmStartInfo);
  }
};

/// What the commands film.key and film.removeKey do, as one undo step, for those who have a document and no session.
/// @throw ArgumentError, InputError; then nothing has changed
void editKey(Document& document, const SetFilmKey& call);
void editKey(Document& document, const RemoveFilmKey& call);

struct AddTitle {
  static constexpr std::string_view kName = "film.title";
  std::string text;
  double start = 0.0, seconds = 4.0, fade = 0.5;
  scene::CaptionPlace place = scene::CaptionPlace::Bottom;
  static void fields(auto& o, auto& visit) {
    visit("text", o.text, FieldInfo{"", {}, "The words."});
    visit("start", o.start, kFilmStartInfo);
    visit("seconds", o.seconds, kFilmSecondsInfo);
    visit("fade", o.fade, FieldInfo{"s", {0, 60}, "How long it takes to come, and to go."});
    visit("place", o.place, FieldInfo{"", {}, "Where it stands."});
  }
};

}  // namespace velum::session
