#include "session/lettering/Mark.h"

#include <algorithm>

#include "core/ImageChannels.h"

namespace velum::session {

void layMarks(const std::vector<Mark>& marks, Image& image) {
  const int red = channelIndex(image, "R"), green = channelIndex(image, "G"), blue = channelIndex(image, "B"),
            alpha = channelIndex(image, "A");
  const std::size_t channels = image.channels.size();
  for (const Mark& mark : marks) {
    glm::ivec2 from = glm::max(mark.corner, glm::ivec2(0)),
               to = glm::min(mark.corner + mark.size, glm::ivec2(image.width, image.height));
    for (int y = from.y; y < to.y; ++y)
      for (int x = from.x; x < to.x; ++x) {
        glm::ivec2 own = glm::ivec2(x, y) - mark.corner;
        float share = float(mark.covers[std::size_t(own.y) * std::size_t(mark.size.x) + std::size_t(own.x)]) / 255.0f;
        if (share == 0.0f) continue;
        float* pixel = &image.pixels[(std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * channels];
        auto lay = [&](int channel, float value) {
          if (channel >= 0) pixel[channel] += share * (value - pixel[channel]);
        };
        lay(red, mark.color.r), lay(green, mark.color.g), lay(blue, mark.color.b), lay(alpha, 1.0f);
      }
  }
}

}  // namespace velum::session
