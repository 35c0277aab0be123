#include "session/command/SaveFilm.h"

#include <fmt/format.h>

#include <filesystem>

#include "core/Error.h"
#include "core/Log.h"
#include "scene/timeline/SceneAt.h"
#include "session/Session.h"
#include "session/command/Command.h"
#include "session/film/FilmDrawer.h"
#include "session/film/ReadyFilms.h"

namespace velum::session {

namespace {

/// A ready-made film as the command of its name adds it: "turn turns=2".
scene::Scene withNamedFilm(const scene::Scene& scene, const std::string& text, double seconds, Progress& progress) {
  std::string name = text.substr(0, text.find(' '));
  if (!enumValue<ReadyFilm>(name))
    throw ArgumentError(fmt::format("animate {}: not one of {}", name, fmt::join(EnumNames<ReadyFilm>::kNames, ", ")));
  std::string line = "film." + text;
  if (seconds > 0.0 && text.find("seconds=") == text.npos) line += fmt::format(" seconds={:.17g}", seconds);
  return editOf(scene, parseCall(line), progress).after;
}

}  // namespace

std::optional<scene::SectionKind> sectionNamed(const std::string& name) {
  if (name.empty()) return std::nullopt;
  if (auto section = enumValue<scene::SectionKind>(name)) return section;
  throw ArgumentError(
      fmt::format("section '{}' is not one of {}", name, fmt::join(EnumNames<scene::SectionKind>::kNames, ", ")));
}

FilmOutput outputOf(const SaveFilm& asked) {
  if (asked.path.empty()) throw ArgumentError("a path is missing");
  FilmOutput output;
  output.path = std::filesystem::absolute(asked.path).lexically_normal();
  if (asked.bits != 8 && asked.bits != 16) throw ArgumentError(fmt::format("bits {}: 8 or 16", asked.bits));
  output.picture = {
      parsePictureSize(asked.size, asked.dpi), asked.samples, asked.transparent, asked.layers, asked.dpi, asked.bits};
  output.section = sectionNamed(asked.section);
  if (output.section && asked.layers) throw ArgumentError("layers: a section has none; leave them out with section");
  output.quality = asked.quality;
  output.blur = asked.blur;
  output.shutter = asked.shutter;
  output.part = parsePart(asked.part);
  output.old = {asked.resume, asked.overwrite};
  return output;
}

scene::Scene filmedScene(const scene::Scene& scene, const SaveFilm& asked, Progress& progress) {
  bool hasOwn = !scene.timeline.tracks.empty() && asked.animate.empty();
  if (hasOwn && asked.seconds > 0.0)
    throw ArgumentError(fmt::format(
        "seconds: the scene has a film of its own, of {:g} s; set timeline.duration, timeline.rangeStart or "
        "timeline.rangeEnd, or choose another film with animate",
        scene.timeline.duration));
  if (hasOwn) return scene;
  scene::Scene filmed = scene;
  filmed.timeline.tracks.clear();
  std::vector<std::string> films = asked.animate;
  if (films.empty()) films.emplace_back(enumName(usualFilm(scene)));
  for (const std::string& film : films) filmed = withNamedFilm(filmed, film, asked.seconds, progress);
  filmed.timeline.rangeStart = filmed.timeline.rangeEnd = 0.0;
  return filmed;
}

std::vector<std::string> filmNotes(const scene::Scene& scene, FilmOutput output) {
  std::vector<std::string> notes = scene::tracksThatDoNotFit(scene);
  output.framesPerSecond = scene.timeline.framesPerSecond;
  if (std::string note = filmNote(output); !note.empty()) notes.push_back(note);
  return notes;
}

namespace detail {

std::vector<std::string> saveFilm(Session& session, const SaveFilm& asked, Progress& progress) {
  FilmOutput output = outputOf(asked);
  expectFilmOutput(output);
  scene::Scene scene = filmedScene(session.scene(), asked, progress);
  std::vector<std::string> notes = filmNotes(scene, output);
  try {
    FilmReport report = drawFilm(session, scene, output, progress);
    progress.throwIfCancelled();
    if (std::string failed = failedFrames(report); !failed.empty()) throw InputError(failed);
  } catch (...) {
    // They may be why.
    for (const std::string& note : notes) log::warning(note);
    throw;
  }
  return notes;
}

}  // namespace detail

}  // namespace velum::session
