#include "VolumeUpload.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>

#include "TransferTable.h"
#include "velum/gpu/GpuError.h"

namespace velum::render {

namespace {

using gpu::Format;

int maxOf(glm::ivec3 v) { return std::max(v.x, std::max(v.y, v.z)); }
std::size_t product(glm::ivec3 v) { return std::size_t(v.x) * std::size_t(v.y) * std::size_t(v.z); }

/// How a sample type is kept on the GPU: integers of 8 and 16 bits as they are (signed ones shifted), all else as
/// float.
struct TexelPlan {
  Format format = Format::R8;
  double scale = 1, offset = 0;  ///< raw = texel * scale + offset
};
constexpr TexelPlan kAsFloats{Format::R32f, 1.0, 0.0};

TexelPlan planFor(const Volume& volume, bool isMixed) {
  if (isMixed) return {Format::Rgba8, 1.0, 0.0};
  if (volume.isColor) return {Format::Rgba8, 255.0, 0.0};
  switch (volume.type) {
    case SampleType::UInt8:
      return {Format::R8, 255.0, 0.0};
    case SampleType::Int8:
      return {Format::R8, 255.0, -128.0};
    case SampleType::UInt16:
      return {Format::R16, 65535.0, 0.0};
    case SampleType::Int16:
      return {Format::R16, 65535.0, -32768.0};
    default:
      return kAsFloats;
  }
}

/// Texel of a raw sample: shifted to unsigned where the plan says so.
template <class Texel, class Raw>
Texel texelOf(Raw raw, float fallback) {
  if constexpr (std::is_same_v<Texel, float>) {
    float value = float(raw);
    return std::isfinite(value) ? value : fallback;
  } else if constexpr (std::is_signed_v<Raw>) {
    return Texel(int(raw) - int(std::numeric_limits<Raw>::min()));
  } else {
    return Texel(raw);
  }
}

float texelValue(std::uint8_t t) { return float(t) / 255.0f; }
float texelValue(std::uint16_t t) { return float(t) / 65535.0f; }
float texelValue(float t) { return t; }

}  // namespace

CellGrid cellGridFor(glm::ivec3 dims) {
  int edge = 4;
  while (maxOf(dims) > edge * 64) edge *= 2;
  return {edge, (dims + edge - 1) / edge};
}

template <class T>
std::vector<glm::vec2> computeCellRanges(const T* planes, glm::ivec3 dims, const CellGrid& cells, int firstCellZ,
                                         int lastCellZ, int firstPlane) {
  std::vector<glm::vec2> ranges(std::size_t(cells.size.x) * std::size_t(cells.size.y) *
                                std::size_t(lastCellZ - firstCellZ));
  std::size_t planeSize = std::size_t(dims.x) * std::size_t(dims.y);
  // Rows of cells are independent: reduce along z and y into one row of voxels, then along x into cells.
  tbb::parallel_for(0, (lastCellZ - firstCellZ) * cells.size.y, [&](int job) {
    int cz = firstCellZ + job / cells.size.y, cy = job % cells.size.y;
    int z0 = std::max(0, cz * cells.edge - 1), z1 = std::min(dims.z, (cz + 1) * cells.edge + 1);
    int y0 = std::max(0, cy * cells.edge - 1), y1 = std::min(dims.y, (cy + 1) * cells.edge + 1);
    std::vector<T> low(std::size_t(dims.x)), high(std::size_t(dims.x));
    const T* first = planes + std::size_t(z0 - firstPlane) * planeSize + std::size_t(y0) * std::size_t(dims.x);
    std::copy_n(first, dims.x, low.begin());
    std::copy_n(first, dims.x, high.begin());
    for (int z = z0; z < z1; ++z)
      for (int y = y0; y < y1; ++y) {
        const T* row = planes + std::size_t(z - firstPlane) * planeSize + std::size_t(y) * std::size_t(dims.x);
        T* lo = low.data();
        T* hi = high.data();
        for (int x = 0; x < dims.x; ++x) {
          lo[x] = row[x] < lo[x] ? row[x] : lo[x];
          hi[x] = row[x] > hi[x] ? row[x] : hi[x];
        }
      }
    glm::vec2* out = &ranges[(std::size_t(cz - firstCellZ) * std::size_t(cells.size.y) + std::size_t(cy)) *
                             std::size_t(cells.size.x)];
    for (int cx = 0; cx < cells.size.x; ++cx) {
      int x0 = std::max(0, cx * cells.edge - 1), x1 = std::min(dims.x, (cx + 1) * cells.edge + 1);
      out[cx] = {texelValue(*std::min_element(low.begin() + x0, low.begin() + x1)),
                 texelValue(*std::max_element(high.begin() + x0, high.begin() + x1))};
    }
  });
  return ranges;
}

template std::vector<glm::vec2> computeCellRanges(const std::uint8_t*, glm::ivec3, const CellGrid&, int, int, int);
template std::vector<glm::vec2> computeCellRanges(const std::uint16_t*, glm::ivec3, const CellGrid&, int, int, int);
template std::vector<glm::vec2> computeCellRanges(const float*, glm::ivec3, const CellGrid&, int, int, int);

struct VolumeUpload::Impl {
  Shared<Volume> volume;
  int channel = 0, frame = 0;
  MixTable mix;    ///< Channels that are mixed; else empty.
  int factor = 1;  ///< Voxels of the volume along the edge of one of the texture.
  bool isQuick = false;
  TexelPlan plan;
  GpuVolume out;
  std::vector<glm::vec2> ranges;
  int nextCellZ = 0;
  int cellLayersPerStep = 1;
  double longestGradient = 1;  ///< Texels.

