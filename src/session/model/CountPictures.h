#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

#include "core/Task.h"
#include "session/model/TargetSolver.h"
#include "session/model/WhatHides.h"

/// Questions about models that only pictures answer, with a driver of their own: for jobs beside a window. Membranes
/// are as their shapes are. Any thread.
namespace velum::session {

/// As solveVisible(). @param size  of the pictures, pixels  @throw Cancelled, gpu::GpuError, InputError
Solved findVisible(const scene::Scene& scene, const std::vector<int>& cuts, std::string_view path, double wanted,
                   glm::ivec2 size, Progress& progress);

/// As solveTargets(), of the numbers that a scene's model wants (scene::ModelLayer::targets), by all cuts that are on,
/// or one everywhere where none is. @throw the same
TargetsReport findTargets(scene::Scene scene, glm::ivec2 size, Progress& progress);

/// Writes the bars of a picture: countsSvg() or countsCsv(), by extension. @throw the same; InputError where there is
/// no model, or the extension is another
void writeBars(const scene::Scene& scene, glm::ivec2 size, const std::filesystem::path& path, Progress& progress);

/// As whatHides(). @throw the same
Hiding findHiding(const scene::Scene& scene, std::string_view path, glm::ivec2 size, Progress& progress);

}  // namespace velum::session
