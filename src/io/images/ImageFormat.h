#pragma once
#include <filesystem>
#include <string>

namespace velum::io {

/// OpenImageIO's name of the format that a path asks for: "png", "tiff", "openexr". @throw InputError for any other
std::string imageFormatOf(const std::filesystem::path& path);

}  // namespace velum::io
