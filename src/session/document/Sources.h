#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/Task.h"
#include "scene/SceneFwd.h"

/// Where a scene's data is: remembered by path and fingerprint, looked for when it has moved.
namespace velum::session {

/// What tells one file from another without reading all of it: its size and a hash of its first and last 64 KiB; of a
/// folder the number of its files and a hash of their names and sizes. Empty when it cannot be read. Any thread.
std::string fingerprintOf(const std::filesystem::path& path);

/// Looks for data that is not where the scene says: by the data's name beside the scene file, in the tree of folders
/// there (up to a limit), and in other folders. Where the scene knows the data's fingerprint, the fingerprint must fit,
/// and a file of another name will do.
/// @throw Cancelled. Any thread.
std::optional<std::filesystem::path> findMoved(const scene::Source& source, const std::filesystem::path& sceneFolder,
                                               const std::vector<std::filesystem::path>& otherFolders,
                                               Progress& progress);

/// How to open a scene whose data may have moved.
struct DataPolicy {
  std::vector<std::filesystem::path> folders;  ///< more folders to look in: those of recent files
  bool refusesOne = false;                     ///< one file that cannot be read, of several, is an error
  bool keepsWithoutData = false;               ///< data that is not found is left out, instead of being an error
  int level = -1;  ///< of a volume with levels of detail whose source names none: 0 the finest; -1: as its size asks
  bool quickLevels = false;  ///< levels of detail that no file keeps are made in haste, for a LevelWorker to replace
  std::function<void(scene::Scene&)> beforeData = {};  ///< applied to a scene file before its data is read
};

/// Data that a scene names and does not hold.
struct MissingData {
  std::string field;  ///< "volume.source.path", "surfaces.2.source.path"
  std::string what;   ///< for people: "volume", "labels", "surface"
  std::string path;
};
std::vector<MissingData> missingData(const scene::Scene& scene);

/// One line for the user: what is missing, and what to do.
std::string sayMissing(const MissingData& missing);

}  // namespace velum::session
