#pragma once
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "TempFolder.h"
#include "io/labels/ReadLabels.h"
#include "io/labels/WriteLabels.h"
#include "io/volumes/ReadVolume.h"
#include "io/volumes/WriteVolume.h"

namespace velum::io {

inline Volume read(const std::filesystem::path& path) {
  Progress progress;
  scene::Source source;
  source.path = path.string();
  return readVolume(source, progress);
}

inline LabelVolume readLabelsOf(const std::filesystem::path& path) {
  Progress progress;
  scene::Source source;
  source.path = path.string();
  return readLabels(source, progress);
}

inline void write(const Volume& volume, const std::filesystem::path& path) {
  Progress progress;
  writeVolume(volume, path, progress);
}

inline void writeText(const std::filesystem::path& path, const std::string& text) {
  // ext4 writes a file that is cut to nothing and filled again to the disk at once: milliseconds.
  std::filesystem::remove(path);
  std::ofstream(path, std::ios::binary) << text;
}

/// @param mode  of zlib's gzopen()
inline void writeGzip(const std::filesystem::path& path, const std::string& bytes, const char* mode = "wb") {
  gzFile file = ::gzopen(path.c_str(), mode);
  ::gzwrite(file, bytes.data(), unsigned(bytes.size()));
  ::gzclose(file);
}

inline std::string bytesOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The first warning with a word in it; empty when there is none.
inline std::string warningWith(const Volume& v, const std::string& word) {
  for (const std::string& w : v.warnings)
    if (w.find(word) != std::string::npos) return w;
  return {};
}

/// A volume of every sample type: a ramp that meets the ends of the type.
inline Volume rampVolume(SampleType type, glm::ivec3 dims, int channels = 1, int frames = 1) {
  Volume v;
  v.dims = dims;
  v.type = type;
  v.channels = channels;
  v.timeSteps = frames;
  v.voxels.resize(timeStepBytes(v) * std::size_t(frames));
  for (std::size_t i = 0; i < v.voxels.size(); ++i) v.voxels[i] = std::byte(i * 37 + i / 251);
  if (type == SampleType::Float32 || type == SampleType::Float64) {
    for (std::size_t i = 0; i < v.voxels.size() / sampleSize(type); ++i) {
      double value = std::sin(double(i)) * 1000;
      float asFloat = float(value);
      if (type == SampleType::Float64)
        std::memcpy(v.voxels.data() + i * 8, &value, 8);
      else
        std::memcpy(v.voxels.data() + i * 4, &asFloat, 4);
    }
  }
  return v;
}

/// Oblique, sheared a little when asked, left-handed when asked.
inline glm::dmat4 obliqueMatrix(bool leftHanded, bool sheared) {
  double a = 0.3, b = -0.7;
  glm::dmat3 rz(std::cos(a), std::sin(a), 0, -std::sin(a), std::cos(a), 0, 0, 0, 1);
  glm::dmat3 rx(1, 0, 0, 0, std::cos(b), std::sin(b), 0, -std::sin(b), std::cos(b));
  glm::dmat3 m = rz * rx;
  m = glm::dmat3(m[0] * 0.7, m[1] * 0.8, m[2] * (leftHanded ? -2.5 : 2.5));
  if (sheared) m[2] += m[1] * 0.4;
  glm::dmat4 result(m);
  result[3] = glm::dvec4(-12.5, 230.25, 41.125, 1.0);
  return result;
}

inline void expectSameMatrix(const glm::dmat4& a, const glm::dmat4& b, double tolerance) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) EXPECT_NEAR(a[c][r], b[c][r], tolerance) << "column " << c << " row " << r;
}

/// The one-line law of errors: names the file, says something, has no line end.
inline void expectClearError(const std::filesystem::path& path) {
  try {
    Volume v = read(path);
    FAIL() << path << " opened with " << v.dims.x << " x " << v.dims.y << " x " << v.dims.z;
  } catch (const InputError& error) {
    std::string message = error.what();
    EXPECT_NE(message.find(path.filename().string()), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_GT(message.size(), path.string().size() + 8) << message;
  }
}

/// The folder of shared test data, or empty.
inline std::filesystem::path testData() {
  const char* folder = std::getenv("VELUM_TEST_DATA");
  return folder ? folder : "";
}
#define VELUM_NEED_TEST_DATA() \
  if (testData().empty()) GTEST_SKIP() << "set VELUM_TEST_DATA to the folder of test volumes"

}  // namespace velum::io
