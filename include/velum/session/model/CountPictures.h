#pragma once
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

#include "velum/core/Task.h"
#include "velum/session/model/TargetSolver.h"
#include "velum/session/model/WhatHides.h"

/// Questions about models that only pictures answer, with a driver of their own: for jobs beside a window. Membranes
/// are as their shapes are. Any thread.
namespace velum::session {

/// As solveVisible(). @param size  of the pictures, pixels  @throw Cancelled, gpu::GpuError, InputError
Solved findVisible(const scene::Scene& scene, const std::vector<int>& cuts, std::string_view path, double wanted,
                   glm::ivec2 size, Progress& progress);

/// As whatHides(). @throw the same
Hiding findHiding(const scene::Scene& scene, std::string_view path, glm::ivec2 size, Progress& progress);

}  // namespace velum::session
