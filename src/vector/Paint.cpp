#include "vector/Paint.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "core/Assert.h"
#include "core/ImageChannels.h"
#include "vector/Bounds.h"
#include "vector/CairoDraw.h"
#include "vector/Typeface.h"

namespace velum::vector {
namespace {

/// Pixels are looked at in tiles; those that nothing touches are passed over.
constexpr int kTile = 32;
/// Pixels are painted in blocks, since an image of Cairo has an end.
constexpr int kBlock = 128 * kTile;

/// A rectangle of pixels, without its high end.
struct PixelBox {
  glm::ivec2 low{0}, high{0};

  bool isEmpty() const { return low.x >= high.x || low.y >= high.y; }
  glm::ivec2 size() const { return high - low; }
};

PixelBox common(const PixelBox& a, const PixelBox& b) { return {glm::max(a.low, b.low), glm::min(a.high, b.high)}; }

/// The pixels of a picture that a box touches.
PixelBox pixelsOf(Box box, double scale, glm::ivec2 size) {
  if (box.isEmpty()) return {};
  // Where Cairo rounds places, to 1/256, and flattens curves.
  constexpr double kSlack = 0.1;
  glm::dvec2 most(size);
  glm::dvec2 low = glm::clamp(glm::floor(box.low * scale - kSlack), glm::dvec2(0.0), most),
             high = glm::clamp(glm::ceil(box.high * scale + kSlack), glm::dvec2(0.0), most);
  return {glm::ivec2(low), glm::ivec2(high)};
}

/// An item, and which pixels of the picture it touches.
struct PlacedItem {
  const Item* item;
  PixelBox pixels;
};

/// Items on their way to the pixels of a picture.
class Painter {
 public:
  Painter(glm::ivec2 size, double scale)
      : mSize(size), mScale(scale), mTiles((size + kTile - 1) / kTile), mTouched(std::size_t(mTiles.x * mTiles.y)) {}

  void add(std::span<const Item> items) {
    for (const Item& item : items) add(item);
  }
  /// What the items touch.
  PixelBox pixels() const { return mPixels; }
  /// Paints, and calls use(box, row) for all boxes of pixels that are touched: row(y) has the pixels of a row, as Cairo
  /// has them, from the box's low end on.
  template <class Use>
  void paint(const Use& use);

 private:
  void add(const Item& item);
  bool isTouched(glm::ivec2 tile) const { return mTouched[std::size_t(tile.y * mTiles.x + tile.x)] != 0; }
  void draw(const PixelBox& block, cairo_t* cairo);

