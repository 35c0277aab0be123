#include "session/film/JoinFrames.h"

#include <fmt/format.h>

#include "core/Error.h"
#include "io/images/ImageFile.h"

namespace velum::session {

int joinFrames(const FrameNames& names, const std::filesystem::path& video, io::VideoOptions options,
               Progress& progress) {
  auto there = findFrames(names, {}, progress);
  if (!there) throw InputError(fmt::format("{}: there are no frames of a film", names.folder().string()));
  if (options.framesPerSecond == 0.0) options.framesPerSecond = there->film.framesPerSecond;
  io::expectVideo(video, options);
  int count = there->film.frames;
  std::vector<int> missing;
  for (int i = 0; i < count; ++i)
    if (there->pictures[std::size_t(i)].empty()) missing.push_back(i);
  if (!missing.empty())
    throw InputError(fmt::format("{}: {} of {} frames missing or broken: {}; draw them with --resume",
                                 names.folder().string(), missing.size(), count, rangesOf(missing)));
  std::optional<io::VideoWriter> writer;
  for (int i = 0; i < count; ++i) {
    progress.report(double(i) / count, fmt::format("Frame {} of {}", i + 1, count));
    Image image = io::readImage(names.folder() / there->pictures[std::size_t(i)]);
    if (!writer) writer.emplace(video, glm::ivec2(image.width, image.height), options);
    writer->write(image);
  }
  writer->finish();
  return count;
}

}  // namespace velum::session
