#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <random>
#include <string>

#include "TestFiles.h"
#include "core/Error.h"

namespace velum::io {

/// The file with a few bytes changed, cut out, doubled or cut off.
inline std::string damaged(std::string bytes, std::mt19937& random) {
  for (int change = 1 + int(random() % 3); change > 0 && !bytes.empty(); --change) {
    std::size_t at = random() % bytes.size();
    switch (random() % 6) {
      case 0:
        bytes[at] = char(bytes[at] ^ (1 << random() % 8));
        break;
      case 1:
        bytes[at] = char(random());
        break;
      case 2:
        for (std::size_t i = 0; i < 4 && at + i < bytes.size(); ++i) bytes[at + i] = char(i == 3 ? 0x7f : 0xff);
        break;
      case 3:
        bytes.erase(at, 1 + random() % 20);
        break;
      case 4:
        bytes.insert(at, bytes.substr(random() % bytes.size(), 1 + random() % 20));
        break;
      default:
        bytes.resize(at);
    }
  }
  return bytes;
}

/// Damaged files are read or refused with an InputError, never anything else.
/// @param read  reads the file at @p path
inline void expectReadOrRefused(const std::string& good, const std::filesystem::path& path, int times,
                                const std::function<void()>& read) {
  std::mt19937 random(7);
  for (int i = 0; i < times; ++i) {
    writeText(path, damaged(good, random));
    try {
      read();
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  }
}

/// What a refusal says of a file or folder; empty where it is read.
inline std::string refusalOf(const std::filesystem::path& path) {
  try {
    Volume v = read(path);
    return {};
  } catch (const InputError& error) {
    std::string message = error.what();
    EXPECT_EQ(message.find('\n'), message.npos) << message;
    return message;
  }
}

}  // namespace velum::io
