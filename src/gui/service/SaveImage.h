#pragma once
#include <QImage>
#include <filesystem>

namespace velum::gui {

/// Writes a picture in the format of the name's ending, PNG where the name has no ending. Whatever goes wrong, either
/// the old file or the complete new one is left.
/// @throw InputError when the name asks for a format that Qt does not write, or the disk refuses
void saveImage(const QImage& image, const std::filesystem::path& path);

}  // namespace velum::gui
