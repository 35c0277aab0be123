#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "session/Part.h"

namespace velum::session {

/// The names of a film's files, by what a user calls the film: a folder FOLDER has FOLDER/frame-00000.png ... and
/// FOLDER/film.jsonl; a picture turn.exr stands for turn-0000.exr ... and turn.jsonl beside it.
class FrameNames {
 public:
  /// @param output  a folder where it is one, ends in "/" or has no extension; else a picture
  explicit FrameNames(const std::filesystem::path& output);

  bool isFolder() const { return mIsFolder; }
  const std::filesystem::path& folder() const { return mFolder; }
  std::filesystem::path frame(int frame) const;
  std::filesystem::path manifest(Part part) const;
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
