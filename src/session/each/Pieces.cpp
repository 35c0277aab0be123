#include "session/each/Pieces.h"

#include <fmt/format.h>
#include <glob.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "core/Error.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

constexpr const char* kWildcards = "*?[";
constexpr const char* kDefaultRecords = "pieces";

bool hasWildcards(const std::string& pattern) { return pattern.find_first_of(kWildcards) != pattern.npos; }

/// The paths that a pattern stands for. A path that is there stands for itself, whatever characters it has.
std::vector<std::string> pathsOf(const std::string& pattern) {
  if (!hasWildcards(pattern) || fs::exists(pattern)) {
    if (!fs::exists(pattern)) throw InputError(fmt::format("{}: there is no such file or folder", pattern));
    return {pattern};
  }
  glob_t found{};
  int failed = ::glob(pattern.c_str(), GLOB_NOSORT, nullptr, &found);
  std::vector<std::string> paths(found.gl_pathv, found.gl_pathv + (failed == 0 ? found.gl_pathc : 0));
  ::globfree(&found);
  if (paths.empty()) throw InputError(fmt::format("{}: there are no such files", pattern));
  return paths;
}

/// The pattern as a regular expression in which each wildcard is a group.
std::regex groupsOf(const std::string& pattern) {
  std::string text;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    char c = pattern[i];
    std::size_t end = c == '[' ? pattern.find(']', i + 2) : pattern.npos;
    if (c == '*') {
      text += "([^/]*)";
    } else if (c == '?') {
      text += "([^/])";
    } else if (end != pattern.npos) {
      std::string set = pattern.substr(i + 1, end - i - 1);
      if (set.front() == '!') set.front() = '^';
      text += "([" + set + "])";
      i = end;
    } else {
      if (std::string_view(R"(^$\.+()|{}[])").find(c) != std::string_view::npos) text += '\\';
      text += c;
    }
  }
  return std::regex(text);
}

/// The name of a path that stands for itself: of its file, without endings.
std::string ownName(const std::string& path) {
  fs::path file = fs::path(path).lexically_normal();
  std::string name = (file.has_filename() ? file : file.parent_path()).filename().string();
  return name.substr(0, name.find('.', 1));
}

/// What the wildcards stand for in a path that a pattern has matched.
std::string nameIn(const std::string& path, const std::regex& pattern) {
  std::smatch groups;
  if (!std::regex_match(path, groups, pattern)) return ownName(path);
  std::string name;
  for (std::size_t i = 1; i < groups.size(); ++i)
    if (groups[i].length() > 0) name += (name.empty() ? "" : "-") + groups[i].str();
  return name.empty() ? ownName(path) : name;
}

/// Adds a piece for each path of a pattern that has none yet.
void addPieces(std::map<std::string, Piece>& byPath, const std::string& pattern) {
  std::vector<std::string> paths = pathsOf(pattern);
  bool isItself = paths.size() == 1 && paths[0] == pattern;
  const std::regex groups = isItself ? std::regex() : groupsOf(pattern);
  for (const std::string& path : paths)
    byPath.try_emplace(path, Piece{isItself ? ownName(path) : nameIn(path, groups), path, {}, {}, {}});
}

/// Tells whether files lie in folders. A thousand tasks ask for each of a thousand pieces: the disk is asked only where
/// the names say yes.
class Whereabouts {
 public:
  fs::path whole(const fs::path& path) const { return (mHere / path).lexically_normal(); }
  /// A file lies in a folder, or is the folder.
  bool isWithin(const fs::path& file, const fs::path& folder) const {
    std::string way = whole(file).lexically_relative(whole(folder)).string();
    return !way.empty() && !way.starts_with("..") && fs::is_directory(folder);
  }

 private:
  fs::path mHere = fs::current_path();
};

std::string filled(std::string text, const Piece& piece, const Whereabouts& places) {
  std::string folder = places.whole(piece.data).parent_path().filename().string();
  for (const auto& [key, value] : {std::pair<std::string, std::string>("{name}", piece.name), {"{dir}", folder}})
    for (std::size_t at = 0; (at = text.find(key, at)) != text.npos; at += value.size())
      text.replace(at, key.size(), value);
  return text;
}

bool hasName(const std::string& text) { return text.find("{name}") != text.npos || text.find("{dir}") != text.npos; }

/// The folder of an output's pattern in which all of the outputs lie.
fs::path folderOfAll(const std::string& output) {
  fs::path folder;
  for (const fs::path& part : fs::path(output).parent_path()) {
    if (hasName(part.string())) break;
    folder /= part;
  }
  return folder;
}

}  // namespace

std::vector<Piece> findPieces(const PiecePatterns& patterns) {
  fs::path records =
      patterns.records.empty() ? folderOfAll(patterns.outputs.at(0)) / kDefaultRecords : fs::path(patterns.records);
  const Whereabouts places;
  std::map<std::string, Piece> byPath;
  for (const std::string& pattern : patterns.data) addPieces(byPath, pattern);
  std::erase_if(byPath, [&](const auto& entry) { return places.isWithin(entry.first, records); });
  std::vector<Piece> pieces;
  std::map<fs::path, std::string> makers;
  for (auto& [path, piece] : byPath) {
    if (!patterns.labels.empty()) piece.labels = filled(patterns.labels, piece, places);
    for (const std::string& output : patterns.outputs) {
      fs::path file = fs::path(filled(output, piece, places)).lexically_normal();
      if (places.isWithin(file, path))
        throw ArgumentError(
            fmt::format("{} lies in the data's folder {}; have it elsewhere, as it would be data the next time",
                        file.string(), path));
      auto [maker, isNew] = makers.try_emplace(file, path);
      if (!isNew)
        throw ArgumentError(
            fmt::format("{} and {} would both become {}; let the pattern's * stand for what differs, as in "
                        "'studies/*/ct.nrrd', and "
                        "have {{name}} or {{dir}} in the output's name",
                        maker->second, path, file.string()));
      piece.outputs.push_back(std::move(file));
    }
    // Of the output's whole path, as names may be alike in several folders.
    std::string record = piece.outputs.front().lexically_relative(records.parent_path()).string();
    if (record.empty() || record.starts_with("..")) record = piece.outputs.front().string();
    std::ranges::replace(record, '/', '-');
    piece.record = records / (record + ".jsonl");
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace velum::session
