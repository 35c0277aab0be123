#include "core/Links.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

#include "core/Text.h"

namespace velum {

namespace {

constexpr std::size_t kMostLink = 2000;  // bytes of one link; what is longer is none
constexpr auto kNowhere = std::string_view::npos;

/// What stands at the front of a text in place of other letters.
struct Mark {
  std::size_t length;  ///< bytes of the text
  std::string shown;   ///< what people read instead
};

bool isAddress(std::string_view text) {
  bool isNamed = text.starts_with("www.") || text.starts_with("mailto:") || text.starts_with("doi:");
  return text.find_first_of(" \t\r\n") == kNowhere && (isNamed || text.find("://") != kNowhere);
}

/// Where the bracket that opens at a place is closed.
std::size_t closingOf(std::string_view text, std::size_t at, char open, char close) {
  int depth = 0;
  for (; at < text.size(); ++at) {
    depth += int(text[at] == open) - int(text[at] == close);
    if (depth == 0) return at;
  }
  return kNowhere;
}

/// "[text](url)", "[text](url "title")", or the same of a picture, with an exclamation mark before it.
std::optional<Mark> markdownAt(std::string_view text) {
  text = text.substr(0, kMostLink);
  std::size_t open = text.starts_with("![") ? 1 : 0;
  if (text.substr(open).substr(0, 1) != "[") return std::nullopt;
  std::size_t close = closingOf(text, open, '[', ']');
  if (close == kNowhere || text.substr(close + 1).substr(0, 1) != "(") return std::nullopt;
  std::size_t end = closingOf(text, close + 1, '(', ')');
  if (end == kNowhere) return std::nullopt;
  std::string_view address = trimmed(text.substr(close + 2, end - close - 2));
  address = address.substr(0, address.find_first_of(" \t\r\n"));
  if (!isAddress(address)) return std::nullopt;
  std::string_view words = trimmed(text.substr(open + 1, close - open - 1));
  return Mark{end + 1, words.empty() ? std::string(address) : withoutLinks(words)};
}

/// "<a href=...>", "</a>", "<br/>" and the like, or an address in such brackets; other things behind a "<" are no tags.
std::optional<Mark> tagAt(std::string_view text) {
  static constexpr std::string_view kTags[] = {"a", "b", "br",   "code",   "div", "em",  "font", "i", "li",
                                               "p", "s", "span", "strong", "sub", "sup", "u",    "ul"};
  static constexpr std::string_view kApart[] = {"br", "div", "li", "p", "ul"};  // they part words
  std::size_t end = text.substr(0, kMostLink).find('>');
  if (!text.starts_with('<') || end == kNowhere) return std::nullopt;
  std::string_view inside = text.substr(1, end - 1);
  if (isAddress(inside)) return Mark{end + 1, std::string(inside)};
  if (inside.starts_with('/')) inside.remove_prefix(1);
  std::string name(inside.substr(0, inside.find_first_of(" \t\r\n/")));
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  if (std::find(std::begin(kTags), std::end(kTags), name) == std::end(kTags)) return std::nullopt;
  bool isApart = std::find(std::begin(kApart), std::end(kApart), name) != std::end(kApart);
  return Mark{end + 1, isApart ? " " : ""};
}

std::optional<Mark> entityAt(std::string_view text) {
  static constexpr std::pair<std::string_view, std::string_view> kEntities[] = {
      {"&amp;", "&"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&apos;", "'"}, {"&nbsp;", " "}};
  for (const auto& [entity, letter] : kEntities)
    if (text.starts_with(entity)) return Mark{entity.size(), std::string(letter)};
  return std::nullopt;
}

}  // namespace

std::string withoutLinks(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    std::size_t plain = std::min(text.find_first_of("[!<&"), text.size());
    out += text.substr(0, plain);
    text.remove_prefix(plain);
    if (text.empty()) break;
    std::optional<Mark> mark = text[0] == '<' ? tagAt(text) : text[0] == '&' ? entityAt(text) : markdownAt(text);
    if (!mark) mark = Mark{1, std::string(text.substr(0, 1))};
    out += mark->shown;
    text.remove_prefix(mark->length);
  }
  return out;
}

}  // namespace velum
