#include "io/read/DataFiles.h"

#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <sstream>

#include "io/read/FileNames.h"

namespace velum::io {

namespace {

constexpr int kMostFiles = 100000;

/// A printf pattern with exactly one "%d" or "%03d", taken apart: nothing else of printf is wanted from a stranger.
struct Pattern {
  std::string before, after;
  int width = 0;
};

std::optional<Pattern> parsePattern(const std::string& text) {
  auto percent = text.find('%');
  if (percent == std::string::npos || text.find('%', percent + 1) != std::string::npos) return std::nullopt;
  std::size_t at = percent + 1;
  std::string digits;
  while (at < text.size() && text[at] >= '0' && text[at] <= '9' && digits.size() < 3) digits += text[at++];
  if (at >= text.size() || (text[at] != 'd' && text[at] != 'i' && text[at] != 'u')) return std::nullopt;
  return Pattern{text.substr(0, percent), text.substr(at + 1), std::atoi(digits.c_str())};
}

std::vector<Path> listedFiles(const Path& header, const std::string& lines) {
  std::vector<Path> files;
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    if (line.empty()) continue;
    if (int(files.size()) >= kMostFiles) refuse(header, "names too many data files");
    files.push_back(siblingFile(header, line));
  }
  if (files.empty()) refuse(header, "has an empty list of data files");
  return files;
}

}  // namespace

std::vector<Path> namedDataFiles(const Path& header, const std::string& value, const std::string& listLines) {
  if (value == "LIST" || value.starts_with("LIST ")) return listedFiles(header, listLines);
  std::istringstream stream(value);
  std::string name;
  long first = 0, last = 0, step = 1;
  auto pattern = parsePattern(value.substr(0, value.find(' ')));
  if (!pattern || !(stream >> name >> first >> last)) return {siblingFile(header, value)};
  if (!(stream >> step)) step = 1;
  if (step == 0 || (last - first) / step < 0 || (last - first) / step >= kMostFiles || std::abs(first) > 1000000000 ||
      std::abs(last) > 1000000000)
    refuse(header, fmt::format("its range of data files {} is not possible", inQuotes(value)));
  std::vector<Path> files;
  for (long i = first; step > 0 ? i <= last : i >= last; i += step)
    files.push_back(
        siblingFile(header, fmt::format("{}{:0{}d}{}", pattern->before, i, pattern->width, pattern->after)));
  return files;
}

}  // namespace velum::io
