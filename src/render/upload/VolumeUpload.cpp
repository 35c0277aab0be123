#include "render/upload/VolumeUpload.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>

#include "gpu/GpuError.h"
#include "render/upload/GradientPlanes.h"
#include "render/upload/GradientTexels.h"
#include "render/upload/SmoothTexels.h"
#include "render/upload/TexelStore.h"
#include "render/upload/VolumeTexels.h"
#include "scene/Scene.h"
#include "scene/Shown.h"

namespace velum::render {

namespace {

using gpu::Format;

int maxOf(glm::ivec3 v) { return std::max(v.x, std::max(v.y, v.z)); }
/// Of a smooth volume with its gradients: texels close together are no gain beyond that.
constexpr double kMostSmoothBytes = double(1u << 30);

/// Texels per voxel of a smooth volume, fewer where there is no room.
glm::ivec3 finestThatFits(const Volume& volume, double mostBytes, int mostAlong) {
  constexpr double kTexelBytes = 8.0;  // a float and its gradient
  glm::ivec3 finer = smoothFactors(volume);
  auto fits = [&] {
    return double(product(volume.dims * finer)) * kTexelBytes <= mostBytes && maxOf(volume.dims * finer) <= mostAlong;
  };
  while (finer != glm::ivec3(1) && !fits()) {
    int most = finer.x >= finer.y && finer.x >= finer.z ? 0 : finer.y >= finer.z ? 1 : 2;
    --finer[most];
  }
  return finer;
}

}  // namespace

struct VolumeUpload::Impl {
  gpu::Limits limits;
  VolumeTexels source;
  glm::ivec3 finer{1};                      ///< Texels per voxel, where they are smooth.
  std::optional<GradientPlanes> gradients;  ///< Of smooth texels.
  TexelPlan plan;
  bool wantsGradients = limits.isSoftware;
  GpuVolume out;
  GpuVolume* into = nullptr;  ///< Whose textures are written; nullptr: those of `out`.
  int nextCellZ = 0;
  int cellLayersPerStep = 1;
  double longestGradient = 1;  ///< Texels.

  bool isMixed() const { return source.isMixed; }
  bool isColor() const { return source.volume->isColor || source.isMixed; }
  glm::ivec3 dimsAt(int factor) const { return (source.volume->dims + factor - 1) / factor; }
  std::size_t bytesAt(int factor) const;
  double mostBytes() const { return 0.7 * double(limits.memoryBytes); }
  // In the order of an upload's beginning.
  void choose(const scene::VolumeLayer& layer);
  void reduce(int mostAlong);
  void suitSoftware();
  void smoothen(bool isWanted);
  void chooseGradients();
  void tellReduction();
  void place();
  void allocate();
  void prepareGradients();

