#pragma once
#include <QImage>
#include <filesystem>

namespace velum::gui {

/// Where file managers look for the picture of a file: freedesktop.org's Thumbnail Managing Standard.
/// @param file  absolute  @param size  128 or 256: of its longer side
std::filesystem::path thumbnailOf(const std::filesystem::path& file, int size);

/// Keeps a picture of a scene file for file managers. Those that ask a thumbnailer give it the scene alone, without the
/// data that it names. Other kinds of files have none. A cache that cannot be written is no error.
/// @param image  of the view, of any size; null: none is kept
void keepThumbnail(const std::filesystem::path& file, const QImage& image);

}  // namespace velum::gui
