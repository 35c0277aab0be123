#include "velum/render/RenderPicture.h"

#include <algorithm>

namespace velum::render {

Image renderPicture(Renderer& renderer, const Frame& frame, const Layers& layers, int largestWindow,
                    Progress& progress) {
  Image whole;
  glm::ivec2 size = frame.pictureSize;
  int columns = (size.x + largestWindow - 1) / largestWindow, rows = (size.y + largestWindow - 1) / largestWindow;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      Frame part = frame;
      part.windowOrigin = glm::ivec2(column, row) * largestWindow;
      part.windowSize = glm::min(size - part.windowOrigin, glm::ivec2(largestWindow));
      renderer.render(part, progress);
      Image image = renderer.read(layers);
      if (columns * rows == 1) return image;
      if (whole.pixels.empty()) {
        whole = {size.x, size.y, image.channels, {}};
        whole.pixels.resize(std::size_t(size.x) * std::size_t(size.y) * image.channels.size());
      }
      std::size_t rowFloats = std::size_t(image.width) * image.channels.size();
      for (int y = 0; y < image.height; ++y)
        std::copy_n(image.pixels.begin() + std::ptrdiff_t(std::size_t(y) * rowFloats), rowFloats,
                    whole.pixels.begin() + std::ptrdiff_t((std::size_t(y + part.windowOrigin.y) * std::size_t(size.x) +
                                                           std::size_t(part.windowOrigin.x)) *
                                                          image.channels.size()));
    }
  return whole;
}

}  // namespace velum::render
