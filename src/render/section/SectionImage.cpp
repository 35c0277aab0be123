#include "render/section/SectionImage.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "render/FrameSetup.h"
#include "render/kept/RowCuts.h"
#include "render/section/SectionBricks.h"
#include "render/section/SectionRow.h"

#include "core/Assert.h"
#include "core/Parallel.h"
#include "scene/Shown.h"
#include "scene/StructureAt.h"

namespace velum::render {

namespace {

/// What the cuts remove keeps this share of its brightness: to be seen, and not to be taken for what is there.
constexpr float kDimmed = 0.34f;
/// Outlines are this much more opaque than the areas that they go round.
constexpr float kOutlineGain = 2.5f;

/// Draws one section row by row. Everything that rows share is made once.
class SectionDrawing {
 public:
  SectionDrawing(const scene::Scene& scene, const scene::SectionPlane& plane, const SheetIndices& sheets,
                 SectionDetail detail)
      : mScene(scene), mFrame(plane), mSize(glm::max(glm::ivec2(glm::ceil(plane.size)), glm::ivec2(1))) {
    const auto& volume = scene.volume;
    if (volume.data && volume.visible) mVolumePath.emplace(plane, volume.data->dims, volume.data->worldFromVoxel);
    if (mVolumePath && volume.data->finer) prepareBricks(detail);
    if (scene.labels.data) prepareLabels();
    if (scene.sections.showCuts) mCuts.emplace(scene, plane, sheets);
  }
  SectionImage draw();

 private:
  using Row = std::vector<glm::vec3>;

  void prepareBricks(SectionDetail detail);
  void sampleChannel(int y, int channel, const GridRow& row, double scale, double offset, float* out) const;
  void prepareLabels();
  void readIds(int y);
  void drawRow(int y, Row& colors, std::vector<float>& samples, SectionImage& image) const;
  GridRow addVolume(int y, Row& colors, std::vector<float>& samples) const;
  void addChannels(int y, const GridRow& row, Row& colors, std::vector<float>& samples) const;
  void addLabels(int y, Row& colors, std::vector<char>& covered) const;
  void dimRemoved(int y, Row& colors, std::span<std::uint16_t> shown) const;
  void showIds(int y, std::span<std::uint16_t> shown) const;
  bool isOutline(glm::ivec2 pixel) const;
  std::uint16_t idAt(int x, int y) const { return mIds[std::size_t(y) * std::size_t(mSize.x) + std::size_t(x)]; }

