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
  void drawRow(int y, Row& colors, std::vector<float>& samples, std::uint32_t* out) const;
  GridRow addVolume(int y, Row& colors, std::vector<float>& samples) const;
  void addChannels(int y, const GridRow& row, Row& colors, std::vector<float>& samples) const;
  void addLabels(int y, Row& colors, std::vector<char>& covered) const;
  void dimRemoved(int y, Row& colors) const;
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

void SectionDrawing::dimRemoved(int y, Row& colors) const {
  std::span<const std::uint16_t> ids;
  if (!mIds.empty()) ids = std::span(mIds).subspan(std::size_t(y) * std::size_t(mSize.x), std::size_t(mSize.x));
  std::vector<char> removed = mCuts->removedOf(y, mSize.x, ids);
  for (std::size_t x = 0; x < removed.size(); ++x)
    if (removed[x]) colors[x] = glm::clamp(colors[x], 0.0f, 1.0f) * kDimmed;
}

std::uint32_t packed(glm::vec3 color) {
  // Not a number fails both comparisons and is black.
  auto byte = [](float c) { return std::uint32_t((c > 0.0f ? std::min(c, 1.0f) : 0.0f) * 255.0f + 0.5f); };
  return 0xff000000u | byte(color.r) << 16 | byte(color.g) << 8 | byte(color.b);
}

void SectionDrawing::drawRow(int y, Row& colors, std::vector<float>& samples, std::uint32_t* out) const {
  const auto& behind = mScene.background;
  // One colour, the darker end of the usual gradient: a section is flat, and air in it is black.
  glm::vec3 ground = behind.bottom;
  std::fill(colors.begin(), colors.end(), ground);
  GridRow row = addVolume(y, colors, samples);
  std::vector<char> covered(std::size_t(mSize.x), 0);
  std::fill(covered.begin() + row.first, covered.begin() + row.last, 1);
  addLabels(y, colors, covered);
  if (mCuts && !mCuts->isEmpty()) dimRemoved(y, colors);
  std::uint32_t empty = behind.transparent ? packed(ground) & 0xffffffu : packed(ground);
  for (std::size_t x = 0; x < colors.size(); ++x) out[x] = covered[x] ? packed(colors[x]) : empty;
}

SectionImage SectionDrawing::draw() {
  SectionImage image{mSize, std::vector<std::uint32_t>(std::size_t(mSize.x) * std::size_t(mSize.y)), {}};
  if (mBricks) image.missing = mBricks->missing();
  constexpr int kRows = 16;
  if (mLabelPath) parallelFor(0, mSize.y, [&](int y) { readIds(y); });
  parallelForRanges(0, mSize.y, kRows, [&](int first, int end) {
    Row colors(std::size_t(mSize.x));
    std::vector<float> samples(std::size_t(mSize.x));
    for (int y = first; y < end; ++y) drawRow(y, colors, samples, &image.pixels[std::size_t(y) * std::size_t(mSize.x)]);
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

namespace {

/// The values of the finest voxel there, as far as it is in memory: who moves a pointer waits for no disk.
void takeFinest(const Volume& volume, glm::dvec3 world, int firstChannel, int timeStep, std::vector<double>& values) {
  BrickCache& bricks = *volume.finer->bricks;
  for (int level = 0; level < volume.finer->level; ++level) {
    const VoxelLevel& its = bricks.source().levels()[std::size_t(level)];
    glm::dvec3 place = glm::inverse(worldFromLevel(volume, level)) * glm::dvec4(world, 1.0);
    glm::ivec3 voxel = glm::clamp(glm::ivec3(glm::floor(place + 0.5)), glm::ivec3(0), its.dims - 1);
    bool isThere = true;
    for (std::size_t i = 0; i < values.size() && isThere; ++i) {
      int channel = firstChannel + int(i);
      isThere =
          bool(bricks.find({level, voxel / its.brickSize, channel / its.brickChannels, timeStep / its.brickTimeSteps}));
      if (isThere) values[i] = valueAt(bricks.read({level, voxel, glm::ivec3(1)}, channel, timeStep), glm::ivec3(0));
    }
    if (isThere) return;
  }
}

}  // namespace

Probe probe(const scene::Scene& scene, glm::dvec3 world) {
  Probe out;
  auto voxelOf = [&](const glm::dmat4& worldFromVoxel) {
    return glm::floor(glm::dvec3(glm::inverse(worldFromVoxel) * glm::dvec4(world, 1.0)) + 0.5);
  };
  auto isIn = [](glm::dvec3 voxel, glm::ivec3 dims) {
    return glm::all(glm::greaterThanEqual(voxel, glm::dvec3(0.0))) && glm::all(glm::lessThan(voxel, glm::dvec3(dims)));
  };
  const auto& labels = scene.labels;
  if (labels.data) {
    glm::dvec3 voxel = voxelOf(labels.data->worldFromVoxel());
    bool inside = isIn(voxel, labels.data->dims());
    if (inside && labels.visible) out.structure = scene::structureAt(scene, world).id;
    out.inside = inside && !scene.volume.data;
  }
  if (!scene.volume.data) return out;
  const Volume& v = *scene.volume.data;
  glm::dvec3 voxel = voxelOf(v.worldFromVoxel);
  out.inside = isIn(voxel, v.dims);
  if (!out.inside) return out;
  bool all = v.isColor || scene::mixesChannels(scene.volume);
  int first = all ? 0 : scene::shownChannel(scene.volume);
  int last = all ? v.channels : first + 1, timeStep = scene::shownTimeStep(scene.volume);
  for (int channel = first; channel < last; ++channel)
    out.values.push_back(valueAt(v, glm::ivec3(voxel), channel, timeStep));
  if (v.finer) takeFinest(v, world, first, timeStep, out.values);
  return out;
}

}  // namespace velum::render
