#pragma once
#include <string_view>

namespace velum::scene {

/// True for texts that nest deeper than any scene: to be asked before a parser, or whoever walks over what it made,
/// recurses into them.
inline bool nestsTooDeep(std::string_view text) {
  constexpr int kDeepest = 64;
  int depth = 0;
  bool inString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char c = text[i];
    if (inString) {
      if (c == '\\') ++i;
      if (c == '"') inString = false;
    } else if (c == '"') {
      inString = true;
    } else if (c == '[' || c == '{') {
      if (++depth > kDeepest) return true;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return false;
}

}  // namespace velum::scene
