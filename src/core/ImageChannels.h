#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/Image.h"

namespace velum {

/// Index of the channel with this name; -1 when the picture has no such channel.
std::ptrdiff_t channelIndex(const Image& image, std::string_view name);

/// A picture of the named channels only, in the order of the names. Names of channels that the picture does not have
/// are left out.
Image channelsOf(const Image& image, const std::vector<std::string>& names);

}  // namespace velum
