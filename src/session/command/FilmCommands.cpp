#include "session/command/FilmCommands.h"

#include "scene/Navigate.h"
#include "scene/json/FieldPaths.h"
#include "scene/json/Paths.h"
#include "scene/timeline/SceneAt.h"
#include "scene/timeline/Tracks.h"
#include "session/Session.h"
#include "session/command/CommandRow.h"
#include "session/command/SaveFilm.h"
#include "session/film/ReadyFilms.h"

namespace velum::session::detail {

namespace {

using scene::Scene;

/// The track's path for a field that somebody names. @throw ArgumentError where a film cannot change it
std::string keyPath(const Scene& scene, const std::string& field) {
  std::string path = field;
  // What a track makes by itself, such as the row of a type, need not be there yet.
  try {
    path = scene::stablePath(scene, field);
  } catch (const ArgumentError&) {
    if (!scene::findTrack(scene.timeline, field)) scene::valueAt(scene, field);
  }
  if (scene::findTrack(scene.timeline, path)) return path;
  if (!scene::canChange(path)) throw ArgumentError(fmt::format("{} cannot change in a film", field));
  return path;
}

scene::Track& trackOf(Scene& scene, const std::string& field) {
  scene::Track* track = scene::findTrack(scene.timeline, keyPath(scene, field));
  if (!track) throw ArgumentError(fmt::format("{} has no keys", field));
  return *track;
}

std::size_t keyOf(const scene::Track& track, double time) {
  if (auto key = scene::keyAt(track, time)) return *key;
  throw ArgumentError(fmt::format("{} has no key at {:g} s", track.path, time));
}

/// When a key is, and by how much the film turns the eye in what is seen.
struct KeyPlace {
  double time = 0.0, orbitDeg = 0.0;
};

/// An edit whose time may be the playhead's, which is no part of a scene.
template <class Arguments>
void editAt(Document& document, const char* step, void (*change)(Scene&, const Arguments&, KeyPlace), Arguments call) {
  auto playhead = document.playhead();
  if (call.time < 0.0) call.time = playhead.value_or(0.0);
  KeyPlace at{call.time, playhead ? scene::orbitAt(document.scene(), *playhead) : 0.0};
  document.edit(
      step, [&](Scene& scene) { change(scene, call, at); }, false,
      std::string(Arguments::kName) + " " + writeArguments<Arguments>(std::any(call)));
}

template <class Arguments>
Command keyRow(std::string_view doc, std::string_view example, const char* step,
               void (*change)(Scene&, const Arguments&, KeyPlace)) {
  return actRow<Arguments>(doc, example, [=](Session& session, const Arguments& asked, Progress&) {
    editAt(session.document(), step, change, asked);
    return std::vector<std::string>();
  });
}

constexpr const char *kSetKey = "Set key", *kRemoveKey = "Remove key";

void setFilmKey(Scene& scene, const SetFilmKey& a, KeyPlace at) {
  std::string path = keyPath(scene, a.field);
  Scene valued = scene;
  if (at.orbitDeg != 0.0) valued.camera = scene::turntable(valued.camera, -glm::radians(at.orbitDeg));
  if (!a.value.empty()) scene::setField(valued, path, a.value);
  scene::setKey(scene.timeline, path, at.time, scene::valueAt(valued, path));
  scene.timeline.duration = std::max(scene.timeline.duration, at.time);
}

void removeFilmKey(Scene& scene, const RemoveFilmKey& a, KeyPlace at) {
  scene::Track& track = trackOf(scene, a.field);
  keyOf(track, at.time);
  scene::removeKeys(scene.timeline, std::string(track.path), at.time, at.time);
}

void moveFilmKey(Scene& scene, const MoveFilmKey& a) {
  scene::Track& track = trackOf(scene, a.field);
  std::size_t place = keyOf(track, a.time);
  scene::Key key = track.keys[place];
  scene::moveKey(track, place, a.to);
  if (a.copy) scene::setKey(scene.timeline, track.path, key.time, key.value).ease = key.ease;
}

int idOfCut(const Scene& scene, const std::string& cut) { return cut.empty() ? 0 : cutOf(scene, cut).id; }

std::vector<Command> readyFilms() {
  return {
      editRow<AddTurn>("Ready-made film: the eye goes round.", "film.turn 6 2", "Film: turn",
                       [](Scene& scene, const AddTurn& a) {
                         addTurn(scene, {a.start, a.seconds}, a.turns, a.gently);
                       }),
      editRow<AddCutting>("Ready-made film: cuts come in from where the data ends.", "film.cut 5 \"Plane 1\"",
                          "Film: cut",
                          [](Scene& scene, const AddCutting& a) {
                            addCutting(scene, {a.start, a.seconds}, idOfCut(scene, a.cut), a.back);
                          }),
      editRow<AddSinking>("Ready-made film: membranes sink in.", "film.membrane 4", "Film: membrane",
                          [](Scene& scene, const AddSinking& a) {
                            addSinking(scene, {a.start, a.seconds}, idOfCut(scene, a.cut), a.back);
                          }),
      editRow<AddPulling>("Ready-made film: structures come out of the cuts one after the other.", "film.pull 6 0.5",
                          "Film: pull out",
                          [](Scene& scene, const AddPulling& a) {
                            addPulling(scene, {a.start, a.seconds}, a.overlap, a.hold);
                          }),
      editRow<AddEqualizing>(
          "Ready-made film: a model from whole, over all that its cuts can take, to what they leave.",
          "film.equalize 12", "Film: equalize",
          [](Scene& scene, const AddEqualizing& a) {
            addEqualizing(scene, {a.start, a.seconds}, a.hold);
          }),
      editRow<AddFlight>("Ready-made film: the eye goes to a structure.", "film.fly aorta 4", "Film: fly",
                         [](Scene& scene, const AddFlight& a) {
                           const auto& list = scene.labels.structures;
                           int id = list[scene::detail::findByKey(list, a.structure, "labels.structures")].id;
                           addFlight(scene, {a.start, a.seconds}, id, a.fill);
                         }),
      editRow<AddTimeSteps>("Ready-made film: the volume goes through its time steps.", "film.time 6 2",
                            "Film: time steps",
                            [](Scene& scene, const AddTimeSteps& a) {
                              addTimeSteps(scene, {a.start, a.seconds}, a.rounds);
                            }),
      editRow<AddComparison>("Ready-made film: whole, then cut open.", "film.compare 8", "Film: before and after",
                             [](Scene& scene, const AddComparison& a) {
                               addComparison(scene, {a.start, a.seconds}, a.hold);
                             }),
      editRow<AddTitle>("Ready-made film: words come and go.", "film.title \"The heart, cut open\" 1 3", "Film: title",
                        [](Scene& scene, const AddTitle& a) {
                          addTitle(scene, {a.start, a.seconds}, a.text, a.fade, a.place);
                        }),
  };
}

}  // namespace

std::vector<Command> filmCommands() {
  std::vector<Command> rows{
      keyRow<SetFilmKey>("Makes a key of a field: what the field is at a time of the film.", "film.key camera 2.5",
                         kSetKey, setFilmKey),
      keyRow<RemoveFilmKey>("Removes a key.", "film.removeKey camera 2.5", kRemoveKey, removeFilmKey),
      keyRow<EaseFilmKey>("Says how a field gets from a key to the next one.", "film.ease camera 0 both", "Ease key",
                          [](Scene& scene, const EaseFilmKey& a, KeyPlace at) {
                            scene::Track& track = trackOf(scene, a.field);
                            track.keys[keyOf(track, at.time)].ease = a.ease;
                          }),
      editRow<MoveFilmKey>("Moves a key to another time, or copies it.", "film.moveKey camera.fieldOfViewDeg 2.5 4",
                           "Move key", [](Scene& scene, const MoveFilmKey& a) { moveFilmKey(scene, a); }),
      editRow<RemoveFilmTrack>("Removes all keys of a field.", "film.removeTrack camera.fieldOfViewDeg", "Remove track",
                               [](Scene& scene, const RemoveFilmTrack& a) {
                                 std::string path = trackOf(scene, a.field).path;
                                 scene::removeKeys(scene.timeline, path, 0.0, scene::kLongestFilm);
                               }),
      editRow<ClearFilm>("Removes all keys.", "film.clear", "Clear film",
                         [](Scene& scene, const ClearFilm&) { scene.timeline.tracks.clear(); }),
      actRow<MovePlayhead>("Shows the scene at a time of its film; changes nothing.", "film.at 2.5",
                           [](Session& session, const MovePlayhead& a, Progress&) {
                             session.document().setPlayhead(a.time < 0.0 ? std::nullopt : std::optional(a.time));
                             return std::vector<std::string>();
                           }),
      actRow<RecordFilm>("Makes keys of whatever is changed at the playhead from now on.", "film.record",
                         [](Session& session, const RecordFilm& a, Progress&) {
                           if (a.on && !session.document().playhead()) session.document().setPlayhead(0.0);
                           session.document().setRecording(a.on);
                           return std::vector<std::string>();
                         }),
  };
  rows.push_back(actRow<SaveFilm>("Draws the film of the scene, and writes it as a video or as frames.",
                                  "film.save turn.mp4 640x480", saveFilm));
  for (Command& row : readyFilms()) rows.push_back(std::move(row));
  return rows;
}

}  // namespace velum::session::detail

namespace velum::session {

void editKey(Document& document, const SetFilmKey& call) {
  detail::editAt(document, detail::kSetKey, detail::setFilmKey, call);
}
void editKey(Document& document, const RemoveFilmKey& call) {
  detail::editAt(document, detail::kRemoveKey, detail::removeFilmKey, call);
}

}  // namespace velum::session
