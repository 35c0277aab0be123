#pragma once
#include <cstdint>
#include <filesystem>

#include "core/Levels.h"
#include "core/Model.h"
#include "core/Task.h"

/// Keeps the levels of detail of models that were opened before: computing them takes seconds, reading them
/// milliseconds.
namespace velum::session {

/// The size that all files of the cache may have together.
constexpr std::uint64_t kMostLevelCacheBytes = 512u << 20;

/// The levels of a model, as model::computeLevels() gives them: read from a file of the folder where one fits, else
/// computed and then written to such a file.
///
/// The file is named by what the levels are made of (atoms, beads, version of the algorithm), so models that differ in
/// instances alone share one file. A file is checked as a whole; a file that is damaged, of another make or unreadable
/// counts as not there. Files that were used longest ago are deleted first. Several processes may use the folder at
/// once; it may be deleted at any time. No failure of the folder is an error.
/// @param folder  made where it is missing; empty: nothing is read or written
/// @param mostBytes  of all its files together
/// @throw Cancelled. Any thread.
LevelSet cachedLevels(const Model& model, const std::filesystem::path& folder, Progress& progress,
                      std::uint64_t mostBytes = kMostLevelCacheBytes);

/// The levels of a model from such a file of the folder where one fits, else quick ones (model::makeQuickLevels()).
/// @param folder  as of cachedLevels()  @throw Cancelled. Any thread.
LevelSet keptOrQuickLevels(const Model& model, const std::filesystem::path& folder, Progress& progress);

/// The path of the file for a model within the folder, whether the file is there or not.
std::filesystem::path levelFile(const Model& model, const std::filesystem::path& folder);

}  // namespace velum::session
