#include "session/lettering/Lettering.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "scene/Project.h"
#include "scene/Scene.h"
#include "scene/SectionPlane.h"
#include "scene/Units.h"
#include "session/lettering/Letters.h"
#include "session/section/SectionTool.h"

namespace velum::session {

namespace {

// Lengths, in ems.
constexpr double kMargin = 1.3, kLine = 1.5, kSwatch = 0.82, kSwatchGap = 0.5, kCapHeight = 0.72, kCorner = 0.16;
constexpr double kBarThickness = 0.22, kBarGap = 0.42, kGlow = 0.75, kBlockGap = 0.6;
constexpr double kWidestName = 0.36;                    // of the picture's width
constexpr double kLongestBar = 0.22;                    // of the picture's width
constexpr double kOutline = 0.05, kOutlineShare = 0.4;  // line around a colour that is near the ground's
constexpr double kLeastEm = 5.0;                        // pixels
constexpr double kGlowBlur = 0.15;                      // radius of each of three blurs, ems
constexpr float kGlowGain = 3.2f, kGlowMost = 0.86f;

const glm::vec3 kDarkInk(0.08f, 0.09f, 0.11f), kLightInk(0.96f, 0.97f, 0.98f);

bool isLeft(scene::Corner corner) { return corner == scene::Corner::TopLeft || corner == scene::Corner::BottomLeft; }
bool isTop(scene::Corner corner) { return corner == scene::Corner::TopLeft || corner == scene::Corner::TopRight; }

/// The colour before which things stand in a corner of the picture.
glm::vec3 groundOf(const scene::Scene& scene, scene::Corner corner) {
  if (scene.finish.paper != scene::Paper::None) return scene.finish.paperColor;
  return isTop(corner) ? scene.background.top : scene.background.bottom;
}

glm::vec3 inkOn(glm::vec3 ground) {
  // As light as the eye takes it: middle grey is 0.18 of white's light.
  glm::vec3 light = glm::pow(glm::clamp(ground, 0.0f, 1.0f), glm::vec3(2.2f));
  return glm::dot(light, glm::vec3(0.2126f, 0.7152f, 0.0722f)) > 0.18f ? kDarkInk : kLightInk;
}

/// Marks of one rectangle, for a part of the lettering.
class Block {
 public:
  /// @param corner, size  of the rectangle, pixels of the picture
  Block(glm::ivec2 corner, glm::ivec2 size) : mCorner(corner), mSize(size) {}

  /// A mark of the whole block, that covers nothing yet.
  Mark& add(glm::vec3 color) { return add(color, mCorner, mCorner + mSize); }
  /// A mark of a part of the block. @param low, high  pixels of the picture
  Mark& add(glm::vec3 color, glm::dvec2 low, glm::dvec2 high) {
    glm::ivec2 corner(glm::floor(low)), size = glm::ivec2(glm::ceil(high)) - corner;
    std::size_t pixels = std::size_t(size.x) * std::size_t(size.y);
    return mMarks.emplace_back(Mark{corner, size, color, std::vector<std::uint8_t>(pixels)});
  }
  /// All marks, on a glow of the ground's colour.
  std::vector<Mark> onGlow(glm::vec3 ground, double em) const;

