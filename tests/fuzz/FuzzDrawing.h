#pragma once
#include "FuzzReader.h"
#include "scene/Scene.h"
#include "scene/json/Json.h"
#include "vector/Description.h"

namespace velum::io {

/// The scene in a drawing.
inline int fuzzDrawing(FuzzFile& file, const std::uint8_t* data, std::size_t size) {
  file.hold(data, size);
  try {
    std::string text = vector::readDescription(file.path());
    if (!text.empty()) scene::fromJson(text);
  } catch (const Error& error) {
    expectOneLine(error);
  }
  return 0;
}

}  // namespace velum::io
