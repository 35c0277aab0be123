#include "session/film/MakeFilm.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include "core/Clock.h"
#include "core/Error.h"
#include "io/images/ImageFile.h"
#include "io/stores/Crc32c.h"
#include "io/video/VideoWriter.h"
#include "session/document/Open.h"
#include "session/film/SubFrames.h"

namespace velum::session {

namespace {

constexpr int kMostSubFrames = 256;

io::VideoOptions videoOptionsOf(const FilmOutput& output) {
  return {output.framesPerSecond, output.quality, output.picture.transparent};
}

/// Where the frames go: to a folder, or to a video.
class FilmSink {
 public:
  FilmSink(const FilmOutput& output, const FilmManifest& film, Progress& progress) : mOutput(output) {
    if (io::isVideo(output.path))
      mVideo = std::make_unique<io::VideoWriter>(output.path, output.picture.size, videoOptionsOf(output));
    else
      mFolder = std::make_unique<FrameFolder>(FrameNames(output.path), output.part, film, output.old, progress);
  }

  bool has(int frame) const { return mFolder && mFolder->has(frame); }

  /// @param draw  makes the frame  @return why there is no frame; empty where there is
  template <class Draw>
  std::string add(int frame, Draw draw) {
    auto start = Clock::now();
    std::string error;
    FilmFrame drawn;
    std::vector<std::filesystem::path> files;
    try {
      drawn = draw();
      if (mFolder) files = savePicture(drawn.image, drawn.scene, mOutput.picture, mFolder->place(frame));
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& why) {
      error = why.what();
    }
    if (mVideo) {
      error.empty() ? mVideo->write(drawn.image) : mVideo->repeat();
      ++mVideoFrames;
    } else if (error.empty()) {
      mFolder->add(frame, msSince(start), files);
    } else {
      mFolder->addFailure(frame, msSince(start), error);
    }
    return error;
  }

  /// An empty video is none.
  void finish() {
    if (mVideo && mVideoFrames > 0) mVideo->finish();
  }