  template <class Raw>
  void mixPlanes(const Raw* frameStart, int z0, int z1, std::vector<glm::u8vec4>& texels) const;
  template <class Texel, class Raw>
  void convertPlanes(const Raw* frameStart, int z0, int z1, std::vector<Texel>& texels) const;
  template <class Texel>
  const Texel* planes(int z0, int z1, std::vector<Texel>& scratch) const;
  template <class Texel>
  void uploadGradients(const Texel* texels, int firstPlane, int z0, int z1);
  template <class Texel>
  void stepAs();
};

VolumeUpload::VolumeUpload(const scene::VolumeLayer& layer, const gpu::Limits& limits, int mostAlong)
    : mImpl(std::make_unique<Impl>()) {
  Impl& m = *mImpl;
  const Shared<Volume>& volume = layer.data;
  m.volume = volume;
  m.channel = std::clamp(layer.channel, 0, volume->channels - 1);
  m.frame = std::clamp(layer.frame, 0, volume->frames - 1);
  bool isMixed = scene::mixesChannels(layer), isColor = volume->isColor || isMixed;
  if (isMixed) m.mix = makeMixTable(layer);
  m.plan = planFor(*volume, isMixed);
  // Take the best level whose sides and bytes the driver can hold beside pictures and tables.
  auto dimsAt = [&](int factor) { return (volume->dims + factor - 1) / factor; };
  bool wantsGradients = limits.isSoftware && !isColor;
  auto bytesAt = [&](int factor) {
    return product(dimsAt(factor)) * (gpu::texelBytes(m.plan.format) + (wantsGradients ? 4 : 0));
  };
  m.isQuick = mostAlong > 0;
  if (m.isQuick) m.factor = std::max(1, (maxOf(volume->dims) + mostAlong - 1) / mostAlong);
  double mostBytes = 0.7 * double(limits.memoryBytes);
  while (maxOf(dimsAt(m.factor)) > limits.texture3d || double(bytesAt(m.factor)) > mostBytes) ++m.factor;
  // A software driver unpacks the eight texels of each fetch: floats are fetched nearly twice as fast as bytes.
  if (TexelPlan narrow = m.plan; limits.isSoftware && !isColor) {
    m.plan = kAsFloats;
    if (double(bytesAt(m.factor)) > mostBytes) m.plan = narrow;
  }
  GpuVolume& out = m.out;
  out.dims = dimsAt(m.factor);
  if (m.factor > 1) {
    bool tooLong = maxOf(volume->dims) > limits.texture3d;
    out.reduction = fmt::format("shown at 1/{} of its resolution ({} x {} x {} of {} x {} x {} voxels): {}", m.factor,
                                out.dims.x, out.dims.y, out.dims.z, volume->dims.x, volume->dims.y, volume->dims.z,
                                tooLong ? fmt::format("the driver's 3D textures end at {} texels", limits.texture3d)
                                        : fmt::format("it needs {} MiB of the {} MiB that the driver has",
                                                      bytesAt(1) >> 20, limits.memoryBytes >> 20));
  }
  out.cells = cellGridFor(out.dims);
  out.isColor = volume->isColor;
  out.isMixed = isMixed;
  out.valueScale = isMixed ? 1.0 : m.plan.scale * volume->scale;
  out.valueOffset = isMixed ? 0.0 : m.plan.offset * volume->scale + volume->offset;
  glm::dmat4 voxelFromTex(1.0);
  for (int axis = 0; axis < 3; ++axis) {
    voxelFromTex[axis][axis] = double(out.dims[axis]) * m.factor;
    voxelFromTex[3][axis] = -0.5;
  }
  out.worldFromTex = volume->worldFromVoxel * voxelFromTex;
  out.texture = gpu::Texture::make3d("volume", m.plan.format, out.dims);
  if (wantsGradients) {
    out.gradient = gpu::Texture::make3d("gradients", Format::Rgba8, out.dims);
    // No difference is longer than the data's whole range along all three axes.
    m.longestGradient =
        std::sqrt(3.0) * std::max(1e-30, (volume->range.y - volume->range.x) / std::abs(out.valueScale));
    out.gradientScale = m.longestGradient * 255.0 / 127.0;
  }
  std::size_t layerBytes = std::size_t(out.dims.x) * std::size_t(out.dims.y) * std::size_t(out.cells.edge) *
                           gpu::texelBytes(m.plan.format) * (m.isQuick ? 1 : std::size_t(m.factor));
  constexpr std::size_t kStepBytes = 4u << 20;
  m.cellLayersPerStep = int(std::max<std::size_t>(1, kStepBytes / std::max<std::size_t>(1, layerBytes)));
  m.ranges.reserve(product(out.cells.size));
}

VolumeUpload::~VolumeUpload() = default;

/// Texels of mixed channels: the extinctions of a block's voxels are averaged, as those of the channels are added.
template <class Raw>
void VolumeUpload::Impl::mixPlanes(const Raw* frameStart, int z0, int z1, std::vector<glm::u8vec4>& texels) const {
  const Volume& v = *volume;
  glm::ivec3 dims = out.dims;
  texels.resize(std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(z1 - z0));
  double perValue = (MixTable::kSize - 1) / (mix.domain.y - mix.domain.x);
  float scale = float(v.scale * perValue), offset = float((v.offset - mix.domain.x) * perValue + 0.5);
  int block = isQuick ? 1 : factor, middle = isQuick ? factor / 2 : 0;
  tbb::parallel_for(0, (z1 - z0) * dims.y, [&](int job) {
    glm::ivec3 at(0, job % dims.y, z0 + job / dims.y);
    glm::u8vec4* row = &texels[std::size_t(job) * std::size_t(dims.x)];
    for (at.x = 0; at.x < dims.x; ++at.x) {
      glm::ivec3 first = glm::min(at * factor + middle, v.dims - 1), last = glm::min(first + block, v.dims);
      glm::vec4 sum(0.0f);
      for (int z = first.z; z < last.z; ++z)
        for (int y = first.y; y < last.y; ++y)
          for (int x = first.x; x < last.x; ++x) {
            auto index =
                (std::size_t(z) * std::size_t(v.dims.y) + std::size_t(y)) * std::size_t(v.dims.x) + std::size_t(x);
            const Raw* raw = frameStart + index * std::size_t(v.channels);
            for (std::size_t c = 0; c < mix.channels.size(); ++c) {
              float entry = float(raw[c]) * scale + offset;
              entry = entry > 0.0f ? std::min(entry, float(MixTable::kSize - 1)) : 0.0f;  // not a number: 0
              sum += mix.channels[c][std::size_t(entry)];
            }
          }
      glm::ivec3 extent = last - first;
      sum /= float(extent.x * extent.y * extent.z);
      float alpha = std::sqrt(std::min(sum.w, 1.0f));
      glm::vec3 color = sum.w > 0.0f ? glm::vec3(sum) * (alpha / sum.w) : glm::vec3(0.0f);
      row[at.x] = glm::u8vec4(glm::clamp(glm::vec4(color, alpha), 0.0f, 1.0f) * 255.0f + 0.5f);
    }
  });
}

/// Texels of the level's planes z0..z1: the mean of each block of `factor`^3 samples, or the sample itself.
template <class Texel, class Raw>
void VolumeUpload::Impl::convertPlanes(const Raw* frameStart, int z0, int z1, std::vector<Texel>& texels) const {
  const Volume& v = *volume;
  glm::ivec3 dims = out.dims;
  texels.resize(std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(z1 - z0));
  float fallback = float((v.range.x - v.offset) / (v.scale == 0 ? 1 : v.scale));
  std::size_t stride = std::size_t(v.channels);
  auto rawAt = [&](int x, int y, int z) {
    return frameStart +
           ((std::size_t(z) * std::size_t(v.dims.y) + std::size_t(y)) * std::size_t(v.dims.x) + std::size_t(x)) *
               stride;
  };
  double colorScale = v.range.y > 255 ? 255.0 / v.range.y : 1.0;
  tbb::parallel_for(0, (z1 - z0) * dims.y, [&](int job) {
    int z = z0 + job / dims.y, y = job % dims.y;
    Texel* row = &texels[(std::size_t(z - z0) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x)];
    for (int x = 0; x < dims.x; ++x) {
      if constexpr (std::is_same_v<Texel, glm::u8vec4>) {
        const Raw* p = rawAt(std::min(x * factor, v.dims.x - 1), std::min(y * factor, v.dims.y - 1),
                             std::min(z * factor, v.dims.z - 1));
        glm::dvec3 rgb = glm::clamp(glm::dvec3(double(p[0]), double(p[1]), double(p[2])) * colorScale, 0.0, 255.0);
        double grey = 0.2126 * rgb.r + 0.7152 * rgb.g + 0.0722 * rgb.b;
        row[x] = glm::u8vec4(glm::dvec4(rgb, grey) + 0.5);
      } else if (factor == 1 || isQuick) {
        auto at = [&](int i, int most) { return std::min(i * factor + factor / 2, most - 1); };
        row[x] = texelOf<Texel>(rawAt(at(x, v.dims.x), at(y, v.dims.y), at(z, v.dims.z))[channel], fallback);
      } else {
        double sum = 0;
        int count = 0;
        for (int c = z * factor; c < std::min((z + 1) * factor, v.dims.z); ++c)
          for (int b = y * factor; b < std::min((y + 1) * factor, v.dims.y); ++b)
            for (int a = x * factor; a < std::min((x + 1) * factor, v.dims.x); ++a, ++count)
              sum += double(texelOf<Texel>(rawAt(a, b, c)[channel], fallback));
        row[x] = std::is_same_v<Texel, float> ? Texel(sum / count) : Texel(sum / count + 0.5);
      }
    }
  });
}

/// The planes as texels: straight from the volume when nothing has to change, else converted into `scratch`.
template <class Texel>
const Texel* VolumeUpload::Impl::planes(int z0, int z1, std::vector<Texel>& scratch) const {
  const Volume& v = *volume;
  std::size_t planeSize = std::size_t(v.dims.x) * std::size_t(v.dims.y);
  std::size_t frameSamples = voxelCount(v) * std::size_t(v.channels);
  return visitSamples(v, [&](auto* samples) -> const Texel* {
    using Raw = std::remove_cvref_t<decltype(*samples)>;
    const Raw* start = samples + frameSamples * std::size_t(frame);
    if constexpr (std::is_same_v<Raw, Texel> && !std::is_same_v<Texel, float>) {
      if (factor == 1 && v.channels == 1) return start + planeSize * std::size_t(z0);
    }
    if constexpr (std::is_same_v<Texel, glm::u8vec4>) {
      if (out.isMixed) {
        mixPlanes(start, z0, z1, scratch);
        return scratch.data();
      }
    }
    convertPlanes<Texel>(start, z0, z1, scratch);
    return scratch.data();
  });
}

/// Central differences of planes z0..z1, as the shader would take them: beyond the border a voxel repeats. They are
/// kept relative to the longest of their 27 neighbours, whose length changes slowly, so that directions between two
/// voxels are weighted by the lengths there: else the noise of a flat place would turn the normals of the edge beside
/// it.
/// @param texels  planes z0 - 2 .. z1 + 2 of the level, as far as there are any, the first of them being firstPlane
template <class Texel>
void VolumeUpload::Impl::uploadGradients(const Texel* texels, int firstPlane, int z0, int z1) {
  glm::ivec3 dims = out.dims;
  auto width = std::size_t(dims.x), height = std::size_t(dims.y);
  auto rowAt = [&](int y, int z) {
    y = std::clamp(y, 0, dims.y - 1), z = std::clamp(z, 0, dims.z - 1);
    return texels + (std::size_t(z - firstPlane) * height + std::size_t(y)) * width;
  };
  auto visitRow = [&](int y, int z, auto&& visit) {
    const Texel *here = rowAt(y, z), *y0 = rowAt(y - 1, z), *y1 = rowAt(y + 1, z), *below = rowAt(y, z - 1),
                *above = rowAt(y, z + 1);
    auto at = [&](int x, int x0, int x1) {
      visit(x, glm::vec3(float(here[x1]) - float(here[x0]), float(y1[x]) - float(y0[x]),
                         float(above[x]) - float(below[x])));
    };
    at(0, 0, std::min(1, dims.x - 1));
    for (int x = 1; x < dims.x - 1; ++x) at(x, x - 1, x + 1);
    if (dims.x > 1) at(dims.x - 1, dims.x - 2, dims.x - 1);
  };
  int low = std::max(0, z0 - 1), high = std::min(dims.z, z1 + 1);
  std::vector<float> squares(width * height * std::size_t(high - low));
  tbb::parallel_for(0, (high - low) * dims.y, [&](int job) {
    float* row = &squares[std::size_t(job) * width];
    visitRow(job % dims.y, low + job / dims.y, [&](int x, glm::vec3 g) { row[x] = glm::dot(g, g); });
  });
  std::vector<glm::u8vec4> gradients(width * height * std::size_t(z1 - z0));
  float toShare =
      float(1.0 / (longestGradient * (std::is_same_v<Texel, float> ? 1.0 : double(std::numeric_limits<Texel>::max()))));
  tbb::parallel_for(0, (z1 - z0) * dims.y, [&](int job) {
    int z = z0 + job / dims.y, y = job % dims.y;
    std::vector<float> largest(width + 2, 0.0f);  // of the nine rows around; one more at each end
    for (int c = std::max(low, z - 1); c < std::min(high, z + 2); ++c)
      for (int b = std::max(0, y - 1); b < std::min(dims.y, y + 2); ++b) {
        const float* row = &squares[(std::size_t(c - low) * height + std::size_t(b)) * width];
        for (std::size_t x = 0; x < width; ++x) largest[x + 1] = std::max(largest[x + 1], row[x]);
      }
    glm::u8vec4* row = &gradients[std::size_t(job) * width];
    visitRow(y, z, [&](int x, glm::vec3 g) {
      const float* around = &largest[std::size_t(x)];
      float longest = std::sqrt(std::max(around[0], std::max(around[1], around[2])));
      float toByte = longest > 0 ? 127.0f / longest : 0.0f;
      row[x] = {std::uint8_t(g.x * toByte + 128.5f), std::uint8_t(g.y * toByte + 128.5f),
                std::uint8_t(g.z * toByte + 128.5f),
                std::uint8_t(255.0f * std::sqrt(std::min(1.0f, longest * toShare)) + 0.5f)};
    });
  });
  out.gradient.write({0, 0, z0}, {dims.x, dims.y, z1 - z0}, gradients.data());
}

template <class Texel>
void VolumeUpload::Impl::stepAs() {
  int cz0 = nextCellZ, cz1 = std::min(out.cells.size.z, cz0 + cellLayersPerStep);
  int z0 = cz0 * out.cells.edge, z1 = std::min(out.dims.z, cz1 * out.cells.edge);
  int halo = out.gradient ? 2 : 1;
  int halo0 = std::max(0, z0 - halo), halo1 = std::min(out.dims.z, z1 + halo);
  std::vector<Texel> scratch;
  const Texel* texels = planes<Texel>(halo0, halo1, scratch);
  std::size_t planeSize = std::size_t(out.dims.x) * std::size_t(out.dims.y);
  out.texture.write({0, 0, z0}, {out.dims.x, out.dims.y, z1 - z0}, texels + planeSize * std::size_t(z0 - halo0));
  std::vector<glm::vec2> layerRanges;
  if constexpr (std::is_same_v<Texel, glm::u8vec4>) {
    std::vector<std::uint8_t> grey(planeSize * std::size_t(halo1 - halo0));
    for (std::size_t i = 0; i < grey.size(); ++i) grey[i] = texels[i].a;
    layerRanges = computeCellRanges(grey.data(), out.dims, out.cells, cz0, cz1, halo0);
  } else {
    layerRanges = computeCellRanges(texels, out.dims, out.cells, cz0, cz1, halo0);
    if (out.gradient) uploadGradients(texels, halo0, z0, z1);
  }
  ranges.insert(ranges.end(), layerRanges.begin(), layerRanges.end());
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
  m.out.cellRange = gpu::Buffer("cell ranges", std::span<const glm::vec2>(m.ranges));
  return true;
}

double VolumeUpload::fractionDone() const { return double(mImpl->nextCellZ) / std::max(1, mImpl->out.cells.size.z); }
GpuVolume VolumeUpload::take() { return std::move(mImpl->out); }

namespace {

/// Sets of ids (mod 64) over blocks of 8^3 label voxels.
struct BlockSets {
  static constexpr int kEdge = 8;
  glm::ivec3 size{0};
  std::vector<std::uint64_t> sets;
  std::uint64_t at(glm::ivec3 b) const {
    return sets[(std::size_t(b.z) * std::size_t(size.y) + std::size_t(b.y)) * std::size_t(size.x) + std::size_t(b.x)];
  }
};

BlockSets collectSets(const LabelVolume& labels) {
  BlockSets blocks;
  blocks.size = (labels.dims() + BlockSets::kEdge - 1) / BlockSets::kEdge;
  blocks.sets.assign(product(blocks.size), 0);
  constexpr int kPerBrick = LabelVolume::kBrickSize / BlockSets::kEdge;
  glm::ivec3 grid = labels.brickGrid();
  tbb::parallel_for(0, grid.x * grid.y * grid.z, [&](int job) {
    glm::ivec3 index(job % grid.x, job / grid.x % grid.y, job / (grid.x * grid.y));
    const auto& brick = labels.brick(index);
    for (int block = 0; block < kPerBrick * kPerBrick * kPerBrick; ++block) {
      glm::ivec3 inner(block % kPerBrick, block / kPerBrick % kPerBrick, block / (kPerBrick * kPerBrick));
      glm::ivec3 at = index * kPerBrick + inner;
      if (glm::any(glm::greaterThanEqual(at, blocks.size))) continue;
      std::uint64_t set = 0;
      if (brick.size() == 1) {
        set = std::uint64_t(1) << (brick[0] % 64);
      } else {
        for (int z = 0; z < BlockSets::kEdge; ++z)
          for (int y = 0; y < BlockSets::kEdge; ++y) {
            const auto* row = &brick[((std::size_t(inner.z * BlockSets::kEdge + z)) * LabelVolume::kBrickSize +
                                      std::size_t(inner.y * BlockSets::kEdge + y)) *
                                         LabelVolume::kBrickSize +
                                     std::size_t(inner.x * BlockSets::kEdge)];
            for (int x = 0; x < BlockSets::kEdge; ++x) set |= std::uint64_t(1) << (row[x] % 64);
          }
      }
      blocks.sets[(std::size_t(at.z) * std::size_t(blocks.size.y) + std::size_t(at.y)) * std::size_t(blocks.size.x) +
                  std::size_t(at.x)] = set;
    }
  });
  return blocks;
}

/// For each cell, the union of the blocks that its box (with the halo) touches in the labels' grid.
std::vector<glm::uvec2> setsOfCells(const LabelVolume& labels, const CellGrid& cells, glm::ivec3 dims,
                                    const glm::dmat4& worldFromTex) {
  BlockSets blocks = collectSets(labels);
  glm::dmat4 labelFromTex = glm::inverse(labels.worldFromVoxel()) * worldFromTex;
  std::vector<glm::uvec2> sets(product(cells.size));
  tbb::parallel_for(0, cells.size.z * cells.size.y, [&](int job) {
    for (int cx = 0; cx < cells.size.x; ++cx) {
      glm::ivec3 cell(cx, job % cells.size.y, job / cells.size.y);
      glm::dvec3 low(1e30), high(-1e30);
      for (int corner = 0; corner < 8; ++corner) {
        glm::dvec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
        glm::dvec3 tex = ((glm::dvec3(cell) + step) * double(cells.edge) + (step * 2.0 - 1.0)) / glm::dvec3(dims);
        glm::dvec3 p(labelFromTex * glm::dvec4(tex, 1.0));
        low = glm::min(low, p), high = glm::max(high, p);
      }
      std::uint64_t set = 0;
      glm::dvec3 last = glm::dvec3(labels.dims()) - 1.0;
      bool leaves = glm::any(glm::lessThan(low, glm::dvec3(-0.5))) || glm::any(glm::greaterThan(high, last + 0.5));
      if (leaves) set |= 1;  // outside the labels there is no structure: id 0
      glm::ivec3 b0 = glm::ivec3(glm::floor(glm::clamp(low - 1.0, glm::dvec3(0.0), last))) / BlockSets::kEdge;
      glm::ivec3 b1 = glm::ivec3(glm::ceil(glm::clamp(high + 1.0, glm::dvec3(0.0), last))) / BlockSets::kEdge;
      for (int z = b0.z; z <= b1.z; ++z)
        for (int y = b0.y; y <= b1.y; ++y)
          for (int x = b0.x; x <= b1.x; ++x) set |= blocks.at({x, y, z});
      sets[std::size_t(job) * std::size_t(cells.size.x) + std::size_t(cx)] = {std::uint32_t(set),
                                                                              std::uint32_t(set >> 32)};
    }
  });
  return sets;
}

}  // namespace

GpuLabels uploadLabels(const LabelVolume& labels, const CellGrid& cells, glm::ivec3 dims,
                       const glm::dmat4& worldFromTex, const gpu::Limits& limits) {
  if (maxOf(labels.dims()) > limits.texture3d ||
      double(product(labels.dims())) * 2.0 > 0.7 * double(limits.memoryBytes))
    throw gpu::GpuError(fmt::format(
        "the labels ({} x {} x {}) are larger than the driver's 3D textures ({}) or memory; crop or reduce them",
        labels.dims().x, labels.dims().y, labels.dims().z, limits.texture3d));
  GpuLabels out;
  out.dims = labels.dims();
  bool small =
      std::all_of(labels.table.begin(), labels.table.end(), [](const LabelInfo& info) { return info.id < 256; });
  out.texture = gpu::Texture::make3d("labels", small ? Format::R8ui : Format::R16ui, out.dims);
  glm::ivec3 slab(out.dims.x, out.dims.y, 0);
  std::vector<std::uint16_t> ids;
  std::vector<std::uint8_t> bytes;
  for (int z = 0; z < out.dims.z; z += LabelVolume::kBrickSize) {
    slab.z = std::min(LabelVolume::kBrickSize, out.dims.z - z);
    ids.resize(product(slab));
    labels.read({0, 0, z}, slab, ids);
    if (small) bytes.assign(ids.begin(), ids.end());
    out.texture.write({0, 0, z}, slab, small ? static_cast<const void*>(bytes.data()) : ids.data());
  }
  out.cellLabels =
      gpu::Buffer("cell labels", std::span<const glm::uvec2>(setsOfCells(labels, cells, dims, worldFromTex)));
  return out;
}

}  // namespace velum::render
