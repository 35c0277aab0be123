#pragma once
#include "FuzzReader.h"
#include "io/images/ImageFile.h"
#include "scene/Scene.h"
#include "scene/json/Json.h"

namespace velum::io {

/// A picture, and the scene in it.
inline int fuzzPicture(FuzzFile& file, const std::uint8_t* data, std::size_t size) {
  file.hold(data, size);
  try {
    Image image = readImage(file.path());
    require(image.width > 0 && image.height > 0);
    require(image.pixels.size() == std::size_t(image.width) * std::size_t(image.height) * image.channels.size());
  } catch (const Error& error) {
    expectOneLine(error);
  }
  try {
    std::string text = readImageDescription(file.path());
    if (!text.empty()) scene::fromJson(text);
  } catch (const Error& error) {
    expectOneLine(error);
  }
  return 0;
}

}  // namespace velum::io
