#pragma once
#include <QImage>
#include <filesystem>

namespace velum::gui {

/// Writes a picture in the format that the name ends with, PNG where it says none; the old file or the new one is left.
/// @throw InputError when the name asks for a format that Qt does not write, or the disk refuses
void saveImage(const QImage& image, const std::filesystem::path& path);

}  // namespace velum::gui