 private:
  glm::ivec2 mCorner, mSize;
  std::vector<Mark> mMarks;
};

/// Means of 2 * radius + 1 values along a line of values. @param step  from one value to the next
void blurLine(float* line, int count, std::ptrdiff_t step, int radius, std::vector<float>& sums) {
  sums.assign(std::size_t(count) + 1, 0.0f);
  for (int i = 0; i < count; ++i) sums[std::size_t(i) + 1] = sums[std::size_t(i)] + line[i * step];
  for (int i = 0; i < count; ++i) {
    int from = std::max(0, i - radius), to = std::min(count, i + radius + 1);
    line[i * step] = (sums[std::size_t(to)] - sums[std::size_t(from)]) / float(2 * radius + 1);
  }
}

std::vector<Mark> Block::onGlow(glm::vec3 ground, double em) const {
  std::vector<float> field(std::size_t(mSize.x) * std::size_t(mSize.y)), sums;
  for (const Mark& mark : mMarks)
    for (std::size_t i = 0; i < mark.covers.size(); ++i) {
      glm::ivec2 at = mark.corner - mCorner + glm::ivec2(int(i) % mark.size.x, int(i) / mark.size.x);
      float& value = field[std::size_t(at.y) * std::size_t(mSize.x) + std::size_t(at.x)];
      value = std::max(value, float(mark.covers[i]) / 255.0f);
    }
  int radius = std::max(1, int(std::lround(kGlowBlur * em)));
  for (int pass = 0; pass < 3; ++pass) {
    for (int y = 0; y < mSize.y; ++y) blurLine(&field[std::size_t(y) * std::size_t(mSize.x)], mSize.x, 1, radius, sums);
    for (int x = 0; x < mSize.x; ++x) blurLine(&field[std::size_t(x)], mSize.y, mSize.x, radius, sums);
  }
  Mark glow{mCorner, mSize, ground, std::vector<std::uint8_t>(field.size())};
  for (std::size_t i = 0; i < field.size(); ++i)
    glow.covers[i] = std::uint8_t(std::lround(255.0f * std::min(kGlowMost, kGlowGain * field[i])));
  std::vector<Mark> all{std::move(glow)};
  all.insert(all.end(), mMarks.begin(), mMarks.end());
  return all;
}

/// Adds a rectangle with round corners to a mark. @param low, high  pixels of the picture
/// @param from, to  only the part of it between these, along x
void addRectangle(Mark& mark, glm::dvec2 low, glm::dvec2 high, double radius, double from, double to) {
  glm::dvec2 origin(mark.corner);
  low -= origin, high -= origin, from -= origin.x, to -= origin.x;
  glm::dvec2 middle = 0.5 * (low + high), half = 0.5 * (high - low) - radius;
  glm::ivec2 first = glm::max(glm::ivec2(glm::floor(low)) - 1, glm::ivec2(0)),
             last = glm::min(glm::ivec2(glm::ceil(high)) + 1, mark.size);
  for (int y = first.y; y < last.y; ++y)
    for (int x = first.x; x < last.x; ++x) {
      auto within = [](double a, double b, double at) {
        return std::clamp(std::min(b, at + 1.0) - std::max(a, at), 0.0, 1.0);
      };
      double share = within(from, to, x);
      if (radius > 0.0) {
        glm::dvec2 outside = glm::abs(glm::dvec2(x, y) + 0.5 - middle) - half;
        double distance = glm::length(glm::max(outside, 0.0)) + std::min(std::max(outside.x, outside.y), 0.0) - radius;
        share *= std::clamp(0.5 - distance, 0.0, 1.0);
      } else {
        share *= within(low.x, high.x, x) * within(low.y, high.y, y);
      }
      std::uint8_t& covers = mark.covers[std::size_t(y) * std::size_t(mark.size.x) + std::size_t(x)];
      covers = std::max(covers, std::uint8_t(std::lround(255.0 * share)));
    }
}

/// Lays out one part after the other: parts in the same corner do not cover each other.
class Layout {
 public:
  /// @param ground  before which all stands; none: the paper or background of the scene
  Layout(const scene::Scene& scene, glm::ivec2 size, std::optional<glm::vec3> ground = std::nullopt)
      : mScene(scene),
        mSize(size),
        mGround(ground),
        mLetters(std::max(kLeastEm, scene.lettering.textSize * size.y / 1000.0)) {}

  void addLegend(const std::vector<LegendEntry>& entries);
  void addScaleBar(const ScaleBar& bar);
  std::vector<Mark> marks() && { return std::move(mMarks); }

 private:
  /// The top left corner of a part, and takes its room. @param room  of the part, pixels
  glm::dvec2 place(scene::Corner corner, glm::dvec2 room);
  /// The marks of a part, with room for its glow.
  Block blockAt(glm::dvec2 corner, glm::dvec2 room) const;
  void finish(const Block& block, scene::Corner corner);
  glm::vec3 ground(scene::Corner corner) const { return mGround ? *mGround : groundOf(mScene, corner); }

