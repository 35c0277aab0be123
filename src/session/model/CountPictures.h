#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

#include "core/Task.h"
#include "session/model/TargetSolver.h"
#include "session/model/WhatHides.h"

/// Questions about models that only drawn pictures answer. Each function makes a GL context of its own, so that it can
/// run in a job beside a window. The sheets of membranes are taken in the shapes that the scene holds. Any thread.
namespace velum::session {

/// As solveVisible(). @param size  of the pictures that are drawn, pixels  @throw Cancelled, gpu::GpuError, InputError
Solved findVisible(const scene::Scene& scene, const std::vector<int>& cuts, std::string_view path, double wanted,
                   glm::ivec2 size, Progress& progress);

/// As solveTargets(), for the numbers that a scene's model asks for (scene::ModelLayer::targets), by all cuts that are
/// on, or by a new cut everywhere. @throw as findVisible()
TargetsReport findTargets(const scene::Scene& scene, glm::ivec2 size, Progress& progress);

/// How many instances of a type or compartment are seen, and how many can be.
struct SeenRange {
  std::uint64_t now = 0;   ///< with the cuts as they are
  std::uint64_t most = 0;  ///< where cuts leave all of them, and all else as it is
  std::uint64_t total = 0;
};
/// Counts both in pictures. @throw as findVisible()
SeenRange findSeenRange(scene::Scene scene, std::string_view path, glm::ivec2 size, Progress& progress);

/// Writes the bars of a picture to a file: countsSvg() or countsCsv(), by extension. @throw as findVisible();
/// InputError where there is no model, or the extension is another
void writeBars(const scene::Scene& scene, glm::ivec2 size, const std::filesystem::path& path, Progress& progress);

/// As whatHides(). @throw as findVisible()
Hiding findHiding(const scene::Scene& scene, std::string_view path, glm::ivec2 size, Progress& progress);

}  // namespace velum::session
