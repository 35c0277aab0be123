#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/Image.h"

namespace velum {

/// Which of the channels has a name; -1: none has.
std::ptrdiff_t channelIndex(const Image& image, std::string_view name);

/// The channels named, in that order; those that the picture has not are left out.
Image channelsOf(const Image& image, const std::vector<std::string>& names);

}  // namespace velum
