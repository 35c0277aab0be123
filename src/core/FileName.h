#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace velum {

/// The text with A to Z in lower case and every other character unchanged, whatever the locale.
std::string lowerCase(std::string_view text);

/// The file's extension from the last dot of its name, in lower case. ".gz" comes together with the extension before it
/// (".nii.gz"). Empty when the name has no dot.
std::string lowerExtension(const std::filesystem::path& file);

}  // namespace velum