  const scene::Scene& mScene;
  glm::dvec2 mSize;
  std::optional<glm::vec3> mGround;
  Letters mLetters;
  std::map<scene::Corner, double> mTaken;  ///< pixels from the picture's edge on
  std::vector<Mark> mMarks;
};

glm::dvec2 Layout::place(scene::Corner corner, glm::dvec2 room) {
  double em = mLetters.em(), edge = kMargin * em + mTaken[corner];
  mTaken[corner] += room.y + kBlockGap * em;
  return {isLeft(corner) ? kMargin * em : mSize.x - kMargin * em - room.x,
          isTop(corner) ? edge : mSize.y - edge - room.y};
}

Block Layout::blockAt(glm::dvec2 corner, glm::dvec2 room) const {
  glm::dvec2 glow(kGlow * mLetters.em());
  glm::ivec2 low(glm::floor(corner - glow)), high(glm::ceil(corner + room + glow));
  return {low, high - low};
}

void Layout::finish(const Block& block, scene::Corner corner) {
  std::vector<Mark> marks = block.onGlow(ground(corner), mLetters.em());
  mMarks.insert(mMarks.end(), marks.begin(), marks.end());
}

void Layout::addLegend(const std::vector<LegendEntry>& entries) {
  double em = mLetters.em(), line = kLine * em, swatch = kSwatch * em, before = swatch + kSwatchGap * em;
  auto most = std::size_t(std::max(1.0, std::floor((mSize.y - 2.0 * kMargin * em) / line)));
  std::size_t rows = std::min(entries.size(), most);
  if (rows == 0) return;
  double room = 0.0;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < rows; ++i) {
    names.push_back(mLetters.fitted(entries[i].name, kWidestName * mSize.x));
    room = std::max(room, mLetters.width(names.back()));
  }
  scene::Corner corner = mScene.lettering.legendCorner;
  glm::dvec2 size(before + room, line * double(rows)), at = place(corner, size);
  Block block = blockAt(at, size);
  glm::vec3 ink = inkOn(ground(corner));
  for (std::size_t i = 0; i < rows; ++i) {
    const std::vector<glm::vec3>& colors = entries[i].colors;
    glm::dvec2 low(at.x, at.y + line * double(i) + 0.5 * (line - swatch)), high = low + swatch;
    Mark& edge = block.add(ink, low - 1.0 - kOutline * em, high + 1.0 + kOutline * em);
    addRectangle(edge, low - kOutline * em, high + kOutline * em, (kCorner + kOutline) * em, -1e9, 1e9);
    for (std::uint8_t& covers : edge.covers) covers = std::uint8_t(std::lround(kOutlineShare * covers));
    for (std::size_t c = 0; c < colors.size(); ++c) {
      double band = swatch / double(colors.size());
      double from = low.x + band * double(c), to = from + band;
      Mark& mark = block.add(colors[c], {from, low.y}, {to, high.y});
      addRectangle(mark, low, high, kCorner * em, from, to);
    }
  }
  Mark& text = block.add(ink);
  for (std::size_t i = 0; i < rows; ++i)
    mLetters.draw(names[i], {at.x + before, at.y + line * double(i) + 0.5 * (line + kCapHeight * em)}, text);
  finish(block, corner);
}

void Layout::addScaleBar(const ScaleBar& bar) {
  double em = mLetters.em(), text = mLetters.width(bar.text);
  glm::dvec2 size(std::max(bar.pixels, text), (kCapHeight + kBarGap + kBarThickness) * em);
  scene::Corner corner = mScene.lettering.scaleBarCorner;
  glm::dvec2 at = place(corner, size);
  Block block = blockAt(at, size);
  Mark& mark = block.add(inkOn(ground(corner)));
  double middle = isLeft(corner) ? at.x + 0.5 * bar.pixels : at.x + size.x - 0.5 * bar.pixels;
  glm::dvec2 low(middle - 0.5 * bar.pixels, at.y + (kCapHeight + kBarGap) * em),
      high(low.x + bar.pixels, at.y + size.y);
  addRectangle(mark, low, high, 0.0, low.x, high.x);
  mLetters.draw(bar.text, {std::clamp(middle - 0.5 * text, at.x, at.x + size.x - text), at.y + kCapHeight * em}, mark);
  finish(block, corner);
}

/// The bar for a picture of that width. @param perPixel  length of a pixel, scene units
std::optional<ScaleBar> barOf(const scene::Scene& scene, double perPixel, int width) {
  const auto& volume = scene.volume.data;
  if (!scene::hasData(scene) || (volume && !volume->isSpacingKnown)) return std::nullopt;
  double most = perPixel * kLongestBar * width;
  if (!std::isfinite(most) || most <= 0.0) return std::nullopt;
  double length = rulerLength(most);
  return ScaleBar{length, length / perPixel, scene::roundLengthText(length, scene.unit)};
}

}  // namespace

std::optional<ScaleBar> scaleBarOf(const scene::Scene& scene, glm::ivec2 size) {
  return barOf(scene, scene::lengthPerPixel(scene.camera, glm::dvec2(size), scene.camera.target), size.x);
}

std::optional<ScaleBar> scaleBarOf(const scene::Scene& scene, scene::SectionKind kind, glm::ivec2 size) {
  return barOf(scene, scene::makeSectionPlane(scene, kind, glm::dvec2(size)).lengthPerPixel, size.x);
}

std::vector<Mark> letteringMarks(const scene::Scene& scene, glm::ivec2 size, const TypePixels& pixels) {
  if (!scene.lettering.legend && !scene.lettering.scaleBar) return {};
  Layout layout(scene, size);
  if (scene.lettering.legend) layout.addLegend(legendEntries(scene, pixels));
  if (scene.lettering.scaleBar)
    if (auto bar = scaleBarOf(scene, size)) layout.addScaleBar(*bar);
  return std::move(layout).marks();
}

std::vector<Mark> letteringMarks(const scene::Scene& scene, scene::SectionKind kind, glm::ivec2 size) {
  if (!scene.lettering.scaleBar) return {};
  auto bar = scaleBarOf(scene, kind, size);
  if (!bar) return {};
  // Beyond the data's end a section shows the background's lower colour.
  Layout layout(scene, size, scene.background.bottom);
  layout.addScaleBar(*bar);
  return std::move(layout).marks();
}

}  // namespace velum::session
