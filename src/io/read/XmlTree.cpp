#include "io/read/XmlTree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace velum::io {

namespace {

constexpr std::size_t kWindow = 1 << 18, kLongestTag = 1 << 16, kMostElements = 100'000, kDeepest = 32;
constexpr std::string_view kBlanks = " \t\r\n";

std::string withoutEntities(std::string_view text) {
  constexpr std::pair<std::string_view, char> kEntities[] = {
      {"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}};
  std::string out;
  while (!text.empty()) {
    auto entity =
        std::find_if(std::begin(kEntities), std::end(kEntities), [&](auto& e) { return text.starts_with(e.first); });
    bool isEntity = entity != std::end(kEntities);
    out += isEntity ? entity->second : text[0];
    text.remove_prefix(isEntity ? entity->first.size() : 1);
  }
  return out;
}

class XmlReader {
 public:
  XmlReader(const FileBytes& file, std::string_view last) : mFile(file), mLast(last) {}

  XmlElement read() {
    XmlElement root;
    std::vector<XmlElement*> open;
    bool hasRoot = false;
    while (!hasRoot || !open.empty()) {
      std::uint64_t at = find('<', mAt);
      if (!open.empty() && open.back()->textEnd == 0) open.back()->textEnd = at;
      mAt = at;
      if (passOver("<!--", "-->") || passOver("<?", "?>")) continue;
      std::string tag = takeTag();
      if (tag.starts_with('!')) refuseDamage("it has a document type or other things that no VTK file needs");
      if (tag.starts_with('/')) {
        if (open.empty() || tag.substr(1, tag.find_last_not_of(kBlanks)) != open.back()->name)
          refuseDamage(fmt::format("a tag <{}> closes nothing", inQuotes(tag)));
        open.pop_back();
        continue;
      }
      if (hasRoot && open.empty()) break;
      XmlElement& element = hasRoot ? open.back()->children.emplace_back() : root;
      hasRoot = true;
      if (++mCount > kMostElements || open.size() > kDeepest) refuseDamage("it has too many elements");
      bool isClosed = parse(tag, element);
      element.textAt = mAt;
      if (element.name == mLast) {
        element.textEnd = mFile.size();
        break;
      }
      if (isClosed)
        element.textEnd = mAt;
      else
        open.push_back(&element);
    }
    return root;
  }

 private:
  [[noreturn]] void refuseDamage(std::string_view what) const {
    refuse(mFile.path(), fmt::format("is damaged: {} (byte {})", what, mAt));
  }

  /// The bytes from a place on that a window holds, at least one.
  std::string_view window(std::uint64_t at) {
    if (at >= mFile.size()) refuse(mFile.path(), "is cut short: its XML has no end");
    if (at < mStart || at >= mStart + mWindow.size()) {
      mWindow.resize(std::size_t(std::min<std::uint64_t>(kWindow, mFile.size() - at)));
      mFile.read(at, std::as_writable_bytes(std::span(mWindow)));
      mStart = at;
    }
    return std::string_view(mWindow).substr(std::size_t(at - mStart));
  }
  std::uint64_t find(char wanted, std::uint64_t from) {
    for (;;) {
      std::string_view here = window(from);
      if (auto at = here.find(wanted); at != here.npos) return from + at;
      from += here.size();
    }
  }
  bool isAt(std::uint64_t at, std::string_view text) {
    for (char c : text)
      if (at >= mFile.size() || window(at++)[0] != c) return false;
    return true;
  }
  bool passOver(std::string_view begin, std::string_view end) {
    if (!isAt(mAt, begin)) return false;
    for (mAt = find(end[0], mAt + begin.size()); !isAt(mAt, end);) mAt = find(end[0], mAt + 1);
    mAt += end.size();
    return true;
  }

  /// What stands between "<" and ">"; within quotation marks ">" is a letter.
  std::string takeTag() {
    std::string tag;
    char quote = 0;
    for (++mAt;; ++mAt) {
      char c = window(mAt)[0];
      if (!quote && c == '>') break;
      if (quote ? c == quote : c == '"' || c == '\'') quote = quote ? 0 : c;
      tag += c;
      if (tag.size() > kLongestTag) refuseDamage("a tag has no end");
    }
    ++mAt;
    return tag;
  }

  /// @return true when the tag closes itself
  bool parse(std::string_view tag, XmlElement& element) {
    bool isClosed = tag.ends_with('/');
    if (isClosed) tag.remove_suffix(1);
    element.name = tag.substr(0, tag.find_first_of(kBlanks));
    tag.remove_prefix(element.name.size());
    for (;;) {
      tag.remove_prefix(std::min(tag.find_first_not_of(kBlanks), tag.size()));
      if (tag.empty()) return isClosed;
      std::size_t equals = tag.find('=');
      std::size_t from = equals == tag.npos ? tag.npos : tag.find_first_not_of(kBlanks, equals + 1);
      std::size_t to =
          from == tag.npos || (tag[from] != '"' && tag[from] != '\'') ? tag.npos : tag.find(tag[from], from + 1);
      if (to == tag.npos) refuseDamage(fmt::format("an attribute of <{}> is not understood", inQuotes(element.name)));
      std::string_view key = tag.substr(0, equals);
      element.attributes.emplace_back(key.substr(0, key.find_first_of(kBlanks)),
                                      withoutEntities(tag.substr(from + 1, to - from - 1)));
      tag.remove_prefix(to + 1);
    }
  }

  const FileBytes& mFile;
  std::string_view mLast;
  std::string mWindow;
  std::uint64_t mStart = 0, mAt = 0;
  std::size_t mCount = 0;
};

}  // namespace

std::string_view XmlElement::attribute(std::string_view key) const {
  for (const auto& [known, value] : attributes)
    if (known == key) return value;
  return {};
}

const XmlElement* XmlElement::child(std::string_view key) const {
  auto at = std::find_if(children.begin(), children.end(), [&](const XmlElement& e) { return e.name == key; });
  return at == children.end() ? nullptr : &*at;
}

XmlElement readXml(const FileBytes& file, std::string_view last) { return XmlReader(file, last).read(); }

}  // namespace velum::io
