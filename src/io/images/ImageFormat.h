#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace velum::io {

/// OpenImageIO's name of the format that a path asks for: "png", "tiff", "openexr". @throw InputError for any other
std::string imageFormatOf(const std::filesystem::path& path);

/// What stands before a scene in the description of a TIFF file.
inline constexpr std::string_view kTiffScenePrefix = "velum:scene\n";

/// True for a TIFF file that carries no scene: large volumes are such, and need no library of pictures to be told.
bool isTiffWithoutScene(const std::filesystem::path& path);

}  // namespace velum::io
