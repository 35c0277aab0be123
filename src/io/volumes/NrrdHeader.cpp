#include "io/volumes/NrrdHeader.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "core/Text.h"
#include "io/read/FileBytes.h"
#include "io/read/FileNames.h"

namespace velum::io {

namespace {

constexpr std::size_t kLongestHeader = 4 << 20;

/// Key values escape line ends and backslashes.
std::string unescaped(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    bool escape = text[i] == '\\' && i + 1 < text.size() && (text[i + 1] == 'n' || text[i + 1] == '\\');
    result += !escape ? text[i] : text[++i] == 'n' ? '\n' : '\\';
  }
  return result;
}

void takeLine(NrrdHeader& header, const std::string& line) {
  auto colon = line.find(':');
  if (colon == std::string::npos)
    refuse(header.file, fmt::format("its header has a line {} without a colon", inQuotes(line)));
  if (line.compare(colon, 2, ":=") == 0) {
    header.keyValues[line.substr(0, colon)] = unescaped(line.substr(colon + 2));
  } else {
    header.fields[lowerCase(trimmed(line.substr(0, colon)))] = trimmed(line.substr(colon + 1));
  }
}

}  // namespace

std::string NrrdHeader::field(const char* name, const char* otherName) const {
  auto found = fields.find(name);
  if (found == fields.end()) found = fields.find(otherName);
  return found == fields.end() ? std::string() : found->second;
}

NrrdHeader readNrrdHeader(const std::filesystem::path& file) {
  NrrdHeader header;
  header.file = file;
  std::uint64_t size = sizeOfFile(file);
  std::string text(std::min<std::uint64_t>(size, 64 << 10), '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(text.data(), std::streamsize(text.size()));
  if (text.compare(0, 7, "NRRD000") != 0) refuse(file, "is not a NRRD file");

  bool listFollows = false;
  std::size_t at = text.find('\n');
  if (at == std::string::npos) refuse(file, "its header ends in the first line");
  for (++at;;) {
    std::size_t end = text.find('\n', at);
    if (end == std::string::npos && text.size() < size && text.size() < kLongestHeader) {
      std::size_t have = text.size();
      text.resize(std::min<std::uint64_t>({size, kLongestHeader, have * 4}));
      stream.read(text.data() + have, std::streamsize(text.size() - have));
      continue;
    }
    std::string line = text.substr(at, end == std::string::npos ? end : end - at);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    bool isLast = end == std::string::npos;
    at = isLast ? text.size() : end + 1;
    if (line.empty()) break;
    if (listFollows) {
      header.dataFileList += line + "\n";
    } else if (line[0] != '#') {
      takeLine(header, line);
      listFollows = header.field("data file", "datafile").starts_with("LIST");
    }
    // A detached header needs no empty line at its end.
    if (isLast) {
      if (header.field("data file", "datafile").empty()) refuse(file, "its header has no end");
      break;
    }
  }
  header.headerBytes = at;
  return header;
}

}  // namespace velum::io
