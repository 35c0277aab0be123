#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/Image.h"
#include "core/Task.h"
#include "scene/Scene.h"
#include "session/film/FrameFolder.h"
#include "session/picture/Picture.h"

namespace velum::session {

/// A frame that is drawn, and the scene that is saved in its picture.
struct FilmFrame {
  Image image;
  scene::Scene scene;
};

/// Where the frames of a film come from.
struct FrameSource {
  int count = 0;
  /// Draws a moment of the film. @param frame  0 <= frame < count, never below that of the call before; frames may be
  /// left out  @param share  of the time from frame to frame, from the frame's own moment, see subFrameShare(); grows
  /// from call to call of one frame
  std::function<FilmFrame(int frame, double share, Progress& progress)> draw;
};

/// What becomes of the frames.
struct FilmOutput {
  std::filesystem::path path;  ///< a video (io::isVideo()), or what FrameNames takes
  PictureOptions picture;
  std::optional<scene::SectionKind> section = {};  ///< none: the 3D picture
  double framesPerSecond = 25.0;
  int quality = 75;      ///< of a video, see io::VideoOptions
  int blur = 1;          ///< pictures of which a frame is the mean, 1: none is blurred
  double shutter = 0.5;  ///< see subFrameShare()
  Part part;
  FrameFolder::Old old;
};

/// What became of a film, or of a part of it.
struct FilmReport {
  int frames = 0;  ///< of the part
  int drawn = 0;
  int kept = 0;                                     ///< were there already
  std::vector<std::pair<int, std::string>> failed;  ///< frame and why
  bool isStopped = false;  ///< by Progress::cancel(): what was drawn until then is there, a video of so many frames
};

/// Which frames are missing and why, for people: "2 of 9 frames could not be drawn: 3 and 7 (why the first could not)";
/// empty: none is.
std::string failedFrames(const FilmReport& report);

/// @throw ArgumentError for a blur that cannot be
void expectBlur(const FilmOutput& output);
/// Checks, before any data is read, whether a film could be written so. @throw ArgumentError, InputError
void expectFilmOutput(const FilmOutput& output);

/// What the file cannot do of what is asked for, in a sentence for people; empty: it can do all.
std::string filmNote(const FilmOutput& output);

/// The command line that makes the film of a scene file without a window: the same bytes on the same driver.
std::string filmCommand(const std::filesystem::path& scene, const FilmOutput& output);

/// What the frames of a film depend on, for its manifest. @param scene  without what moves in it  @param renderer  the
/// driver that draws, and the program's version
FilmIdentity filmIdentity(const scene::Scene& scene, const FilmOutput& output, const std::string& renderer);

/// A frame as it is written: the mean of the pictures while the shutter is open. @throw what the source throws
FilmFrame drawFrame(const FrameSource& source, const FilmOutput& output, int frame, Progress& progress);

/// Draws the frames of a part, one after the other, and writes each before the next is begun, so that time and memory
/// are the same for each. A frame that cannot be drawn or written is noted, and the others go on; a video shows the
/// frame before it for so long. Of a cancelled film what was drawn is kept, see FilmReport.
/// @param progress  is told "Frame 12 of 240, 3 min left"
/// @throw InputError when ffmpeg has failed, the manifest cannot be written, or the frames there are another film's
FilmReport makeFilm(const FrameSource& source, const FilmOutput& output, const FilmIdentity& film, Progress& progress);

/// A time as people say it: "40 s", "3 min", "2 h 10 min".
std::string sayTime(double seconds);

}  // namespace velum::session
