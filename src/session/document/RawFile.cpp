#include "session/document/RawFile.h"

#include "io/volumes/RawGuess.h"
#include "session/document/Series.h"

namespace velum::session {

bool needsLayout(const std::filesystem::path& path) { return io::needsLayout(path); }

std::vector<scene::RawLayout> guessLayouts(const std::filesystem::path& path, Progress& progress) {
  return io::guessLayouts(path, progress);
}

double bytesOf(const scene::RawLayout& layout) { return io::bytesOf(layout); }

Image rawPicture(const scene::Source& source, int z, int size) {
  return planePicture(io::readRawPlane(source, z), size);
}

}  // namespace velum::session
