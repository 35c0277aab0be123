#include "io/video/VideoWriter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/Error.h"
#include "core/FileName.h"
#include "core/ImageChannels.h"
#include "io/video/FedProgram.h"

namespace velum::io {

namespace {

using Arguments = std::vector<std::string>;
constexpr const char* kProgram = "ffmpeg";

struct VideoFormat {
  const char* extension;
  const char* muxer;      ///< ffmpeg's name of the format
  double worst, best;     ///< ffmpeg's -crf for quality 0 and 100
  bool hasAlpha, hasOdd;  ///< alpha; sides that are odd
  Arguments (*encoding)(bool transparent);
};

/// ffmpeg takes RGB for BT.601 unless it is told.
Arguments bt709(const char* pixels) {
  return {"-vf",
          fmt::format("scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+full_chroma_inp+bitexact,"
                      "format={}",
                      pixels),
          "-colorspace",
          "bt709",
          "-color_primaries",
          "bt709",
          "-color_trc",
          "bt709",
          "-color_range",
          "tv"};
}

Arguments withMore(Arguments words, const Arguments& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

Arguments encodeMp4(bool) {
  return withMore({"-c:v", "libx264", "-preset", "medium", "-movflags", "+faststart"}, bt709("yuv420p"));
}

Arguments encodeWebm(bool transparent) {
  Arguments words{"-c:v", "libvpx-vp9", "-b:v", "0", "-deadline", "good", "-cpu-used", "2", "-row-mt", "1"};
  // VP9 keeps alpha as a second stream of its own, whose frames must be those of the colours.
  if (transparent) words.insert(words.end(), {"-auto-alt-ref", "0"});
  return withMore(words, bt709(transparent ? "yuva420p" : "yuv420p"));
}

Arguments encodeGif(bool transparent) {
  return {"-filter_complex",
          fmt::format("split[seen][all];[all]palettegen=reserve_transparent={}[colors];[seen][colors]paletteuse",
                      int(transparent)),
          "-loop", "0"};
}

constexpr VideoFormat kFormats[] = {{".mp4", "mp4", 48, 8, false, false, encodeMp4},
                                    {".webm", "webm", 60, 4, true, false, encodeWebm},
                                    {".gif", "gif", 0, 0, true, true, encodeGif}};
constexpr double kFastestGif = 50.0;
/// By the cores of the machine ffmpeg would write other bytes on another one.
constexpr const char* kThreads = "8";

const VideoFormat* findVideoFormat(const std::filesystem::path& path) {
  std::string extension = lowerExtension(path);
  auto found = std::ranges::find(kFormats, extension, &VideoFormat::extension);
  return found == std::end(kFormats) ? nullptr : found;
}

const VideoFormat& videoFormatFor(const std::filesystem::path& path) {
  if (const VideoFormat* format = findVideoFormat(path)) return *format;
  throw InputError(fmt::format("{}: videos are written as .mp4, .webm or .gif", path.string()));
}

glm::ivec2 paddedSize(const VideoFormat& format, glm::ivec2 size) { return format.hasOdd ? size : (size + 1) / 2 * 2; }

Arguments argumentsFor(const VideoFormat& format, glm::ivec2 size, const VideoOptions& options,
                       const std::filesystem::path& file) {
  Arguments words{kProgram, "-nostdin", "-hide_banner", "-loglevel", "error"};
  words = withMore(words, {"-f", "rawvideo", "-pixel_format", options.transparent ? "rgba" : "rgb24", "-video_size",
                           fmt::format("{}x{}", size.x, size.y), "-framerate",
                           fmt::format("{:.6g}", options.framesPerSecond), "-i", "pipe:0"});
  words = withMore(words, {"-map_metadata", "-1", "-fflags", "+bitexact", "-threads", kThreads});
  words = withMore(words, format.encoding(options.transparent));
  if (format.worst > format.best)
    words = withMore(
        words, {"-crf", fmt::format("{}", std::lround(std::lerp(format.worst, format.best, options.quality / 100.0)))});
  // Whatever a folder is called, "file:" has ffmpeg take its name for one.
  return withMore(words, {"-f", format.muxer, "-y", "file:" + file.string()});
}

}  // namespace

bool isVideo(const std::filesystem::path& path) { return findVideoFormat(path) != nullptr; }

void expectVideo(const std::filesystem::path& path, const VideoOptions& options) {
  const VideoFormat& format = videoFormatFor(path);
  if (!(options.framesPerSecond > 0.0 && options.framesPerSecond <= 1000.0))
    throw ArgumentError(
        fmt::format("{:g} frames a second: expected more than 0, at most 1000", options.framesPerSecond));
  if (options.quality < 0 || options.quality > 100)
    throw ArgumentError(fmt::format("quality {}: expected 0 to 100", options.quality));
  if (options.transparent && !format.hasAlpha)
    throw ArgumentError(
        fmt::format("{}: an {} has no alpha; write .webm, .gif or pictures", path.string(), format.extension));
  if (std::string_view(format.extension) == ".gif" && options.framesPerSecond > kFastestGif)
    throw ArgumentError(fmt::format("{}: programs show no more than {:g} frames a second of a .gif, not {:g}",
                                    path.string(), kFastestGif, options.framesPerSecond));
  expectProgram(kProgram, kProgram);  // Debian's package has its name
}

std::string videoNote(const std::filesystem::path& path, const VideoOptions& options) {
  if (std::string_view(videoFormatFor(path).extension) != ".gif") return {};
  double hundredths = 100.0 / options.framesPerSecond;
  if (std::abs(hundredths - std::round(hundredths)) < 1e-6) return {};
  return fmt::format("{}: a .gif counts in hundredths of a second, so frames take {:g} or {:g} of them in turn",
                     path.string(), std::floor(hundredths), std::ceil(hundredths));
}

VideoWriter::VideoWriter(const std::filesystem::path& path, glm::ivec2 size, const VideoOptions& options)
    : mSize(size),
      mPadded(paddedSize(videoFormatFor(path), size)),
      mChannels{"R", "G", "B"},
      mFile((expectVideo(path, options), path)) {
  if (options.transparent) mChannels.push_back("A");
  mFrame.resize(std::size_t(mPadded.x) * std::size_t(mPadded.y) * mChannels.size());
  mProgram =
      std::make_unique<FedProgram>(argumentsFor(videoFormatFor(path), mPadded, options, mFile.temporary()), kProgram);
}

VideoWriter::~VideoWriter() = default;

void VideoWriter::write(const Image& image) {
  if (image.width != mSize.x || image.height != mSize.y)
    throw InputError(fmt::format("{}: a frame of {} x {} pixels does not fit into a video of {} x {}",
                                 mFile.target().string(), image.width, image.height, mSize.x, mSize.y));
  std::vector<std::size_t> columns;
  for (const std::string& name : mChannels) {
    std::ptrdiff_t column = channelIndex(image, name);
    if (column < 0) throw InputError(fmt::format("{}: a frame has no channel {}", mFile.target().string(), name));
    columns.push_back(std::size_t(column));
  }
  std::byte* out = mFrame.data();
  for (int y = 0; y < mPadded.y; ++y)
    for (int x = 0; x < mPadded.x; ++x) {
      std::size_t pixel =
          std::size_t(std::min(y, mSize.y - 1)) * std::size_t(mSize.x) + std::size_t(std::min(x, mSize.x - 1));
      for (std::size_t column : columns)
        *out++ = std::byte(wholeSample<std::uint8_t>(image.pixels[pixel * image.channels.size() + column]));
    }
  repeat();
}

void VideoWriter::repeat() {
  if (!mProgram->write(mFrame)) fail();
}

void VideoWriter::finish() {
  if (!mProgram->end()) fail();
  mFile.commit();
}

void VideoWriter::fail() {
  mProgram->end();
  std::string why = mProgram->lastLine();
  throw InputError(fmt::format("{}: ffmpeg has failed{}{}", mFile.target().string(), why.empty() ? "" : ": ", why));
}

}  // namespace velum::io
