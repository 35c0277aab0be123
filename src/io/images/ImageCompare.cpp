#include "io/images/ImageCompare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/Error.h"
#include "core/ImageChannels.h"

namespace velum::io {

namespace {

/// Channel of `b` for each channel of `a`: by name where b has the same names, else by place (grey against R).
std::vector<std::size_t> matchChannels(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height)
    throw InputError(
        fmt::format("the pictures differ in size: {} x {} and {} x {}", a.width, a.height, b.width, b.height));
  if (a.channels.size() != b.channels.size())
    throw InputError(fmt::format("the pictures have {} and {} channels", a.channels.size(), b.channels.size()));
  std::vector<std::size_t> match;
  for (const auto& name : a.channels) {
    std::ptrdiff_t found = channelIndex(b, name);
    if (found >= 0) match.push_back(std::size_t(found));
  }
  if (match.size() != a.channels.size())
    for (match.clear(); match.size() < a.channels.size();) match.push_back(match.size());
  return match;
}

/// 0..255 for display-referred values. Two NaN agree, and so do two equal infinities; one NaN is as far as can be.
double distance(float a, float b) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
  double d = std::abs(double(a) - double(b)) * 255.0;
  return std::isfinite(d) ? d : 255.0;
}

}  // namespace

ImageDifference compareImages(const Image& a, const Image& b, double threshold) {
  auto match = matchChannels(a, b);
  std::size_t channels = a.channels.size(), pixels = std::size_t(a.width) * std::size_t(a.height), failing = 0;
  ImageDifference result;
  double squares = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    double worst = 0;
    for (std::size_t c = 0; c < channels; ++c) {
      double d = distance(a.pixels[i * channels + c], b.pixels[i * channels + match[c]]);
      squares += d * d;
      worst = std::max(worst, d);
    }
    result.maxDifference = std::max(result.maxDifference, worst);
    // 8-bit steps come back from floats a hair off, so that "5 over" must not fail at a threshold of 5.
    if (worst > threshold + 1e-4) ++failing;
  }
  if (pixels > 0 && channels > 0) {
    result.rms = std::sqrt(squares / double(pixels * channels));
    result.failingFraction = double(failing) / double(pixels);
  }
  return result;
}

Image differenceImage(const Image& a, const Image& b, double threshold) {
  auto match = matchChannels(a, b);
  std::size_t channels = a.channels.size(), pixels = std::size_t(a.width) * std::size_t(a.height);
  auto alpha = std::size_t(std::find(a.channels.begin(), a.channels.end(), "A") - a.channels.begin());
  double factor = 0.5 / std::max(threshold, 1e-3);
  Image out{a.width, a.height, a.channels, std::vector<float>(a.pixels.size())};
  for (std::size_t i = 0; i < pixels; ++i) {
    auto at = [&](std::size_t c) {
      return distance(a.pixels[i * channels + c], b.pixels[i * channels + match[c]]) * factor;
    };
    // The difference must be seen, so it is opaque, and a difference in alpha shows in every colour.
    double inAlpha = alpha < channels ? at(alpha) : 0.0;
    for (std::size_t c = 0; c < channels; ++c)
      out.pixels[i * channels + c] = c == alpha ? 1.0f : float(std::min(1.0, std::max(at(c), inAlpha)));
  }
  return out;
}

}  // namespace velum::io
