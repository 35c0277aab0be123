#pragma once
#include <cstddef>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "core/Image.h"
#include "core/ReplaceFile.h"

namespace velum::io {

/// How a video is written.
struct VideoOptions {
  double framesPerSecond = 25.0;  ///< above 0, at most 1000
  int quality = 75;               ///< 0..100: how much of the pictures is kept; a .gif has no choice
  bool transparent = false;       ///< keeps alpha, straight: in .webm, and as on or off in .gif
};

/// True where a path's extension is one that VideoWriter writes: .mp4, .webm, .gif.
bool isVideo(const std::filesystem::path& path);

/// Checks, before any frame is drawn, whether a video could be written so. @throw InputError for an extension that is
/// unknown, and where ffmpeg is not installed, ArgumentError for options that the format does not have
void expectVideo(const std::filesystem::path& path, const VideoOptions& options);

/// What the format cannot do of what is asked for, in a sentence for people; empty: it can do all.
std::string videoNote(const std::filesystem::path& path, const VideoOptions& options);

class FedProgram;

/// Writes a video, frame after frame, by the program `ffmpeg`, which reads the frames from a pipe: .mp4 (H.264), .webm
/// (VP9), both in 8 bits of BT.709 with half of the colour's resolution and so tagged, or .gif (256 colours for the
/// whole film, which ffmpeg chooses at the end: it holds all frames until then; repeats for ever). Sides that are odd
/// get their last row or column twice, as these formats have even ones. The file is there at finish(), whole, in place
/// of an old one; without finish() nothing is left, and ffmpeg is ended. The same frames give the same bytes with the
/// same ffmpeg. One thread at a time.
class VideoWriter {
 public:
  /// @param size  of all frames, pixels  @throw InputError when ffmpeg is not installed, and as ReplaceFile; what
  /// expectVideo() throws
  VideoWriter(const std::filesystem::path& path, glm::ivec2 size, const VideoOptions& options);
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  /// Appends a frame, and waits until ffmpeg has taken it. @param image  R, G, B, A as io::writeImage() takes them
  /// @throw InputError with ffmpeg's last words when ffmpeg has failed, and for an image of another size
  void write(const Image& image);
  /// Appends the last frame once more; black where there was none. @throw InputError as write()
  void repeat();
  /// Ends the video and puts it in its place. Once, after a frame at least. @throw InputError as write(), and when the
  /// disk refuses
  void finish();

 private:
  [[noreturn]] void fail();

  glm::ivec2 mSize, mPadded;
  std::vector<std::string> mChannels;
  std::vector<std::byte> mFrame;  ///< [mPadded.y][mPadded.x][channels]
  ReplaceFile mFile;
  std::unique_ptr<FedProgram> mProgram;
};

}  // namespace velum::io
