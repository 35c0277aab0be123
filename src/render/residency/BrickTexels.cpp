#include "render/residency/BrickTexels.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "render/upload/BlockGradients.h"
#include "render/upload/GradientPlanes.h"
#include "render/upload/GradientTexels.h"

namespace velum::render {

namespace {

float texelValue(std::uint8_t t) { return float(t) / 255.0f; }
float texelValue(std::uint16_t t) { return float(t) / 65535.0f; }
float texelValue(float t) { return t; }
float texelValue(const glm::u8vec4& t) { return float(t.a) / 255.0f; }

/// The part of a level that a brick's texels are made of, and where the slot's voxels lie in it.
struct Block {
  VolumeTexels source;
  glm::ivec3 slotOrigin{0};    ///< voxels of the block
  glm::dvec3 brickLow{0.0};    ///< where the brick begins in its slot, voxels whose corners are at whole numbers
  glm::dvec3 brickEdges{0.0};  ///< voxels
  glm::ivec3 dims{0};

  std::size_t at(glm::ivec3 slotVoxel) const {
    glm::ivec3 v = glm::clamp(slotOrigin + slotVoxel, glm::ivec3(0), dims - 1);
    return (std::size_t(v.z) * std::size_t(dims.y) + std::size_t(v.y)) * std::size_t(dims.x) + std::size_t(v.x);
  }
  /// Where a row of the slot's begins: its block's first voxel.
  std::size_t row(int y, int z) const { return at({-slotOrigin.x, y, z}); }
};

Block readBlock(const TexelRecipe& recipe, const PageGrid& grid, const PageBrick& brick) {
  const PageLevel& level = grid.levels()[std::size_t(brick.level)];
  glm::ivec3 margin = gradientReach(level.spacing, level.dims), origin = grid.slotOrigin(brick);
  // Not beyond the level's border, where gradients are not those of repeated voxels.
  glm::ivec3 low = glm::clamp(origin - margin, glm::ivec3(0), level.dims - 1);
  glm::ivec3 high = glm::clamp(origin + kSlotEdge + margin, low + 1, level.dims);
  VoxelBox box{grid.sourceLevel(brick.level), low, high - low};
  Volume volume = recipe.bricks->read(
      box, recipe.isMixed || recipe.bricks->source().head().isColor ? -1 : recipe.channel, recipe.timeStep);
  volume.range = recipe.range;
  for (int axis = 0; axis < 3; ++axis)
    volume.worldFromVoxel[axis] = level.worldFromTex[axis] / double(level.dims[axis]);
  Block block;
  block.dims = block.source.dims = volume.dims;
  block.source.isMixed = recipe.isMixed;
  block.source.mix = recipe.mix;
  block.source.volume = Shared<Volume>(std::move(volume));
  block.slotOrigin = origin - low;
  block.brickLow = grid.lowCorner(brick) - glm::dvec3(origin);
  block.brickEdges = grid.edges(brick.level);
  return block;
}

/// Copies what a slot holds out of a block.
template <class Texel>
void cutOut(const Block& block, const Texel* texels, std::byte* out) {
  glm::ivec3 v;
  bool isInside = block.slotOrigin.x >= 0 && block.slotOrigin.x + kSlotEdge <= block.dims.x;
  for (v.z = 0; v.z < kSlotEdge; ++v.z)
    for (v.y = 0; v.y < kSlotEdge; ++v.y) {
      v.x = 0;
      if (isInside) {
        std::memcpy(out, texels + block.at(v), sizeof(Texel) * kSlotEdge);
        out += sizeof(Texel) * kSlotEdge;
        continue;
      }
      for (; v.x < kSlotEdge; ++v.x, out += sizeof(Texel)) std::memcpy(out, texels + block.at(v), sizeof(Texel));
    }
}

/// The same, four neighbours to a texel, as packTexels() has them.
template <class Texel>
void cutOutPacked(const Block& block, const Texel* texels, Bytes& out) {
  using Packed = glm::vec<4, Texel>;
  out.resize(sizeof(Packed) * kSlotEdge * kSlotEdge * kSlotEdge);
  auto* packed = reinterpret_cast<Packed*>(out.data());
  for (int z = 0; z < kSlotEdge; ++z)
    for (int y = 0; y < kSlotEdge; ++y) {
      const Texel *here = texels + block.row(y, z), *next = texels + block.row(y + 1, z);
      const Texel *above = texels + block.row(y, z + 1), *both = texels + block.row(y + 1, z + 1);
      for (int x = 0; x < kSlotEdge; ++x, ++packed) {
        int i = std::clamp(block.slotOrigin.x + x, 0, block.dims.x - 1);
        *packed = {here[i], next[i], above[i], both[i]};
      }
    }
}

/// The ranges of a brick's cells: of the voxels between which places in a cell lie.
template <class Texel>
BrickRanges rangesOf(const Block& block, const Texel* texels) {
  BrickRanges ranges;
  ranges.all = glm::vec2(texelValue(texels[block.at(glm::ivec3(0))]));
  for (int z = 0; z < kSlotEdge; ++z)
    for (int y = 0; y < kSlotEdge; ++y)
      for (int x = 0; x < kSlotEdge; ++x) {
        float value = texelValue(texels[block.at({x, y, z})]);
        ranges.all = {std::min(ranges.all.x, value), std::max(ranges.all.y, value)};
      }
  glm::dvec3 edge = block.brickEdges / double(kRangeCells);
  for (int i = 0; i < int(ranges.cells.size()); ++i) {
    glm::ivec3 cell(i % kRangeCells, i / kRangeCells % kRangeCells, i / (kRangeCells * kRangeCells)), v;
    glm::dvec3 low = block.brickLow + glm::dvec3(cell) * edge - 0.5;
    glm::ivec3 from(glm::floor(low + 1e-6)), to(glm::ceil(low + edge - 1e-6));
    from = glm::clamp(from, glm::ivec3(0), glm::ivec3(kSlotEdge - 1));
    to = glm::clamp(to, from, glm::ivec3(kSlotEdge - 1));
    Texel first = texels[block.at(from)];
    float least = texelValue(first), most = least;
    for (v.z = from.z; v.z <= to.z; ++v.z)
      for (v.y = from.y; v.y <= to.y; ++v.y)
        for (v.x = from.x; v.x <= to.x; ++v.x) {
          float value = texelValue(texels[block.at(v)]);
          least = std::min(least, value);
          most = std::max(most, value);
        }
    ranges.cells[std::size_t(i)] = {least, most};
  }
  return ranges;
}

/// Raw values as numbers.
const std::vector<float>& valuesOf(const Volume& volume) {
  thread_local std::vector<float> values;
  values.resize(voxelCount(volume));
  auto fallback = float((volume.range.x - volume.offset) / (volume.scale == 0 ? 1 : volume.scale));
  visitSamples(volume, [&](auto* samples) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = float(samples[i]);
      if constexpr (std::is_floating_point_v<std::remove_cvref_t<decltype(*samples)>>)
        values[i] = std::isfinite(values[i]) ? values[i] : fallback;
    }
  });
  return values;
}

