#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "vector/Drawing.h"

namespace velum::vector {

/// A drawing as SVG 1.1, as Inkscape, Illustrator and browsers edit it: layers of the same names, lines within 0.01
/// pixels, text that stays text in the fonts of the drawing or what a machine has for them, plates as PNG. A halo is a
/// copy of its text (`use`) beneath it, not `paint-order`, so that programs which do not know that keep text legible.
/// Whatever a text holds the file is XML. What cannot be drawn (isDrawable) is left out. The same drawing has the same
/// bytes. A description, if there is any, rides along: see readDescription(). Any thread; takes a second for a plate of
/// 8 megapixels, else next to nothing.
std::string svgOf(const Drawing& drawing, std::string_view description = {});

/// @throw InputError when the file cannot be written
void writeSvg(const Drawing& drawing, const std::filesystem::path& path, std::string_view description = {});

}  // namespace velum::vector
