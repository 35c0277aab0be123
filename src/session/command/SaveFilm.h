#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/Fields.h"
#include "core/Task.h"
#include "scene/Timeline.h"
#include "session/film/MakeFilm.h"

/// The command that draws a film and writes it: what `velum-batch film` does, for scripts and Python.
namespace velum::session {

class Session;

struct SaveFilm {
  static constexpr std::string_view kName = "film.save";
  std::string path, size = "1280x720";
  std::vector<std::string> animate;
  double seconds = 0.0;
  std::string section;
  int samples = 0;
  bool transparent = false, layers = false;
  double dpi = 0.0;
  int bits = 8, quality = FilmOutput{}.quality, blur = FilmOutput{}.blur;
  double shutter = FilmOutput{}.shutter;
  std::string part = "1/1";
  bool resume = false, overwrite = false;
  static void fields(auto& o, auto& visit) {
    visit("path", o.path,
          FieldInfo{
              "", {}, "A video .mp4, .webm or .gif; a folder FRAMES/ of pictures; or pictures turn.png, .tif, .exr."});
    visit("size", o.size, FieldInfo{"", {}, "WIDTHxHEIGHT in pixels, or with a unit: 12x8cm."});
    visit("animate", o.animate,
          FieldInfo{"",
                    {},
                    "Ready-made films in the place of the scene's own, as turn or \"turn turns=2\"; nothing: its own, "
                    "else once round or through the time steps."});
    visit(
        "seconds", o.seconds,
        FieldInfo{"s", {0, scene::kLongestFilm}, "How long a ready-made film lasts; 0: as long as it does by itself."});
    visit("section", o.section, FieldInfo{"", {}, "In the place of the 3D picture: axial, coronal or sagittal."});
    visit("samples", o.samples, FieldInfo{"", {0, 256}, "Pictures that are averaged; 0: as the scene says."});
    visit("transparent", o.transparent, FieldInfo{"", {}, "No background, with alpha; not in .mp4."});
    visit("layers", o.layers, FieldInfo{"", {}, "Of frames also depth, normal, structure id and others."});
    visit("dpi", o.dpi, FieldInfo{"", {0, 10000}, "Pixels an inch in print; 0: nothing is said."});
    visit("bits", o.bits, FieldInfo{"", {8, 16}, "Of a sample of colour in frames: 8 or 16."});
    visit("quality", o.quality, FieldInfo{"", {0, 100}, "Of a video."});
    visit("blur", o.blur, FieldInfo{"", {1, 256}, "Blurs what moves: each frame is the mean of so many pictures."});
    visit("shutter", o.shutter, FieldInfo{"", {0, 1}, "The share of the time between frames that blur takes."});
    visit("part", o.part, FieldInfo{"", {}, "K/N: the K-th of N parts of the frames, for several machines."});
    visit("resume", o.resume, FieldInfo{"", {}, "On: draws only frames that are missing, broken or failed."});
    visit("overwrite", o.overwrite, FieldInfo{"", {}, "On: writes over the frames of another film."});
  }
};

/// The section of a name; none for no name: the 3D picture. @throw ArgumentError
std::optional<scene::SectionKind> sectionNamed(const std::string& name);
/// What the arguments say of the files. @throw ArgumentError
FilmOutput outputOf(const SaveFilm& asked);
/// The scene with the film that is asked for in its timeline: its own, or ready-made ones in its place. Any thread.
/// @throw ArgumentError where there is no such film
scene::Scene filmedScene(const scene::Scene& scene, const SaveFilm& asked, Progress& progress);
/// What of a film does not come out as it is meant, one line each, for people: tracks that do not fit its scene, what
/// the file cannot do. @param scene  with the film in its timeline
std::vector<std::string> filmNotes(const scene::Scene& scene, FilmOutput output);

namespace detail {
/// @return notes, one line each  @throw Cancelled when it was stopped: what was drawn until then is there; as of other
/// errors, the notes have been said then
std::vector<std::string> saveFilm(Session& session, const SaveFilm& asked, Progress& progress);
}  // namespace detail

}  // namespace velum::session
