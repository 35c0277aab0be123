#include "core/FileName.h"

#include <algorithm>

namespace velum {

std::string lowerCase(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return result;
}

std::string lowerExtension(const std::filesystem::path& file) {
  std::string extension = lowerCase(file.extension().string());
  return extension == ".gz" ? lowerCase(file.stem().extension().string()) + ".gz" : extension;
}

}  // namespace velum