  glm::ivec2 mSize;
  double mScale;
  glm::ivec2 mTiles;
  std::vector<std::uint8_t> mTouched;  ///< [y][x] of tiles
  std::vector<PlacedItem> mItems;
  PixelBox mPixels;
  Typefaces mFaces;
};

void Painter::add(const Item& item) {
  PixelBox all;
  for (const Box& box : boxesOf(item, mFaces)) {
    PixelBox touched = pixelsOf(box, mScale, mSize);
    if (touched.isEmpty()) continue;
    all = all.isEmpty() ? touched : PixelBox{glm::min(all.low, touched.low), glm::max(all.high, touched.high)};
    for (int y = touched.low.y / kTile; y <= (touched.high.y - 1) / kTile; ++y)
      std::memset(&mTouched[std::size_t(y * mTiles.x + touched.low.x / kTile)], 1,
                  std::size_t((touched.high.x - 1) / kTile - touched.low.x / kTile + 1));
  }
  if (all.isEmpty()) return;
  mPixels = mItems.empty() ? all : PixelBox{glm::min(mPixels.low, all.low), glm::max(mPixels.high, all.high)};
  mItems.push_back({&item, all});
}

void Painter::draw(const PixelBox& block, cairo_t* cairo) {
  cairo_set_tolerance(cairo, 0.1);
  cairo_translate(cairo, -block.low.x, -block.low.y);
  cairo_scale(cairo, mScale, mScale);
  for (const PlacedItem& placed : mItems) {
    if (common(placed.pixels, block).isEmpty()) continue;
    if (auto* plate = std::get_if<Plate>(placed.item)) drawPlate(cairo, *plate);
    if (auto* shape = std::get_if<Shape>(placed.item)) drawShape(cairo, *shape);
    if (auto* words = std::get_if<Words>(placed.item)) drawLetters(cairo, *words, *mFaces.of(words->font));
  }
  expectDrawn(cairo);
}

template <class Use>
void Painter::paint(const Use& use) {
  for (int top = mPixels.low.y / kTile * kTile; top < mPixels.high.y; top += kBlock)
    for (int left = mPixels.low.x / kTile * kTile; left < mPixels.high.x; left += kBlock) {
      PixelBox block = common({{left, top}, {left + kBlock, top + kBlock}}, mPixels);
      std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
          cairo_image_surface_create(CAIRO_FORMAT_ARGB32, block.size().x, block.size().y), cairo_surface_destroy);
      std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo(cairo_create(surface.get()), cairo_destroy);
      draw(block, cairo.get());
      cairo_surface_flush(surface.get());
      const unsigned char* pixels = cairo_image_surface_get_data(surface.get());
      const std::ptrdiff_t stride = cairo_image_surface_get_stride(surface.get());
      for (int y = top; y < block.high.y; y += kTile)
        for (int x = left; x < block.high.x; x += kTile) {
          PixelBox box = common({{x, y}, {x + kTile, y + kTile}}, block);
          if (box.isEmpty() || !isTouched(glm::ivec2(x, y) / kTile)) continue;
          use(box, [&](int row) {
            return reinterpret_cast<const std::uint32_t*>(pixels + (row - block.low.y) * stride) + box.low.x -
                   block.low.x;
          });
        }
    }
}

/// The channels of a pixel of Cairo: R, G, B, A; premultiplied.
glm::uvec4 channelsOf(std::uint32_t pixel) {
  return {pixel >> 16 & 255u, pixel >> 8 & 255u, pixel & 255u, pixel >> 24};
}

void paintOver(Painter& painter, Image& image) {
  VELUM_ASSERT(!colorsOf(image).empty(), "a picture has the channels R, G and B");
  const ColorChannels channels = colorsOf(image).front();
  const std::size_t count = image.channels.size();
  painter.paint([&](const PixelBox& box, const auto& row) {
    for (int y = box.low.y; y < box.high.y; ++y) {
      const std::uint32_t* from = row(y);
      float* to = &image.pixels[(std::size_t(y) * std::size_t(image.width) + std::size_t(box.low.x)) * count];
      for (int x = box.low.x; x < box.high.x; ++x, ++from, to += count) {
        if (*from == 0) continue;
        glm::vec4 over = glm::vec4(channelsOf(*from)) / 255.0f;
        float below = channels.alpha < 0 ? 1.0f : to[channels.alpha], rest = below * (1.0f - over.a),
              alpha = over.a + rest;
        for (int i = 0; i < 3; ++i) {
          float& value = to[channels.color[std::size_t(i)]];
          value = (over[i] + rest * value) / alpha;
        }
        if (channels.alpha >= 0) to[channels.alpha] = alpha;
      }
    }
  });
}

Raster rasterOf(Painter& painter) {
  PixelBox all = painter.pixels();
  Raster raster{all.low, all.size(),
                std::vector<std::uint8_t>(4 * std::size_t(all.size().x) * std::size_t(all.size().y))};
  painter.paint([&](const PixelBox& box, const auto& row) {
    for (int y = box.low.y; y < box.high.y; ++y) {
      const std::uint32_t* from = row(y);
      glm::ivec2 at = glm::ivec2(box.low.x, y) - all.low;
      std::uint8_t* to = &raster.rgba[4 * (std::size_t(at.y) * std::size_t(all.size().x) + std::size_t(at.x))];
      for (int x = box.low.x; x < box.high.x; ++x, ++from) {
        glm::uvec4 channels = channelsOf(*from);
        for (int i = 0; i < 4; ++i) *to++ = std::uint8_t(channels[i]);
      }
    }
  });
  return raster;
}

}  // namespace

void paint(std::span<const Item> items, Image& image, double scale) {
  Painter painter({image.width, image.height}, scale);
  painter.add(items);
  paintOver(painter, image);
}

void paint(std::span<const Layer> layers, Image& image, double scale) {
  Painter painter({image.width, image.height}, scale);
  for (const Layer& layer : layers)
    if (!layer.isHidden) painter.add(layer.items);
  paintOver(painter, image);
}

Raster rasterOf(std::span<const Item> items, glm::ivec2 size, double scale) {
  Painter painter(size, scale);
  painter.add(items);
  return rasterOf(painter);
}

Raster rasterOf(std::span<const Layer> layers, glm::ivec2 size, double scale) {
  Painter painter(size, scale);
  for (const Layer& layer : layers)
    if (!layer.isHidden) painter.add(layer.items);
  return rasterOf(painter);
}

}  // namespace velum::vector
