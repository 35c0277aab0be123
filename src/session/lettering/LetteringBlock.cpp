#include "session/lettering/LetteringBlock.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

#include "core/ImageChannels.h"

namespace velum::session {

namespace {

constexpr double kGlow = 0.75;      // how far a glow reaches, ems
constexpr double kGlowBlur = 0.15;  // radius of each of three blurs, ems
constexpr float kGlowGain = 3.2f, kGlowMost = 0.86f;
constexpr double kHalo = 0.13, kHaloOpacity = 0.75;  // of lines: on either side, ems

/// Means of 2 * radius + 1 values along a line of values. @param step  from one value to the next
void blurLine(float* line, int count, std::ptrdiff_t step, int radius, std::vector<float>& sums) {
  sums.assign(std::size_t(count) + 1, 0.0f);
  for (int i = 0; i < count; ++i) sums[std::size_t(i) + 1] = sums[std::size_t(i)] + line[i * step];
  for (int i = 0; i < count; ++i) {
    int from = std::max(0, i - radius), to = std::min(count, i + radius + 1);
    line[i * step] = (sums[std::size_t(to)] - sums[std::size_t(from)]) / float(2 * radius + 1);
  }
}

/// How much of the glow there is at each pixel, 0..1. @param covers  of what glows, 0..1
void blur(std::vector<float>& covers, glm::ivec2 size, int radius) {
  std::vector<float> sums;
  for (int pass = 0; pass < 3; ++pass) {
    for (int y = 0; y < size.y; ++y) blurLine(&covers[std::size_t(y) * std::size_t(size.x)], size.x, 1, radius, sums);
    for (int x = 0; x < size.x; ++x) blurLine(&covers[std::size_t(x)], size.y, size.x, radius, sums);
  }
}

std::uint8_t byteOf(float share) { return std::uint8_t(std::lround(255.0f * std::clamp(share, 0.0f, 1.0f))); }

/// Items with lines of the ground's colour around their lines and letters.
std::vector<vector::Item> withHalos(const LetteringBlock& block) {
  if (block.halo <= 0.0) return block.items;
  double width = 2.0 * kHalo * block.em;
  std::vector<vector::Item> halos, items = block.items;
  for (vector::Item& item : items) {
    if (auto* words = std::get_if<vector::Words>(&item); words)
      words->halo = vector::Pen{block.ground, width, kHaloOpacity * block.halo * words->opacity, {}};
    auto* shape = std::get_if<vector::Shape>(&item);
    if (!shape || !shape->pen) continue;
    vector::Pen pen{block.ground, shape->pen->width + width, kHaloOpacity * block.halo * shape->pen->opacity, {}};
    halos.push_back(vector::Shape{{}, shape->outlines, pen, {}});
  }
  halos.insert(halos.end(), items.begin(), items.end());
  return halos;
}

void fade(vector::Item& item, double opacity) {
  auto fadePen = [&](std::optional<vector::Pen>& pen) {
    if (pen) pen->opacity *= opacity;
  };
  if (auto* words = std::get_if<vector::Words>(&item)) {
    words->opacity *= opacity;
    fadePen(words->halo);
  } else if (auto* shape = std::get_if<vector::Shape>(&item)) {
    fadePen(shape->pen);
    if (shape->fill) shape->fill->opacity *= opacity;
  }
}

/// True where all is letters and areas, that glow; lines have halos, as they may go through all of the picture.
bool isGlowing(const LetteringBlock& block) {
  return block.halo > 0.0 && std::ranges::none_of(block.items, [](const vector::Item& item) {
           auto* shape = std::get_if<vector::Shape>(&item);
           return shape && shape->pen;
         });
}

/// A raster with so many empty pixels more on each side.
vector::Raster grown(const vector::Raster& raster, int by) {
  vector::Raster out{raster.corner - by, raster.size + 2 * by, {}};
  out.rgba.resize(4 * std::size_t(out.size.x) * std::size_t(out.size.y));
  std::size_t row = 4 * std::size_t(raster.size.x);
  for (int y = 0; y < raster.size.y; ++y)
    std::copy_n(&raster.rgba[std::size_t(y) * row], row,
                &out.rgba[4 * (std::size_t(y + by) * std::size_t(out.size.x) + std::size_t(by))]);
  return out;
}

/// Items over their glow, with the opacity of their block. @param glow  how strongly each pixel glows; empty: none does
vector::Raster withGlow(vector::Raster stamp, const std::vector<float>& glow, const LetteringBlock& block) {
  for (std::size_t i = 0; 4 * i < stamp.rgba.size(); ++i) {
    std::uint8_t* pixel = &stamp.rgba[4 * i];
    float under = glow.empty() ? 0.0f : float(block.halo) * std::min(kGlowMost, kGlowGain * glow[i]);
    under *= 1.0f - float(pixel[3]) / 255.0f;
    for (int c = 0; c < 4; ++c) {
      float ground = c < 3 ? std::clamp(block.ground[c], 0.0f, 1.0f) : 1.0f;
      pixel[c] = byteOf(float(block.opacity) * (float(pixel[c]) / 255.0f + under * ground));
    }
  }
  return stamp;
}

}  // namespace

vector::Raster stampOf(const LetteringBlock& block, glm::ivec2 picture) {
  if (!isGlowing(block)) return withGlow(vector::rasterOf(withHalos(block), picture), {}, block);
  vector::Raster items = vector::rasterOf(block.items, picture);
  if (items.size == glm::ivec2(0)) return items;
  vector::Raster stamp = grown(items, int(std::ceil(kGlow * block.em)));
  std::vector<float> glow;
  for (std::size_t i = 3; i < stamp.rgba.size(); i += 4) glow.push_back(float(stamp.rgba[i]) / 255.0f);
  blur(glow, stamp.size, std::max(1, int(std::lround(kGlowBlur * block.em))));
  return withGlow(std::move(stamp), glow, block);
}

void layOver(const std::vector<LetteringBlock>& blocks, Image& image) {
  const int red = channelIndex(image, "R"), green = channelIndex(image, "G"), blue = channelIndex(image, "B"),
            alpha = channelIndex(image, "A");
  const std::size_t channels = image.channels.size();
  glm::ivec2 picture(image.width, image.height);
  for (const LetteringBlock& block : blocks) {
    vector::Raster stamp = stampOf(block, picture);
    glm::ivec2 from = glm::max(stamp.corner, glm::ivec2(0)), to = glm::min(stamp.corner + stamp.size, picture);
    for (int y = from.y; y < to.y; ++y)
      for (int x = from.x; x < to.x; ++x) {
        glm::ivec2 own = glm::ivec2(x, y) - stamp.corner;
        const std::uint8_t* over =
            &stamp.rgba[4 * (std::size_t(own.y) * std::size_t(stamp.size.x) + std::size_t(own.x))];
        if (over[3] == 0) continue;
        float* pixel = &image.pixels[(std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * channels];
        float share = float(over[3]) / 255.0f, before = alpha < 0 ? 1.0f : pixel[alpha];
        float covers = share + before * (1.0f - share);
        auto lay = [&](int channel, std::uint8_t color) {
          if (channel >= 0)
            pixel[channel] = (float(color) / 255.0f + pixel[channel] * before * (1.0f - share)) / covers;
        };
        lay(red, over[0]), lay(green, over[1]), lay(blue, over[2]);
        if (alpha >= 0) pixel[alpha] = covers;
      }
  }
}

std::vector<vector::Layer> layersOf(const std::vector<LetteringBlock>& blocks) {
  std::vector<vector::Layer> layers;
  for (const LetteringBlock& block : blocks) {
    auto layer = std::ranges::find(layers, block.layer, &vector::Layer::name);
    if (layer == layers.end()) layer = layers.insert(layers.end(), vector::Layer{block.layer, {}});
    for (vector::Item& item : withHalos(block)) {
      fade(item, block.opacity);
      layer->items.push_back(std::move(item));
    }
  }
  return layers;
}

}  // namespace velum::session
