#include "session/film/FrameNames.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/Error.h"
#include "core/Text.h"
#include "session/film/FilmManifest.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

constexpr const char* kEnding = ".jsonl";
constexpr const char* kFolderStem = "film";

/// Names of the files of a folder that may be manifests, in order.
std::vector<std::string> listsIn(const fs::path& folder) {
  std::vector<std::string> found;
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
       entry.increment(error))
    if (entry->path().extension() == kEnding) found.push_back(entry->path().filename().string());
  std::ranges::sort(found);
  return found;
}

/// A manifest's name without its ending, and without the part that it tells of: "turn" of "turn-3-of-16.jsonl".
std::string stemOfList(const std::string& name) {
  std::string stem = name.substr(0, name.size() - std::string_view(kEnding).size());
  std::size_t of = stem.rfind("-of-"), dash = of == stem.npos ? stem.npos : stem.rfind('-', of - 1);
  if (of == stem.npos || of == 0 || dash == stem.npos) return stem;
  bool isPart = numberIn(stem.substr(dash + 1, of - dash - 1)) && numberIn(stem.substr(of + 4));
  return isPart ? stem.substr(0, dash) : stem;
}

}  // namespace

FrameNames::FrameNames(const fs::path& output)
    : mIsFolder(!output.has_filename() || output.extension().empty() || fs::is_directory(output)) {
  mFolder = mIsFolder ? output : output.parent_path();
  mStem = mIsFolder ? "frame" : output.stem().string();
  mExtension = mIsFolder ? ".png" : output.extension().string();
  mManifestStem = mIsFolder ? kFolderStem : mStem;
  mDigits = mIsFolder ? 5 : 4;
}

fs::path FrameNames::frame(int frame) const {
  return mFolder / fmt::format("{}-{:0{}}{}", mStem, frame, mDigits, mExtension);
}

fs::path FrameNames::manifest(Part part) const {
  if (part.parts == 1) return mFolder / (mManifestStem + kEnding);
  return mFolder / fmt::format("{}-{}-of-{}{}", mManifestStem, part.number, part.parts, kEnding);
}

std::vector<fs::path> FrameNames::manifests() const {
  std::vector<fs::path> found;
  for (const std::string& name : listsIn(mFolder))
    if (name == mManifestStem + kEnding || stemOfList(name) == mManifestStem) found.push_back(mFolder / name);
  return found;
}

std::optional<FrameNames> namesInFolder(const fs::path& folder) {
  std::set<std::string> stems;
  for (const std::string& name : listsIn(folder))
    if (readManifest(folder / name)) stems.insert(stemOfList(name));
  if (stems.empty()) return std::nullopt;
  if (stems.size() > 1)
    throw InputError(fmt::format("{}: holds frames of several films ({}); keep each in a folder of its own",
                                 folder.string(), fmt::join(stems, ", ")));
  return *stems.begin() == kFolderStem ? FrameNames(folder) : FrameNames(folder / (*stems.begin() + ".png"));
}

}  // namespace velum::session