 private:
  const FilmOutput& mOutput;
  std::unique_ptr<io::VideoWriter> mVideo;
  std::unique_ptr<FrameFolder> mFolder;
  int mVideoFrames = 0;
};

}  // namespace

std::string sayTime(double seconds) {
  if (seconds < 59.5) return fmt::format("{} s", std::max(1l, std::lround(seconds)));
  long minutes = std::lround(seconds / 60.0);
  if (minutes < 60) return fmt::format("{} min", minutes);
  return fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

void expectBlur(const FilmOutput& output) {
  if (output.blur < 1 || output.blur > kMostSubFrames)
    throw ArgumentError(fmt::format("{} pictures for a frame: expected 1 to {}", output.blur, kMostSubFrames));
  if (!(output.shutter >= 0.0 && output.shutter <= 1.0))
    throw ArgumentError(fmt::format("shutter {:g}: expected 0 to 1", output.shutter));
}

void expectFilmOutput(const FilmOutput& output) {
  if (output.path.empty() || output.path == "-")
    throw ArgumentError("a film needs a name, such as turn.mp4 or frames/");
  expectBlur(output);
  if (!io::isVideo(output.path)) {
    FrameNames names(output.path);
    try {
      io::expectImageFormat(names.frame(0));
    } catch (const InputError&) {
      throw InputError(fmt::format(
          "{}: films are written as .mp4, .webm or .gif, as pictures in .png, .tif or .exr, or into a folder",
          output.path.string()));
    }
    if (!names.isFolder() || std::filesystem::exists(names.folder())) expectPictureFile(names.frame(0));
    return;
  }
  const char* name = output.picture.layers     ? "layers"
                     : output.picture.bits > 8 ? "16 bits"
                     : output.old.resume       ? "frames to go on from"
                     : output.part.parts > 1   ? "parts"
                                               : nullptr;
  if (name)
    throw ArgumentError(fmt::format("{}: a video has no {}; write the frames to a folder, then the film of them",
                                    output.path.string(), name));
  io::expectVideo(output.path, videoOptionsOf(output));
  expectReplaceable(output.path);
}

std::string filmNote(const FilmOutput& output) {
  return io::isVideo(output.path) ? io::videoNote(output.path, videoOptionsOf(output)) : "";
}

std::string filmCommand(const std::filesystem::path& scene, const FilmOutput& output) {
  std::string command = pictureCommand(scene, output.picture, output.path, "film");
  const FilmOutput usual;
  if (io::isVideo(output.path) && output.quality != usual.quality)
    command += fmt::format(" --quality {}", output.quality);
  if (output.blur != usual.blur) command += fmt::format(" --blur {}", output.blur);
  if (output.shutter != usual.shutter) command += fmt::format(" --shutter {:g}", output.shutter);
  return command;
}

std::string failedFrames(const FilmReport& report) {
  if (report.failed.empty()) return {};
  if (report.frames == 1) return fmt::format("the only frame could not be drawn ({})", report.failed.front().second);
  std::vector<int> frames;
  for (const auto& [frame, why] : report.failed) frames.push_back(frame);
  return fmt::format("{} of {} frames could not be drawn: {} ({})", frames.size(), report.frames, rangesOf(frames),
                     report.failed.front().second);
}

FilmIdentity filmIdentity(const scene::Scene& scene, const FilmOutput& output, const std::string& renderer) {
  const PictureOptions& picture = output.picture;
  std::string text = sceneTextFor(sceneForPicture(scene, picture), FrameNames(output.path).frame(0));
  FilmIdentity film{
      {"renderer", renderer},
      {"size", fmt::format("{}x{}", picture.size.x, picture.size.y)},
      {"pictures", fmt::format("{} bits{}{}", picture.bits, picture.layers ? ", layers" : "",
                               picture.dpi > 0 ? fmt::format(", {:g} dpi", picture.dpi) : "")},
      {"blur", output.blur > 1 ? fmt::format("{} of {:g}", output.blur, output.shutter) : "none"},
      {"scene", fmt::format("{:08x} ({} bytes)", io::crc32c(std::as_bytes(std::span(text))), text.size())}};
  return film;
}

FilmFrame drawFrame(const FrameSource& source, const FilmOutput& output, int frame, Progress& progress) {
  if (output.blur == 1) return source.draw(frame, 0.0, progress);
  FilmFrame out;
  MeanImage mean;
  for (int i = 0; i < output.blur; ++i) {
    FilmFrame one = source.draw(frame, subFrameShare(i, output.blur, output.shutter), progress);
    bool isMiddle = i == middleSubFrame(output.blur);
    mean.add(one.image, isMiddle);
    if (isMiddle) out.scene = std::move(one.scene);
  }
  out.image = mean.mean();
  return out;
}

FilmReport makeFilm(const FrameSource& source, const FilmOutput& output, const FilmIdentity& film, Progress& progress) {
  expectFilmOutput(output);
  FilmReport report;
  FilmSink sink(output, {film, source.count, output.framesPerSecond, {}}, progress);
  int first = output.part.firstOf(source.count), end = output.part.endOf(source.count);
  report.frames = end - first;
  for (int i = first; i < end; ++i) report.kept += sink.has(i);
  // It is told which frame is drawn, not how far each is.
  Progress quiet([&](double, const std::string&) { progress.throwIfCancelled(); });
  auto start = Clock::now();
  int tried = 0, toDraw = report.frames - report.kept;
  try {
    for (int i = first; i < end; ++i) {
      if (sink.has(i)) continue;
      double leftS = tried > 0 ? msSince(start) / 1e3 / tried * (toDraw - tried) : 0.0;
      progress.report(double(report.kept + tried) / report.frames,
                      fmt::format("Frame {} of {}{}", i + 1, source.count,
                                  tried > 0 ? fmt::format(", {} left", sayTime(leftS)) : ""));
      std::string error = sink.add(i, [&] { return drawFrame(source, output, i, quiet); });
      ++tried;
      if (error.empty())
        ++report.drawn;
      else
        report.failed.emplace_back(i, error);
    }
  } catch (const Cancelled&) {
    report.isStopped = true;
  }
  sink.finish();
  return report;
}

}  // namespace velum::session
