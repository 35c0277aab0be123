#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace velum {

/// A to Z in lower case; everything else as it is, whatever the locale.
std::string lowerCase(std::string_view text);

/// The name from its last dot, ".gz" joined with what stands before it (".nii.gz"); lower case. Empty when there is
/// none.
std::string lowerExtension(const std::filesystem::path& file);

}  // namespace velum
