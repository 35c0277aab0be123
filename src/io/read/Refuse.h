#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace velum::io {

using Path = std::filesystem::path;

/// Throws the error "path: reason", with which every reader and writer refuses a file. @throw InputError always
[[noreturn]] void refuse(const Path& path, std::string_view reason);

/// A text that was read from a file, made fit for a one-line message: short and without control characters.
std::string inQuotes(std::string_view text);

}  // namespace velum::io
