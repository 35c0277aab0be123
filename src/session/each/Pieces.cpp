#include "session/each/Pieces.h"

#include <fmt/format.h>
#include <glob.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "core/Error.h"
#include "session/each/OutputLocks.h"

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

/// Where files lie. A thousand tasks ask for each of a thousand pieces: the disk is asked only where the names say yes,
/// and for the real way to a folder once.
class Whereabouts {
 public:
  fs::path whole(const fs::path& path) const { return (mHere / path).lexically_normal(); }
  /// A file lies in a folder, or is the folder.
  bool isWithin(const fs::path& file, const fs::path& folder) const {
    std::string way = whole(file).lexically_relative(whole(folder)).string();
    return !way.empty() && !way.starts_with("..") && fs::is_directory(folder);
  }
  /// A file lies in one of these folders, or is one. @param folders  whole
  bool isWithin(const fs::path& file, const std::set<fs::path>& folders) const {
    for (fs::path place = whole(file); place.has_relative_path(); place = place.parent_path())
      if (folders.contains(place) && fs::is_directory(place)) return true;
    return false;
  }
  /// A file by the real folder in which it lies, whichever way leads there.
  fs::path real(const fs::path& file) {
    auto [folder, isNew] = mReal.try_emplace(whole(file).parent_path());
    std::error_code error;
    if (isNew) folder->second = fs::weakly_canonical(folder->first, error);
    return (error || folder->second.empty() ? folder->first : folder->second) / file.filename();
  }

 private:
  fs::path mHere = fs::current_path();
  std::map<fs::path, fs::path> mReal;
};

std::string filled(std::string text, const Piece& piece, const Whereabouts& places) {
  std::string folder = places.whole(piece.data).parent_path().filename().string();
  for (const auto& [key, value] : {std::pair<std::string, std::string>("{name}", piece.name), {"{dir}", folder}})
    for (std::size_t at = 0; (at = text.find(key, at)) != text.npos; at += value.size())
      text.replace(at, key.size(), value);
  return text;
}

/// The record of an output: beside it, or in a folder for all.
fs::path recordOf(const fs::path& realOutput, const std::string& records) {
  if (records.empty()) return realOutput.parent_path() / kDefaultRecords / (realOutput.filename().string() + ".jsonl");
  return fs::path(records) / (nameOfWholePath(realOutput) + ".jsonl");
}

/// Outputs and labels of all pieces. @return the folders of their records, as they are spelled
std::set<fs::path> nameFiles(std::map<std::string, Piece>& byPath, const PiecePatterns& patterns, Whereabouts& places) {
  std::set<fs::path> records;
  for (auto& [path, piece] : byPath) {
    if (!patterns.labels.empty()) piece.labels = filled(patterns.labels, piece, places);
    for (const std::string& output : patterns.outputs)
      piece.outputs.push_back(fs::path(filled(output, piece, places)).lexically_normal());
    fs::path beside = piece.outputs.front().parent_path() / kDefaultRecords;
    records.insert(places.whole(patterns.records.empty() ? beside : fs::path(patterns.records)));
    piece.record = recordOf(places.real(piece.outputs.front()), patterns.records);
  }
  return records;
}

/// @throw ArgumentError where two pieces would write one file, or one its data's folder
void expectOwnOutputs(const std::vector<Piece>& pieces, Whereabouts& places) {
  std::map<fs::path, std::string> makers;
  for (const Piece& piece : pieces)
    for (const fs::path& file : piece.outputs) {
      if (places.isWithin(file, fs::path(piece.data)))
        throw ArgumentError(
            fmt::format("{} lies in the data's folder {}; have it elsewhere, as it would be data the next time",
                        file.string(), piece.data));
      auto [maker, isNew] = makers.try_emplace(places.real(file), piece.data);
      if (!isNew)
        throw ArgumentError(
            fmt::format("{} and {} would both become {}; let the pattern's * stand for what differs, as in "
                        "'studies/*/ct.nrrd', and "
                        "have {{name}} or {{dir}} in the output's name",
                        maker->second, piece.data, file.string()));
    }
}

}  // namespace

std::vector<Piece> findPieces(const PiecePatterns& patterns) {
  Whereabouts places;
  std::map<std::string, Piece> byPath;
  for (const std::string& pattern : patterns.data) addPieces(byPath, pattern);
  const std::set<fs::path> records = nameFiles(byPath, patterns, places);
  std::vector<Piece> pieces;
  for (auto& [path, piece] : byPath)
    if (!places.isWithin(path, records)) pieces.push_back(std::move(piece));
  expectOwnOutputs(pieces, places);
  return pieces;
}

}  // namespace velum::session
