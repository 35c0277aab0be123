#pragma once
#include <string>

#include "core/Image.h"

namespace velum::vector {

/// The colours of an image as a PNG of 8 bits, transparent where it has a channel A. @throw Error without memory
std::string pngOf(const Image& image);

/// Bytes as text (RFC 4648).
std::string base64Of(const std::string& bytes);

}  // namespace velum::vector
