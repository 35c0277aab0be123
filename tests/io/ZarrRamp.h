#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "Damage.h"
#include "ZarrFiles.h"

namespace velum::io {

namespace fs = std::filesystem;

/// An array of z, y, x whose values are the numbers of its samples.
inline ZarrFile ramp(const fs::path& folder) {
  ZarrFile file;
  file.folder = folder;
  file.shape = {4, 6, 8};
  file.chunk = {2, 3, 4};
  file.value = [](const Sizes& i) { return double(i[0] * 48 + i[1] * 8 + i[2]); };
  return file;
}

}  // namespace velum::io
