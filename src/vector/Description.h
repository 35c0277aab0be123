#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

/// The text that rides along in a drawing, as the scene from which it was drawn does.
namespace velum::vector {

/// A longer text is neither written nor read, bytes.
inline constexpr std::size_t kLongestDescription = 64u << 20;

/// @throw InputError when the text is too long
void expectDescription(std::string_view text);

/// The element that holds the text in an SVG file.
std::string svgDescription(std::string_view text);
/// The name of the entry by which the stream that holds the text in a PDF file is found: "/VelumScene".
inline constexpr const char* kPdfDescription = "/VelumScene";

/// The text that writeSvg() or writePdf() have put into a file, also after programs that edit such files have written
/// it anew, where they have kept it; empty: there is none. Reads the file up to its end, holds of it no more than such
/// a text takes at most, packed and unpacked, and asks no parser of XML or PDF, so that no file grows on the way. Any
/// thread.
/// @throw InputError when the file cannot be read or the text is damaged
std::string readDescription(const std::filesystem::path& path);

}  // namespace velum::vector
