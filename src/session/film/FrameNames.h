#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace velum::session {

/// The part of a film that a process draws, so that several machines draw one film: frames one after the other, and no
/// part has two more than another.
struct FilmPart {
  int number = 1, parts = 1;  ///< 1 <= number <= parts
  bool operator==(const FilmPart&) const = default;
  int firstOf(int frames) const { return int((number - 1ll) * frames / parts); }
  int endOf(int frames) const { return int(1ll * number * frames / parts); }
};

/// Reads "3/16". @throw ArgumentError
FilmPart parseFilmPart(std::string_view text);

/// The names of a film's files, by what a user calls the film: a folder FOLDER has FOLDER/frame-00000.png ... and
/// FOLDER/film.jsonl; a picture turn.exr stands for turn-0000.exr ... and turn.jsonl beside it.
class FrameNames {
 public:
  /// @param output  a folder where it is one, ends in "/" or has no extension; else a picture
  explicit FrameNames(const std::filesystem::path& output);

  bool isFolder() const { return mIsFolder; }
  const std::filesystem::path& folder() const { return mFolder; }
  std::filesystem::path frame(int frame) const;
  std::filesystem::path manifest(FilmPart part) const;
  /// The manifests that are there, of all parts, in order of their names.
  std::vector<std::filesystem::path> manifests() const;

 private:
  bool mIsFolder;
  std::filesystem::path mFolder;
  std::string mStem, mExtension, mManifestStem;
  int mDigits;
};

/// The names of the film whose manifests are in a folder. @return nothing where there is no manifest  @throw InputError
/// where there are those of several films
std::optional<FrameNames> namesInFolder(const std::filesystem::path& folder);

}  // namespace velum::session