  template <class Texel>
  void stepAs();
};

std::size_t VolumeUpload::Impl::bytesAt(int factor) const {
  return product(dimsAt(factor)) * (texelBytes(plan) + (wantsGradients ? 4 : 0));
}

/// Which values, and how they would lie best.
void VolumeUpload::Impl::choose(const scene::VolumeLayer& layer) {
  const Shared<Volume>& volume = layer.data;
  source.volume = volume;
  source.channel = scene::shownChannel(layer);
  source.timeStep = scene::shownTimeStep(layer);
  source.isMixed = scene::mixesChannels(layer);
  if (source.isMixed) source.mix = makeMixTable(layer);
  plan = planFor(*volume, source.isMixed);
}

/// Takes the best level whose sides and bytes the driver can hold beside pictures and tables.
void VolumeUpload::Impl::reduce(int mostAlong) {
  source.isQuick = mostAlong > 0;
  if (source.isQuick) source.factor = std::max(1, (maxOf(source.volume->dims) + mostAlong - 1) / mostAlong);
  while (maxOf(dimsAt(source.factor)) > limits.texture3d || double(bytesAt(source.factor)) > mostBytes())
    ++source.factor;
}

/// A software driver loads the eight texels of each fetch one by one and unpacks them: two of packed ones take half as
/// long, and floats are fetched nearly twice as fast as bytes. Means of many voxels are not rounded to integers.
void VolumeUpload::Impl::suitSoftware() {
  if (!limits.isSoftware || isColor()) return;
  TexelPlan narrow = plan;
  auto take = [&](const TexelPlan& other) {
    plan = other;
    return double(bytesAt(source.factor)) <= mostBytes();
  };
  auto packed = packedPlan(narrow);
  bool canPack =
      packed && (source.factor == 1 || source.isQuick) && product(dimsAt(source.factor)) <= limits.textureBuffer;
  if (!(canPack && take(*packed)) && !take(kAsFloats)) plan = narrow;
}

void VolumeUpload::Impl::smoothen(bool isWanted) {
  const Volume& volume = *source.volume;
  out.dims = source.dims = dimsAt(source.factor);
  if (!isWanted || source.factor != 1 || source.isQuick || isColor()) return;
  double most = std::min(mostBytes(), kMostSmoothBytes);
  finer = finestThatFits(volume, most, limits.texture3d);
  if (finer != smoothFactors(volume))
    out.reduction = fmt::format("not as smooth as asked for: that takes more than {} MiB or {} texels along a side",
                                std::size_t(most) >> 20, limits.texture3d);
  // Integers would show their steps where texels are close.
  if (finer != glm::ivec3(1)) plan = kAsFloats;
  out.dims *= finer;
}

/// A GPU takes differences on demand only where there is no room: 26 fetches for one. Of smooth texels they would be of
/// texels, not of voxels.
void VolumeUpload::Impl::chooseGradients() {
  wantsGradients = limits.isSoftware || product(out.dims) * 4 <= limits.memoryBytes / 8 || finer != glm::ivec3(1);
}

void VolumeUpload::Impl::tellReduction() {
  if (source.factor == 1) return;
  glm::ivec3 whole = source.volume->dims;
  out.reduction = fmt::format("shown at 1/{} of its resolution ({} x {} x {} of {} x {} x {} voxels): {}",
                              source.factor, out.dims.x, out.dims.y, out.dims.z, whole.x, whole.y, whole.z,
                              maxOf(whole) > limits.texture3d
                                  ? fmt::format("the driver's 3D textures end at {} texels", limits.texture3d)
                                  : fmt::format("it needs {:.1f} MiB, and the driver has {:.1f} MiB for it",
                                                double(bytesAt(1)) / (1 << 20), mostBytes() / (1 << 20)));
}

/// What texels are in space, and as values.
void VolumeUpload::Impl::place() {
  const Volume& volume = *source.volume;
  out.cells = cellGridFor(out.dims);
  out.isColor = volume.isColor;
  out.isMixed = isMixed();
  out.valueScale = isMixed() ? 1.0 : plan.scale * volume.scale;
  out.valueOffset = isMixed() ? 0.0 : plan.offset * volume.scale + volume.offset;
  glm::dmat4 voxelFromTex(1.0);
  for (int axis = 0; axis < 3; ++axis) {
    voxelFromTex[axis][axis] = double(source.dims[axis]) * source.factor;
    voxelFromTex[3][axis] = -0.5;
  }
  out.worldFromTex = volume.worldFromVoxel * voxelFromTex;
  out.packing = plan.packing;
}

void VolumeUpload::Impl::allocate() {
  if (!into) allocateTexels(out, plan, out.dims, product(out.dims), wantsGradients);
  std::size_t layerBytes = std::size_t(out.dims.x) * std::size_t(out.dims.y) * std::size_t(out.cells.edge) *
                           texelBytes(plan) * (source.isQuick ? 1 : std::size_t(source.factor));
  constexpr std::size_t kStepBytes = 4u << 20;
  cellLayersPerStep = int(std::max<std::size_t>(1, kStepBytes / std::max<std::size_t>(1, layerBytes)));
  out.cellRanges.reserve(product(out.cells.size));
}

void VolumeUpload::Impl::prepareGradients() {
  if (!wantsGradients) return;
  if (finer != glm::ivec3(1)) gradients.emplace(source, finer);
  longestGradient = longestGradientOf(*source.volume, plan, isColor());
  out.gradientScale = longestGradient * 255.0 / 127.0;
}

VolumeUpload::VolumeUpload(const scene::VolumeLayer& layer, const gpu::Limits& limits, int mostAlong)
    : mImpl(new Impl{.limits = limits}) {
  Impl& m = *mImpl;
  m.choose(layer);
  m.reduce(mostAlong);
  m.suitSoftware();
  m.smoothen(layer.smooth);
  m.chooseGradients();
  m.tellReduction();
  m.place();
  m.allocate();
  m.prepareGradients();
}

VolumeUpload::VolumeUpload(const scene::VolumeLayer& layer, const gpu::Limits& limits, const TexelPlan& plan,
                           GpuVolume& into)
    : mImpl(new Impl{.limits = limits}) {
  Impl& m = *mImpl;
  m.into = &into;
  m.choose(layer);
  m.plan = plan;
  m.wantsGradients = true;
  m.out.dims = m.source.dims = m.dimsAt(1);
  m.place();
  m.allocate();
  m.prepareGradients();
}

VolumeUpload::~VolumeUpload() = default;

template <class Texel>
void VolumeUpload::Impl::stepAs() {
  int cz0 = nextCellZ, cz1 = std::min(out.cells.size.z, cz0 + cellLayersPerStep);
  int z0 = cz0 * out.cells.edge, z1 = std::min(out.dims.z, cz1 * out.cells.edge);
  int halo = wantsGradients && isColor() ? 2 : 1;
  int halo0 = std::max(0, z0 - halo), halo1 = std::min(out.dims.z, z1 + halo);
  std::vector<Texel> scratch;
  const Texel* texels = nullptr;
  if constexpr (std::is_same_v<Texel, float>) {
    if (finer != glm::ivec3(1)) texels = (scratch = smoothPlanes(source, finer, halo0, halo1)).data();
  }
  if (!texels) texels = source.planes<Texel>(halo0, halo1, scratch);
  std::size_t planeSize = std::size_t(out.dims.x) * std::size_t(out.dims.y);
  glm::ivec3 at(0, 0, z0), size(out.dims.x, out.dims.y, z1 - z0);
  GpuVolume& target = into ? *into : out;
  if constexpr (std::is_same_v<Texel, std::uint8_t> || std::is_same_v<Texel, std::uint16_t>) {
    if (out.packing != Packing::None) writePlanes(target, z0, size, packTexels(texels, out.dims, halo0, z0, z1).data());
  }
  if (out.packing == Packing::None) writePlanes(target, z0, size, texels + planeSize * std::size_t(z0 - halo0));
  std::vector<glm::vec2> layerRanges;
  int low = std::max(0, z0 - 1), high = std::min(out.dims.z, z1 + 1);
  PackedGradients packed;
  if constexpr (std::is_same_v<Texel, glm::u8vec4>) {
    std::vector<std::uint8_t> grey(planeSize * std::size_t(halo1 - halo0));
    for (std::size_t i = 0; i < grey.size(); ++i) grey[i] = texels[i].a;
    layerRanges = computeCellRanges(grey.data(), out.dims, out.cells, cz0, cz1, halo0);
    if (wantsGradients)
      packed = packGradients(takeDifferences(grey.data(), out.dims, halo0, low, high), out.dims, z0, z1,
                             longestGradient * 255.0);
  } else {
    layerRanges = computeCellRanges(texels, out.dims, out.cells, cz0, cz1, halo0);
    if (gradients)
      packed = packGradients(gradients->planes(low, high), out.dims, z0, z1, longestGradient * plan.scale);
    else if (wantsGradients)
      packed = planeGradients(source, z0, z1, longestGradient * plan.scale);
  }
  if (wantsGradients) target.gradient.write(at, size, packed.data());
  out.cellRanges.insert(out.cellRanges.end(), layerRanges.begin(), layerRanges.end());
  nextCellZ = cz1;
}

bool VolumeUpload::step() {
  Impl& m = *mImpl;
  switch (m.plan.format) {
    case Format::R8:
      m.stepAs<std::uint8_t>();
      break;
    case Format::R16:
      m.stepAs<std::uint16_t>();
      break;
    case Format::Rgba8:
      m.stepAs<glm::u8vec4>();
      break;
    default:
      m.stepAs<float>();
      break;
  }
  if (m.nextCellZ < m.out.cells.size.z) return false;
  m.out.cellRange = gpu::Buffer("cell ranges", std::span<const glm::vec2>(m.out.cellRanges));
  return true;
}

double VolumeUpload::fractionDone() const { return double(mImpl->nextCellZ) / std::max(1, mImpl->out.cells.size.z); }
GpuVolume VolumeUpload::take() { return std::move(mImpl->out); }

}  // namespace velum::render