template <class Texel>
BrickTexels makeAs(const TexelRecipe& recipe, const Block& block, const IsWorthSlot& isWorthSlot) {
  BrickTexels out;
  constexpr std::size_t kCount = std::size_t(kSlotEdge) * kSlotEdge * kSlotEdge;
  std::vector<Texel> scratch;
  const Texel* texels = block.source.planes<Texel>(0, block.dims.z, scratch);
  out.ranges = rangesOf(block, texels);
  if (!isWorthSlot(out.ranges)) return out;
  bool isPacked = false;
  if constexpr (std::is_same_v<Texel, std::uint8_t> || std::is_same_v<Texel, std::uint16_t>) {
    isPacked = recipe.plan.packing != Packing::None;
    if (isPacked) cutOutPacked(block, texels, out.texels);
  }
  if (!isPacked) {
    out.texels.resize(kCount * sizeof(Texel));
    cutOut(block, texels, out.texels.data());
  }
  if constexpr (std::is_same_v<Texel, glm::u8vec4>) {
    std::vector<std::uint8_t> grey(std::size_t(block.dims.x) * std::size_t(block.dims.y) * std::size_t(block.dims.z));
    for (std::size_t i = 0; i < grey.size(); ++i) grey[i] = texels[i].a;
    auto differences = takeDifferences(grey.data(), block.dims, 0, 0, block.dims.z);
    auto gradients = packGradients(differences, block.dims, 0, block.dims.z, recipe.longestGradient * 255.0);
    out.gradients.resize(kCount);
    cutOut(block, gradients.data(), reinterpret_cast<std::byte*>(out.gradients.data()));
  } else {
    out.gradients =
        blockGradients(valuesOf(*block.source.volume), block.dims, spacingOf(*block.source.volume),
                       {block.slotOrigin, glm::ivec3(kSlotEdge)}, recipe.longestGradient * recipe.plan.scale);
  }
  return out;
}

}  // namespace

BrickTexels makeBrickTexels(const TexelRecipe& recipe, const PageGrid& grid, const PageBrick& brick,
                            const IsWorthSlot& isWorthSlot) {
  Block block = readBlock(recipe, grid, brick);
  switch (recipe.plan.format) {
    case gpu::Format::R8:
      return makeAs<std::uint8_t>(recipe, block, isWorthSlot);
    case gpu::Format::R16:
      return makeAs<std::uint16_t>(recipe, block, isWorthSlot);
    case gpu::Format::Rgba8:
      return makeAs<glm::u8vec4>(recipe, block, isWorthSlot);
    default:
      return makeAs<float>(recipe, block, isWorthSlot);
  }
}

}  // namespace velum::render
