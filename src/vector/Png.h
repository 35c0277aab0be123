#pragma once
#include <string>

#include "core/Image.h"
#include "vector/PlateBytes.h"

namespace velum::vector {

/// The colours of an image, or its alpha as grey, as a PNG of 8 bits. @throw Error without memory
std::string pngOf(const Image& image, Alpha alpha);
/// The rows of a PNG, filtered and packed, as a PDF takes them, too.
std::string packedRowsOf(const std::string& png);

/// Bytes as text (RFC 4648).
std::string base64Of(const std::string& bytes);

}  // namespace velum::vector
