#include "render/RenderPicture.h"

#include <algorithm>
#include <string>
#include <utility>

#include "shared/instance.h"

namespace velum::render {

namespace {

/// A rectangle of one picture into another with the same channels.
void copyPart(const Image& from, glm::ivec2 fromCorner, glm::ivec2 size, glm::ivec2 toCorner, Image& to) {
  std::size_t channels = from.channels.size();
  auto placeIn = [&](const Image& image, glm::ivec2 at) {
    return std::ptrdiff_t((std::size_t(at.y) * std::size_t(image.width) + std::size_t(at.x)) * channels);
  };
  for (int y = 0; y < size.y; ++y)
    std::copy_n(from.pixels.begin() + placeIn(from, fromCorner + glm::ivec2(0, y)), std::size_t(size.x) * channels,
                to.pixels.begin() + placeIn(to, toCorner + glm::ivec2(0, y)));
}

/// By how much memory the data is made coarser.
std::pair<std::string, double> coarsenessOf(const Stats& stats) {
  double budget = stats.streaming.budgetBytes;  // of a streamed volume, whose words are those of a part
  return {budget > 0 ? std::string() : stats.reduction, budget};
}

}  // namespace

Image renderPicture(Renderer& renderer, const Frame& frame, const Layers& layers, int largestWindow,
                    Progress& progress) {
  Image whole;
  std::pair<std::string, double> coarseness;
  bool isPart = frame.windowSize != glm::ivec2(0);
  glm::ivec2 origin = frame.windowOrigin, size = isPart ? frame.windowSize : frame.pictureSize;
  int margin = isPart || std::max(size.x, size.y) > largestWindow ? windowMargin(frame) : 0;
  int inner = std::max(largestWindow - 2 * margin, (largestWindow + 1) / 2);
  int columns = (size.x + inner - 1) / inner, rows = (size.y + inner - 1) / inner;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      Frame part = frame;
      part.saysFaces = frame.saysFaces || layers.face;
      glm::ivec2 corner = glm::ivec2(column, row) * inner, wanted = glm::min(size - corner, glm::ivec2(inner));
      // How open a model lies is worked out for one pixel of a few, of the whole picture.
      part.windowOrigin = glm::max(origin + corner - margin, glm::ivec2(0)) / shared::kOpenStep * shared::kOpenStep;
      part.windowSize = glm::min(frame.pictureSize, origin + corner + wanted + margin) - part.windowOrigin;
      renderer.render(part, progress);
      Image image = renderer.read(layers);
      // The driver has run out of memory between two parts: all are to look alike.
      if (row + column == 0) coarseness = coarsenessOf(renderer.stats());
      if (coarsenessOf(renderer.stats()) != coarseness)
        return renderPicture(renderer, frame, layers, largestWindow, progress);
      if (columns * rows == 1 && !isPart) return image;
      if (whole.pixels.empty()) {
        whole = {size.x, size.y, image.channels, {}};
        whole.pixels.resize(std::size_t(size.x) * std::size_t(size.y) * image.channels.size());
      }
      copyPart(image, origin + corner - part.windowOrigin, wanted, corner, whole);
    }
  return whole;
}

}  // namespace velum::render
