#pragma once
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <string>

#include "velum/core/Error.h"
#include "volumes/Readers.h"

namespace velum::io {

/// Gives bytes to a reader as a file. It may refuse them with an Error; anything else is a finding, and so is a volume
/// whose voxels do not fit its shape.
template <class Reader>
int fuzzReader(Reader reader, const std::uint8_t* data, std::size_t size, scene::RawLayout raw = {}) {
  static const int file = ::memfd_create("fuzz", 0);
  if (::ftruncate(file, 0) != 0 || ::pwrite(file, data, size, 0) != ssize_t(size)) return 0;
  Progress progress;
  scene::Source source;
  source.path = "/proc/self/fd/" + std::to_string(file);
  source.raw = raw;
  try {
    Volume v = reader(source, progress);
    if (v.voxels.size() != timeStepBytes(v) * std::size_t(v.timeSteps) || v.dims.x < 1 || v.dims.y < 1 || v.dims.z < 1)
      std::abort();
    if (!(glm::determinant(v.worldFromVoxel) != 0.0)) std::abort();
    computeRange(v);
  } catch (const Error&) {
  }
  return 0;
}

}  // namespace velum::io
