#pragma once
#include <string_view>

namespace velum::scene {

/// True for JSON texts that nest deeper than any scene. To be tested before a parser, or code that walks over its
/// result, recurses into the text.
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
