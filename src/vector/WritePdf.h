#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "vector/Drawing.h"

namespace velum::vector {

/// A drawing as PDF 1.5 of one page: layers are those that readers switch on and off (optional content), by their
/// names and in their order; lines are lines; text is text that can be searched, in fonts of which the file holds the
/// letters that it uses; a plate has its own pixels, as bytes and without loss, and its own alpha. A halo is lines. A
/// letter that a font lacks is a box. What cannot be drawn (isDrawable) is left out. The same drawing has the same
/// bytes. A description, if there is any, is attached as scene.json: see readDescription(). Any thread; takes a second
/// for a plate of 8 megapixels, 0.1 s for 40 labels with halos, 0.2 s for 100 contours of 200 curves.
/// @throw Error without memory
std::string pdfOf(const Drawing& drawing, std::string_view description = {});

/// @throw InputError when the file cannot be written
void writePdf(const Drawing& drawing, const std::filesystem::path& path, std::string_view description = {});

}  // namespace velum::vector
