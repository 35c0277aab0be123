#include "io/read/FileNames.h"

#include <fmt/format.h>

#include <algorithm>

namespace velum::io {

std::string titleOf(const Path& path) {
  Path name = path.filename().empty() ? path.parent_path().filename() : path.filename();
  if (std::filesystem::is_directory(path)) return name.string();
  if (lowerExtension(path).ends_with(".gz")) name = name.stem();
  name = name.stem();
  return lowerCase(name.extension().string()) == ".seg" ? name.stem().string() : name.string();
}

std::optional<Path> fileBeside(const Path& file, std::initializer_list<const char*> endings) {
  Path stem = lowerCase(file.extension().string()) == ".gz" ? file.parent_path() / file.stem() : file;
  for (const char* ending : endings) {
    Path other = stem;
    other.replace_extension();
    other += ending;
    if (std::filesystem::is_regular_file(other)) return other;
  }
  return std::nullopt;
}

bool naturalLess(std::string_view a, std::string_view b) {
  auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (!isDigit(a[i]) || !isDigit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
      continue;
    }
    // Numbers of any length: without leading zeros the longer is the larger.
    while (i < a.size() && a[i] == '0') ++i;
    while (j < b.size() && b[j] == '0') ++j;
    std::size_t ie = i, je = j;
    while (ie < a.size() && isDigit(a[ie])) ++ie;
    while (je < b.size() && isDigit(b[je])) ++je;
    if (ie - i != je - j) return ie - i < je - j;
    int order = a.substr(i, ie - i).compare(b.substr(j, je - j));
    if (order != 0) return order < 0;
    i = ie, j = je;
  }
  if (a.size() - i != b.size() - j) return a.size() - i < b.size() - j;
  return a < b;  // "1" and "01": some order that is always the same
}

std::vector<Path> filesInOrder(const Path& folder) {
  std::vector<Path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.is_regular_file(error) && !entry.path().filename().string().starts_with('.'))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end(),
            [](const auto& a, const auto& b) { return naturalLess(a.filename().string(), b.filename().string()); });
  return files;
}

Path siblingFile(const Path& header, std::string_view name) {
  Path relative = Path(std::string(name)).lexically_normal();
  if (name.empty() || relative.is_absolute() || relative.begin()->string() == "..")
    refuse(header, fmt::format("its data file {} lies outside the header's folder", inQuotes(name)));
  Path file = header.parent_path() / relative;
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    refuse(header, fmt::format("its data file {} is missing", inQuotes(name)));
  return file;
}

}  // namespace velum::io
