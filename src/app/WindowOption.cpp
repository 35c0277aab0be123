#include "app/WindowOption.h"

#include <fmt/format.h>

#include <cctype>

#include "core/Error.h"
#include "scene/GreyWindows.h"
#include "scene/Scene.h"
#include "session/section/TypedWindow.h"

namespace velum::app {

std::string windowNames() {
  std::string names;
  for (const scene::GreyWindow& window : scene::greyWindows())
    names += (names.empty() ? "" : ", ") + fmt::format("{} ({})", window.name, window.unit);
  return names;
}

void setGreyWindow(scene::VolumeLayer& layer, const std::string& text) {
  if (!layer.data) throw ArgumentError("--window: there is no volume whose values it could show");
  if (auto window = session::typedWindow(text, layer)) return scene::setWindow(layer, window->x, window->y);
  bool isName = !text.empty() && std::isalpha(static_cast<unsigned char>(text[0]));
  if (isName) scene::applyGreyWindow(layer, text);  // says why not
  throw ArgumentError(fmt::format("--window {}: give {}", text, session::typedWindowForms(layer)));
}

}  // namespace velum::app
