#pragma once
#include <cstdint>
#include <vector>

#include "core/Image.h"

namespace velum::vector {

enum class Alpha { Without, With, Alone };

/// The colours of an image in bytes, top row first: R, G, B, or R, G, B, A (255 where it has none), or A alone.
std::vector<std::uint8_t> plateBytes(const Image& image, Alpha alpha);

}  // namespace velum::vector
