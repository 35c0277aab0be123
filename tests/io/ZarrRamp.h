#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "TestFiles.h"
#include "ZarrFiles.h"
#include "core/Error.h"

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

/// What a refusal says of the array in a folder; empty where it is read.
inline std::string refusalOf(const fs::path& folder) {
  try {
    Volume v = read(folder);
    return {};
  } catch (const InputError& error) {
    std::string message = error.what();
    EXPECT_EQ(message.find('\n'), message.npos) << message;
    return message;
  }
}

}  // namespace velum::io
