#pragma once
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "FuzzFile.h"
#include "core/Error.h"
#include "core/Mesh.h"
#include "core/Volume.h"
#include "io/volumes/Readers.h"

/// What is asked of every reader: it may refuse the bytes with an Error; anything else is a finding, and so is
/// something that does not fit together.
namespace velum::io {

inline void require(bool isSo) {
  if (!isSo) std::abort();
}

inline void expectOneLine(const Error& error) {
  require(std::string_view(error.what()).find('\n') == std::string_view::npos);
}

inline void expectSound(Volume& v) {
  require(v.dims.x >= 1 && v.dims.y >= 1 && v.dims.z >= 1 && v.channels >= 1 && v.timeSteps >= 1);
  require(v.voxels.size() == timeStepBytes(v) * std::size_t(v.timeSteps));
  double volume = glm::determinant(v.worldFromVoxel);
  require(std::isfinite(volume) && volume != 0.0);
  require(v.channelNames.empty() || v.channelNames.size() == std::size_t(v.channels));
  computeRange(v);
}

/// @param read  takes the file's path
template <class Read>
int fuzzVolume(FuzzFile& file, Read read, const std::uint8_t* data, std::size_t size, scene::RawLayout raw = {}) {
  file.hold(data, size);
  Progress progress;
  scene::Source source;
  source.path = file.path().string();
  source.raw = raw;
  try {
    Volume volume = read(source, progress);
    expectSound(volume);
  } catch (const Error& error) {
    expectOneLine(error);
  }
  return 0;
}

template <class Read>
int fuzzMesh(FuzzFile& file, Read read, const std::uint8_t* data, std::size_t size) {
  file.hold(data, size);
  Progress progress;
  try {
    Mesh mesh = read(file.path(), progress);
    require(mesh.indices.size() % 3 == 0);
    require(std::all_of(mesh.indices.begin(), mesh.indices.end(), [&](auto i) { return i < mesh.positions.size(); }));
    require(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size());
    for (const auto& p : mesh.positions) require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  } catch (const Error& error) {
    expectOneLine(error);
  }
  return 0;
}

}  // namespace velum::io
