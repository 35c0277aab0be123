#include "session/section/TypedWindow.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/Text.h"
#include "scene/GreyWindows.h"
#include "scene/Scene.h"

namespace velum::session {

namespace {

constexpr std::string_view kWidths[] = {"w", "ww", "width"}, kLevels[] = {"l", "wl", "c", "wc", "level"};

bool isOneOf(std::string_view word, std::span<const std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// In small letters, with points in numbers, and blanks where two numbers are parted.
std::string tidied(std::string_view text) {
  std::string out(trimmed(text));
  for (char& c : out) c = char(std::tolower(static_cast<unsigned char>(c)));
  // The sign that is typed for a minus.
  for (std::size_t at; (at = out.find("\xe2\x88\x92")) != std::string::npos;) out.replace(at, 3, "-");
  std::replace_if(
      out.begin(), out.end(), [](char c) { return c == '/' || c == ';' || c == ':' || c == '=' || c == '\t'; }, ' ');
  // One comma between two numbers parts them; beside other blanks it is a decimal comma.
  bool isPair = std::count(out.begin(), out.end(), ',') == 1 && out.find(' ') == std::string::npos;
  for (std::size_t i = 0; i < out.size(); ++i)
    if (out[i] == ',') out[i] = isPair || i + 1 == out.size() || !isDigit(out[i + 1]) ? ' ' : '.';
  return out;
}

/// The window with this name or title, or the only window whose name or title begins with the text.
const scene::GreyWindow* named(const std::string& text, std::span<const scene::GreyWindow> windows) {
  const scene::GreyWindow* found = nullptr;
  for (const scene::GreyWindow& window : windows) {
    std::string title = tidied(window.title);
    if (text == window.name || text == title) return &window;
    if (!window.name.starts_with(text) && !title.starts_with(text)) continue;
    if (found) return nullptr;
    found = &window;
  }
  return found;
}

}  // namespace

std::optional<glm::dvec2> typedWindow(std::string_view text, const scene::VolumeLayer& layer) {
  std::string tidy = tidied(text);
  if (tidy.empty()) return std::nullopt;
  if (layer.data)
    if (const auto* window = named(tidy, scene::greyWindowsFor(*layer.data)))
      return glm::dvec2(window->level, window->width);
  std::string unit = layer.data ? tidied(scene::valueUnit(*layer.data)) : std::string();
  std::optional<double> width, level;
  std::optional<double>* next = nullptr;  // what a letter has named
  for (std::string_view rest = tidy; !(rest = trimmed(rest)).empty();) {
    if (!unit.empty() && rest.starts_with(unit)) {
      rest.remove_prefix(unit.size());
      continue;
    }
    if (isLetter(rest.front())) {
      auto end = std::find_if_not(rest.begin(), rest.end(), isLetter);
      std::string_view word = rest.substr(0, std::size_t(end - rest.begin()));
      next = isOneOf(word, kWidths) ? &width : isOneOf(word, kLevels) ? &level : nullptr;
      if (!next) return std::nullopt;
      rest.remove_prefix(word.size());
      continue;
    }
    auto number = takeNumber(rest);
    if (!next) next = !width ? &width : &level;
    if (!number || !std::isfinite(*number) || *next) return std::nullopt;
    *next = number;
    next = nullptr;
  }
  if (next || (!width && !level) || (width && !(*width > 0))) return std::nullopt;
  glm::dvec2 now = scene::effectiveWindow(layer);
  return glm::dvec2(level.value_or(now.x), width.value_or(now.y));
}

std::string typedWindowForms(const scene::VolumeLayer& layer) {
  std::string forms = "width and level, as 400 50";
  if (!layer.data) return forms;
  auto windows = scene::greyWindowsFor(*layer.data);
  for (const scene::GreyWindow& window : windows)
    forms += (&window == windows.data() ? ", or " : ", ") + std::string(window.name);
  return forms;
}

std::string windowText(const scene::VolumeLayer& layer) {
  if (!layer.data || layer.data->isColor) return {};
  glm::dvec2 window = scene::effectiveWindow(layer);
  // Three digits of the width, and as many behind the point of the level.
  int decimals = int(std::clamp(2.0 - std::floor(std::log10(window.y)), 0.0, 12.0));
  auto number = [decimals](double value) {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    while (decimals > 0 && text.find('.') != std::string::npos && (text.ends_with('0') || text.ends_with('.')))
      text.pop_back();
    return text;
  };
  std::string unit = scene::valueUnit(*layer.data);
  return fmt::format("W {}  L {}{}{}", number(window.y), number(window.x), unit.empty() ? "" : " ", unit);
}

}  // namespace velum::session