  const scene::Scene& mScene;
  const scene::SectionPlane& mFrame;
  glm::ivec2 mSize;
  std::optional<GridPath> mVolumePath, mLabelPath;
  std::optional<SectionBricks> mBricks;  ///< Of a streamed volume.
  std::shared_ptr<const StructureField> mField;
  std::vector<std::uint16_t> mIds;     ///< Label of each pixel.
  std::vector<glm::vec4> mStructures;  ///< Colour and opacity on the section by id; nothing where it is not shown.
  bool mShowsLabels = false;
  std::optional<RowCuts> mCuts;
};

void SectionDrawing::prepareBricks(SectionDetail detail) {
  const auto& layer = mScene.volume;
  std::vector<int> channels{scene::shownChannel(layer)};
  if (layer.data->isColor || scene::mixesChannels(layer)) {
    channels.clear();
    for (int channel = 0; channel < layer.data->channels; ++channel)
      if (layer.data->isColor || layer.channels[std::size_t(channel)].visible) channels.push_back(channel);
  }
  mBricks.emplace(*layer.data, channels, scene::shownTimeStep(layer), mFrame, mSize, detail == SectionDetail::Whole);
}

/// What is in memory, and over it what is finer.
void SectionDrawing::sampleChannel(int y, int channel, const GridRow& row, double scale, double offset,
                                   float* out) const {
  const auto& layer = mScene.volume;
  bool interpolates = mScene.sections.interpolate;
  sampleRow(*layer.data, channel, scene::shownTimeStep(layer), row, interpolates, scale, offset, out);
  if (mBricks) mBricks->sampleRow(y, channel, interpolates, scale, offset, out);
}

void SectionDrawing::prepareLabels() {
  const auto& labels = mScene.labels;
  bool isAlone = !mVolumePath;
  double share = isAlone ? 1.0 : mScene.sections.labelOpacity;
  mShowsLabels = labels.visible && share > 0;
  bool spared = std::any_of(mScene.cuts.begin(), mScene.cuts.end(), [](const auto& c) { return !c.spares.empty(); });
  if (!mShowsLabels && !(spared && labels.visible)) return;
  mLabelPath.emplace(mFrame, labels.data->dims(), labels.data->worldFromVoxel());
  mField = scene::structureFieldOf(mScene);
  mIds.assign(std::size_t(mSize.x) * std::size_t(mSize.y), 0);
  for (const auto& row : makeStructureRows(labels)) mStructures.push_back(row.color);
  for (auto& structure : mStructures) structure.a *= float(share);
  mStructures[0] = glm::vec4(0.0f);
}

void SectionDrawing::readIds(int y) {
  VELUM_ASSERT(mLabelPath, "the labels have a grid");
  GridRow row = mLabelPath->row(y, mSize.x);
  std::uint16_t* out = &mIds[std::size_t(y) * std::size_t(mSize.x)];
  for (int x = row.first; x < row.last; ++x) {
    out[x] = mField->at(placeIn(row.at, mField->cover().labels()->dims())).id;
    for (std::size_t i = 0; i < 3; ++i) row.at[i] += row.step[i];
  }
}

/// Colours of several channels: added where channels are mixed, as they are where the volume has colours.
void SectionDrawing::addChannels(int y, const GridRow& row, Row& colors, std::vector<float>& samples) const {
  const auto& layer = mScene.volume;
  const Volume& v = *layer.data;
  bool mixes = scene::mixesChannels(layer);
  std::fill(colors.begin() + row.first, colors.begin() + row.last, glm::vec3(0.0f));
  for (int channel = 0; channel < (mixes ? v.channels : 3); ++channel) {
    glm::vec3 color(0.0f);
    double scale = 1.0 / std::max(255.0, v.range.y), offset = 0.0;
    if (mixes) {
      const auto& look = layer.channels[std::size_t(channel)];
      if (!look.visible) continue;
      glm::dvec2 window = scene::effectiveWindow(layer, look);
      color = look.color;
      scale = v.scale / window.y;
      offset = (v.offset - window.x) / window.y + 0.5;
    } else {
      color[channel] = 1.0f;
    }
    sampleChannel(y, channel, row, scale, offset, samples.data());
    for (int x = row.first; x < row.last; ++x) {
      float share = samples[std::size_t(x)];
      colors[std::size_t(x)] += color * (share > 0.0f ? std::min(share, 1.0f) : 0.0f);
    }
  }
}

GridRow SectionDrawing::addVolume(int y, Row& colors, std::vector<float>& samples) const {
  if (!mVolumePath) return {};
  const auto& layer = mScene.volume;
  const Volume& v = *layer.data;
  GridRow row = mVolumePath->row(y, mSize.x);
  if (v.isColor || scene::mixesChannels(layer)) {
    addChannels(y, row, colors, samples);
    return row;
  }
  glm::dvec2 window = scene::effectiveWindow(layer);
  sampleChannel(y, scene::shownChannel(layer), row, v.scale / window.y, (v.offset - window.x) / window.y + 0.5,
                samples.data());
  for (int x = row.first; x < row.last; ++x) colors[std::size_t(x)] = glm::vec3(samples[std::size_t(x)]);
  return row;
}

/// A pixel whose neighbour shows another structure: the line lies inside the structure and is one pixel wide.
bool SectionDrawing::isOutline(glm::ivec2 pixel) const {
  std::uint16_t id = idAt(pixel.x, pixel.y);
  return (pixel.x > 0 && idAt(pixel.x - 1, pixel.y) != id) ||
         (pixel.x + 1 < mSize.x && idAt(pixel.x + 1, pixel.y) != id) ||
         (pixel.y > 0 && idAt(pixel.x, pixel.y - 1) != id) ||
         (pixel.y + 1 < mSize.y && idAt(pixel.x, pixel.y + 1) != id);
}

void SectionDrawing::addLabels(int y, Row& colors, std::vector<char>& covered) const {
  if (!mShowsLabels || !mLabelPath) return;
  VELUM_ASSERT(mLabelPath, "the labels have a grid");
  GridRow row = mLabelPath->row(y, mSize.x);
  for (int x = row.first; x < row.last; ++x) {
    std::uint16_t id = idAt(x, y);
    if (id == 0) continue;
    glm::vec4 structure = id < mStructures.size() ? mStructures[id] : mStructures[0];
    if (structure.a <= 0.0f) continue;
    if (isOutline({x, y})) structure.a = std::min(1.0f, structure.a * kOutlineGain);
    glm::vec3& color = colors[std::size_t(x)];
    color = glm::mix(glm::clamp(color, 0.0f, 1.0f), glm::vec3(structure), structure.a);
    covered[std::size_t(x)] = 1;
  }
}

/// The ids of a row, without those of structures that are not shown.
void SectionDrawing::showIds(int y, std::span<std::uint16_t> shown) const {
  for (std::size_t x = 0; x < shown.size(); ++x) {
    std::uint16_t id = idAt(int(x), y);
    shown[x] = id < mStructures.size() && mStructures[id].a > 0.0f ? id : 0;
  }
}

void SectionDrawing::dimRemoved(int y, Row& colors, std::span<std::uint16_t> shown) const {
  std::span<const std::uint16_t> ids;
  if (!mIds.empty()) ids = std::span(mIds).subspan(std::size_t(y) * std::size_t(mSize.x), std::size_t(mSize.x));
  std::vector<char> removed = mCuts->removedOf(y, mSize.x, ids);
  for (std::size_t x = 0; x < removed.size(); ++x)
    if (removed[x]) colors[x] = glm::clamp(colors[x], 0.0f, 1.0f) * kDimmed;
  for (std::size_t x = 0; x < std::min(removed.size(), shown.size()); ++x)
    if (removed[x]) shown[x] = 0;
}

std::uint32_t packed(glm::vec3 color) {
  // Not a number fails both comparisons and is black.
  auto byte = [](float c) { return std::uint32_t((c > 0.0f ? std::min(c, 1.0f) : 0.0f) * 255.0f + 0.5f); };
  return 0xff000000u | byte(color.r) << 16 | byte(color.g) << 8 | byte(color.b);
}

void SectionDrawing::drawRow(int y, Row& colors, std::vector<float>& samples, SectionImage& image) const {
  std::size_t first = std::size_t(y) * std::size_t(mSize.x);
  std::uint32_t* out = &image.pixels[first];
  std::span<std::uint16_t> shown;
  if (!image.structures.empty()) shown = std::span(image.structures).subspan(first, std::size_t(mSize.x));
  const auto& behind = mScene.background;
  // One colour, the darker end of the usual gradient: a section is flat, and air in it is black.
  glm::vec3 ground = behind.bottom;
  std::fill(colors.begin(), colors.end(), ground);
  GridRow row = addVolume(y, colors, samples);
  std::vector<char> covered(std::size_t(mSize.x), 0);
  std::fill(covered.begin() + row.first, covered.begin() + row.last, 1);
  addLabels(y, colors, covered);
  showIds(y, shown);
  if (mCuts && !mCuts->isEmpty()) dimRemoved(y, colors, shown);
  std::uint32_t empty = behind.transparent ? packed(ground) & 0xffffffu : packed(ground);
  for (std::size_t x = 0; x < colors.size(); ++x) out[x] = covered[x] ? packed(colors[x]) : empty;
}

SectionImage SectionDrawing::draw() {
  SectionImage image{mSize, std::vector<std::uint32_t>(std::size_t(mSize.x) * std::size_t(mSize.y)), {}, {}};
  if (mShowsLabels && mLabelPath) image.structures.resize(image.pixels.size());
  if (mBricks) image.missing = mBricks->missing();
  constexpr int kRows = 16;
  if (mLabelPath) parallelFor(0, mSize.y, [&](int y) { readIds(y); });
  parallelForRanges(0, mSize.y, kRows, [&](int first, int end) {
    Row colors(std::size_t(mSize.x));
    std::vector<float> samples(std::size_t(mSize.x));
    for (int y = first; y < end; ++y) drawRow(y, colors, samples, image);
  });
  return image;
}

}  // namespace

SectionImage drawSection(const scene::Scene& scene, const scene::SectionPlane& plane, const SheetIndices& sheets,
                         SectionDetail detail) {
  return SectionDrawing(scene, plane, sheets, detail).draw();
}

SectionImage drawSection(const scene::Scene& scene, scene::SectionKind kind, glm::ivec2 size) {
  return drawSection(scene, scene::makeSectionPlane(scene, kind, glm::dvec2(size)));
}

scene::SectionPlane coarserPlane(scene::SectionPlane plane, int n) {
  plane.size /= double(n);
  plane.lengthPerPixel *= double(n);
  return plane;
}

}  // namespace velum::render
