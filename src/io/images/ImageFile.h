#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/Image.h"

namespace velum::io {

/// A line of metadata.
struct ImageAttribute {
  std::string name, value;
};

/// Checks, before the picture is made, that its path has an extension that can be written. @throw InputError when the
/// extension is unknown
void expectImageFormat(const std::filesystem::path& path);

/// Writes a picture: .png (sRGB as given; channels R, G, B[, A] only, or one as grey), .tif (as PNG; all channels in
/// float as soon as there are others than colour), .exr (all channels, float). `description` (a scene as JSON) rides
/// along: PNG tEXt "velum:scene", EXR attribute "velum:scene", TIFF ImageDescription behind the line "velum:scene". The
/// same picture and description give the same bytes. Written to a temporary, then renamed. A path of "-" writes PNG to
/// stdout.
/// @param image  channels R, G, B, A are display-referred sRGB in 0..1 with straight (not premultiplied) alpha; EXR
///               stores them linear and premultiplied
/// @param dpi  pixels per inch for printing, noted in the file for programs that lay out pages; 0: not noted
/// @param attributes  more metadata, written in .exr only
/// @param bits  bits of a sample, 8 or 16, in .png, and in .tif where there is only colour
/// @throw InputError when the extension is unknown or the disk refuses
void writeImage(const Image& image, const std::filesystem::path& path, const std::string& description = {},
                double dpi = 0.0, const std::vector<ImageAttribute>& attributes = {}, int bits = 8);

/// Reads a picture back, the counterpart of writeImage (8-bit formats give 0..1). @throw InputError
Image readImage(const std::filesystem::path& path);

/// The scene text inside a picture of ours; empty when there is none. @throw InputError when it is no picture
std::string readImageDescription(const std::filesystem::path& path);

}  // namespace velum::io
