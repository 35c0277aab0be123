#include <algorithm>
#include <cctype>

#include "session/command/CommandRow.h"

namespace velum::session::detail {

namespace {

bool isBlank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// Where a word ends: at a blank that is in no quotes and no brackets.
std::size_t endOfWord(std::string_view text) {
  int depth = 0;
  bool inQuotes = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char c = text[i];
    if (inQuotes) {
      if (c == '\\') ++i;
      if (c == '"') inQuotes = false;
    } else if (c == '"') {
      inQuotes = true;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    } else if (isBlank(c) && depth <= 0) {
      return i;
    }
  }
  if (inQuotes || depth > 0)
    throw ArgumentError(fmt::format("{}: a {} is not closed", text.substr(0, 60), inQuotes ? "quote" : "bracket"));
  return text.size();
}

/// How long the name of "NAME=" or "NAME.FIELD=" is; 0 where none of the arguments is named.
std::size_t nameLength(std::string_view text, const std::vector<std::string>& names) {
  std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) return 0;
  std::string_view name = text.substr(0, std::min(equals, text.find_first_of(".[")));
  return std::find(names.begin(), names.end(), name) != names.end() ? equals : 0;
}

/// Refuses what looks like an argument with its name where none is called so: it would be taken for another one's text.
void expectNoName(std::string_view text, const std::vector<std::string>& names) {
  std::string_view name = text.substr(0, text.find('='));
  bool isName = name.size() < text.size() && !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) &&
                std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c); });
  if (isName)
    throw ArgumentError(fmt::format("'{}' is no argument here; these are {}; a text with = stands in quotes", name,
                                    fmt::join(names, ", ")));
}

/// Each byte as the letter that it is in Latin-1, and back: so that what is no UTF-8, as a path may be, can be read.
std::string asLatin1(std::string_view bytes) {
  std::string letters;
  for (char c : bytes) {
    auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80) letters += char(0xc0 | (byte >> 6));
    letters += byte >= 0x80 ? char(0x80 | (byte & 0x3f)) : c;
  }
  return letters;
}
std::string fromLatin1(std::string_view letters) {
  std::string bytes;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    auto first = static_cast<unsigned char>(letters[i]);
    bool isLatin1 = (first == 0xc2 || first == 0xc3) && i + 1 < letters.size();
    bytes += isLatin1 ? char((first << 6) | (letters[++i] & 0x3f)) : letters[i];
  }
  return bytes;
}

/// What is in quotes without them.
std::string unquoted(std::string_view text) {
  if (!text.starts_with('"')) return std::string(text);
  auto json = scene::detail::Json::parse(text, nullptr, false);
  if (json.is_string()) return json.get<std::string>();
  json = scene::detail::Json::parse(asLatin1(text), nullptr, false);
  return json.is_string() ? fromLatin1(json.get<std::string>()) : std::string(text);
}

}  // namespace

std::vector<Word> wordsOfLine(std::string_view text, const std::vector<std::string>& names, std::size_t rest) {
  std::vector<Word> words;
  std::size_t atPlace = 0;
  for (;;) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    if (text.empty()) return words;
    std::size_t length = nameLength(text, names);
    Word word;
    if (length > 0) {
      word.name = text.substr(0, length);
      text.remove_prefix(length + 1);
    } else if (rest > 0 && ++atPlace == rest) {
      word.value = text;
      words.push_back(std::move(word));
      return words;
    }
    std::size_t end = endOfWord(text);
    if (length == 0) expectNoName(text.substr(0, end), names);
    word.value = unquoted(text.substr(0, end));
    text.remove_prefix(end);
    words.push_back(std::move(word));
  }
}

std::string quoted(const std::string& value) {
  bool isOne = !value.empty() && value.front() != '"' && value.find('=') == std::string::npos;
  if (isOne) {
    try {
      isOne = endOfWord(value) == value.size();
    } catch (const ArgumentError&) {
      isOne = false;
    }
  }
  return isOne ? value : scene::detail::Json(value).dump(-1, ' ', false, scene::detail::Json::error_handler_t::replace);
}

std::string asTexts(std::string_view value) {
  if (value.starts_with('[')) return std::string(value);
  scene::detail::Json list = scene::detail::Json::array();
  for (std::size_t begin = 0; begin <= value.size() && !value.empty();) {
    std::size_t end = std::min(value.find(',', begin), value.size());
    list.push_back(std::string(trimmed(value.substr(begin, end - begin))));
    begin = end + 1;
  }
  return list.dump(-1, ' ', false, scene::detail::Json::error_handler_t::replace);
}

}  // namespace velum::session::detail
