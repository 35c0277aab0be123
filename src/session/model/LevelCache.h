#pragma once
#include <cstdint>
#include <filesystem>

#include "core/Levels.h"
#include "core/Model.h"
#include "core/Task.h"

/// Levels of detail of models that were opened before: to compute them takes seconds, to read them milliseconds.
namespace velum::session {

/// What all files of it may take together.
constexpr std::uint64_t kMostLevelCacheBytes = 512u << 20;

/// The levels of a model, as model::computeLevels() gives them: from a file of the folder where there is one that
/// fits, else computed, and then written there.
///
/// The file is named by what the levels are made of (atoms, beads, version of the algorithm), so models that differ
/// in instances alone share one. It is checked as a whole; what is damaged, of another make or not to be read counts
/// as not there. What was used longest ago goes first. Several processes may use the folder at once; it may be deleted
/// at any time. No failure of it is an error.
/// @param folder  made where it is missing; empty: nothing is read or written
/// @param mostBytes  of all its files together
/// @throw Cancelled. Any thread.
LevelSet cachedLevels(const Model& model, const std::filesystem::path& folder, Progress& progress,
                      std::uint64_t mostBytes = kMostLevelCacheBytes);

/// The file of a model within the folder, there or not.
std::filesystem::path levelFile(const Model& model, const std::filesystem::path& folder);

}  // namespace velum::session
