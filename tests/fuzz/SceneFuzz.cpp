#include <cstdlib>
#include <string_view>

#include "core/Error.h"
#include "scene/Scene.h"
#include "scene/json/Json.h"
#include "scene/json/Paths.h"

/// A text is a scene or is refused with an Error; what was read can be written and reads back as the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace velum;
  std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    scene::Scene scene = scene::fromJson(text);
    if (!(scene::fromJson(scene::toJson(scene)) == scene)) std::abort();
  } catch (const Error&) {
  }
  // The same bytes as one --set: a path up to the first '=', then a value.
  try {
    scene::Scene scene;
    std::size_t equals = text.find('=');
    if (equals != std::string_view::npos) scene::setField(scene, text.substr(0, equals), text.substr(equals + 1));
  } catch (const Error&) {
  }
  return 0;
}
