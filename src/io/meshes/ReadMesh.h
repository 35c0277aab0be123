#pragma once
#include <filesystem>
#include <span>
#include <string_view>

#include "core/Mesh.h"
#include "core/Task.h"

namespace velum::io {

/// Endings of the files that readMesh() reads, lower case: ".stl", ...
std::span<const std::string_view> meshExtensions();

/// Reads a surface of any of meshExtensions(). Any thread. @throw InputError; Cancelled
Mesh readMesh(const std::filesystem::path& path, Progress& progress);

}  // namespace velum::io
