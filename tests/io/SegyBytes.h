#pragma once
#include <cmath>
#include <cstring>
#include <fstream>

#include "TempFolder.h"
#include "core/Error.h"
#include "io/volumes/ReadVolume.h"
#include "io/volumes/Readers.h"

/// SEG-Y files made by hand.
namespace velum::io {

/// Bytes of a SEG-Y file made by hand.
struct Writer {
  std::string bytes;
  bool isLittle = false;
  void put(std::size_t at, std::uint64_t value, std::size_t size) {
    if (bytes.size() < at + size) bytes.resize(at + size, '\0');
    for (std::size_t i = 0; i < size; ++i) bytes[at + i] = char((value >> (8 * (isLittle ? i : size - 1 - i))) & 0xff);
  }
};

inline std::uint32_t ibmFromFloat(float f) {
  if (f == 0) return 0;
  std::uint32_t sign = std::signbit(f) ? 0x80000000u : 0u;
  double fraction = std::abs(double(f));
  int exponent = 0;
  while (fraction >= 1) fraction /= 16, ++exponent;
  while (fraction < 1.0 / 16) fraction *= 16, --exponent;
  return sign | std::uint32_t(exponent + 64) << 24 | std::uint32_t(fraction * 16777216.0);
}

struct Trace {
  int inlineNumber, crosslineNumber, x, y, offset = 0;
};

/// A sample that tells its place.
inline float truth(const Trace& t, int z) {
  return float(t.inlineNumber) - 0.25f * float(t.crosslineNumber) + 0.5f * float(z) - 7.0f;
}

inline std::string makeSegy(int code, bool isLittle, const std::vector<Trace>& traces, int samples) {
  Writer w{std::string(3200, ' '), isLittle};
  w.put(3216, 2000, 2), w.put(3220, std::uint64_t(samples), 2), w.put(3224, std::uint64_t(code), 2), w.put(3599, 0, 1);
  for (const Trace& t : traces) {
    std::size_t at = w.bytes.size();
    w.put(at + 188, std::uint32_t(t.inlineNumber), 4), w.put(at + 192, std::uint32_t(t.crosslineNumber), 4);
    w.put(at + 36, std::uint32_t(t.offset), 4);
    w.put(at + 180, std::uint32_t(t.x), 4), w.put(at + 184, std::uint32_t(t.y), 4),
        w.put(at + 70, std::uint16_t(-10), 2);
    w.put(at + 239, 0, 1);
    for (int z = 0; z < samples; ++z) {
      float value = truth(t, z);
      std::uint32_t ieee;
      std::memcpy(&ieee, &value, 4);
      if (code == 1) w.put(w.bytes.size(), ibmFromFloat(value), 4);
      if (code == 5) w.put(w.bytes.size(), ieee, 4);
      if (code == 2) w.put(w.bytes.size(), std::uint32_t(std::int32_t(value * 4)), 4);
      if (code == 3) w.put(w.bytes.size(), std::uint16_t(std::int16_t(value * 4)), 2);
      if (code == 8) w.put(w.bytes.size(), std::uint8_t(std::int8_t(value)), 1);
    }
  }
  return w.bytes;
}

/// Inlines 100, 102, ... 12.5 m apart, crosslines 7, 8, ... 25 m apart, on axes that are turned in the map.
inline std::vector<Trace> cube(int inlines, int crosslines) {
  std::vector<Trace> traces;
  for (int i = 0; i < inlines; ++i)
    for (int j = 0; j < crosslines; ++j) {
      double x = 600000 + 12.5 * 0.6 * i - 25.0 * 0.8 * j, y = 5000000 + 12.5 * 0.8 * i + 25.0 * 0.6 * j;
      traces.push_back({100 + 2 * i, 7 + j, int(std::lround(x * 10)), int(std::lround(y * 10))});
    }
  return traces;
}

inline Volume readBytes(const std::string& bytes) {
  TempFolder folder;
  std::ofstream(folder / "a.sgy", std::ios::binary) << bytes;
  Progress progress;
  scene::Source source;
  source.path = (folder / "a.sgy").string();
  return readVolume(source, progress);
}

}  // namespace velum::io
