#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace velum::io {

using Path = std::filesystem::path;

/// "path: reason", as every reader and writer says no. @throw InputError always
[[noreturn]] void refuse(const Path& path, std::string_view reason);

/// Text of a file, made fit for a one-line message: short and without control characters.
std::string inQuotes(std::string_view text);

}  // namespace velum::io
