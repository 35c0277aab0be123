#include "render/upload/VolumeTexels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "core/Parallel.h"

namespace velum::render {

namespace {

using gpu::Format;

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

}  // namespace

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

/// Texels of mixed channels: the extinctions of a block's voxels are averaged, as those of the channels are added.
template <class Raw>
void VolumeTexels::mixPlanes(const Raw* samples, int z0, int z1, std::vector<glm::u8vec4>& texels) const {
  const Volume& v = *volume;
  texels.resize(std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(z1 - z0));
  double perValue = (MixTable::kSize - 1) / (mix.domain.y - mix.domain.x);
  float scale = float(v.scale * perValue), offset = float((v.offset - mix.domain.x) * perValue + 0.5);
  int block = isQuick ? 1 : factor, middle = isQuick ? factor / 2 : 0;
  parallelFor(0, (z1 - z0) * dims.y, [&](int job) {
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
            const Raw* raw = samples + index * std::size_t(v.channels);
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
void VolumeTexels::convertPlanes(const Raw* samples, int z0, int z1, std::vector<Texel>& texels) const {
  const Volume& v = *volume;
  texels.resize(std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(z1 - z0));
  float fallback = float((v.range.x - v.offset) / (v.scale == 0 ? 1 : v.scale));
  std::size_t stride = std::size_t(v.channels);
  auto rawAt = [&](int x, int y, int z) {
    return samples +
           ((std::size_t(z) * std::size_t(v.dims.y) + std::size_t(y)) * std::size_t(v.dims.x) + std::size_t(x)) *
               stride;
  };
  double colorScale = v.range.y > 255 ? 255.0 / v.range.y : 1.0;
  parallelFor(0, (z1 - z0) * dims.y, [&](int job) {
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

template <class Texel>
const Texel* VolumeTexels::planes(int z0, int z1, std::vector<Texel>& scratch) const {
  const Volume& v = *volume;
  std::size_t planeSize = std::size_t(v.dims.x) * std::size_t(v.dims.y);
  std::size_t samplesPerStep = voxelCount(v) * std::size_t(v.channels);
  return visitSamples(v, [&](auto* samples) -> const Texel* {
    using Raw = std::remove_cvref_t<decltype(*samples)>;
    const Raw* start = samples + samplesPerStep * std::size_t(timeStep);
    if constexpr (std::is_same_v<Raw, Texel> && !std::is_same_v<Texel, float>) {
      if (factor == 1 && v.channels == 1) return start + planeSize * std::size_t(z0);
    }
    if constexpr (std::is_same_v<Texel, glm::u8vec4>) {
      if (isMixed) {
        mixPlanes(start, z0, z1, scratch);
        return scratch.data();
      }
    }
    convertPlanes<Texel>(start, z0, z1, scratch);
    return scratch.data();
  });
}

template const std::uint8_t* VolumeTexels::planes(int, int, std::vector<std::uint8_t>&) const;
template const std::uint16_t* VolumeTexels::planes(int, int, std::vector<std::uint16_t>&) const;
template const float* VolumeTexels::planes(int, int, std::vector<float>&) const;
template const glm::u8vec4* VolumeTexels::planes(int, int, std::vector<glm::u8vec4>&) const;

}  // namespace velum::render
