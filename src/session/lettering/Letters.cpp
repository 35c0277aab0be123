#include "session/lettering/Letters.h"

#include <freetype/freetype.h>
#include <freetype/ftoutln.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>

#include "core/Assert.h"
#include "core/Text.h"

namespace velum {
// Made by velum_embed_file().
extern const unsigned char kLetterFont[];
extern const std::size_t kLetterFontSize;
}  // namespace velum

namespace velum::session {

struct Letters::Font {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  std::unordered_map<std::uint32_t, double> advances;  ///< of letters that were asked for, ems
  Font() {
    bool isRead = FT_Init_FreeType(&library) == 0 &&
                  FT_New_Memory_Face(library, kLetterFont, FT_Long(kLetterFontSize), 0, &face) == 0;
    VELUM_ASSERT(isRead, "the font is part of the program");
  }
  ~Font() {
    FT_Done_Face(face);
    FT_Done_FreeType(library);
  }
  /// The way from the start of a letter to that of the next, in ems.
  double advanceOf(std::uint32_t letter) {
    auto [found, isNew] = advances.try_emplace(letter, 0.0);
    if (isNew && FT_Load_Char(face, letter, FT_LOAD_NO_SCALE) == 0)
      found->second = double(face->glyph->metrics.horiAdvance) / face->units_per_EM;
    return found->second;
  }
  /// How much further apart two letters stand than others, in ems. Words stand alone, and digits in columns.
  double kerningOf(std::uint32_t before, std::uint32_t letter) const {
    auto isDigit = [](std::uint32_t of) { return of >= '0' && of <= '9'; };
    FT_Vector kerning{};
    if (before <= ' ' || letter <= ' ' || (isDigit(before) && isDigit(letter)) ||
        FT_Get_Kerning(face, FT_Get_Char_Index(face, before), FT_Get_Char_Index(face, letter), FT_KERNING_UNSCALED,
                       &kerning) != 0)
      return 0.0;
    return double(kerning.x) / face->units_per_EM;
  }
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;
};

namespace {

constexpr std::uint32_t kUnreadable = 0xfffd;

/// The letters of a text in UTF-8; what is no UTF-8 is kUnreadable.
std::vector<std::uint32_t> lettersOf(std::string_view text) {
  std::vector<std::uint32_t> letters;
  for (std::size_t i = 0; i < text.size();) {
    auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
    unsigned first = byte(i++);
    int more = first < 0x80 ? 0 : first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : -1;
    if (more < 0) {
      letters.push_back(kUnreadable);
      continue;
    }
    std::uint32_t letter = more == 0 ? first : first & (0x3fu >> more);
    for (; more > 0 && i < text.size() && (byte(i) & 0xc0u) == 0x80u; --more)
      letter = letter << 6 | (byte(i++) & 0x3fu);
    letters.push_back(more > 0 ? kUnreadable : letter);
  }
  return letters;
}

/// Where the letter behind a place of a text begins.
std::size_t nextLetter(std::string_view text, std::size_t at) {
  do ++at;
  while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0u) == 0x80u);
  return at;
}

}  // namespace

Letters::Letters(double em) : mFont(std::make_unique<Font>()), mEm(em) {
  FT_Set_Char_Size(mFont->face, 0, FT_F26Dot6(std::lround(em * 64.0)), 72, 72);
}

Letters::~Letters() = default;

double Letters::width(std::string_view text) const {
  double ems = 0.0;
  std::uint32_t before = 0;
  for (std::uint32_t letter : lettersOf(text))
    ems += mFont->kerningOf(std::exchange(before, letter), letter) + mFont->advanceOf(letter);
  return ems * mEm;
}

std::string Letters::fitted(const std::string& text, double most) const {
  if (width(text) <= most) return text;
  auto isStart = [&](std::size_t at) {
    return at == text.size() || (static_cast<unsigned char>(text[at]) & 0xc0u) != 0x80u;
  };
  std::size_t head = text.size() / 2, tail = head;
  for (;;) {
    while (!isStart(head)) --head;
    while (!isStart(tail)) ++tail;
    std::string shorter = text.substr(0, head) + "\u2026" + text.substr(tail);
    if ((head == 0 && tail == text.size()) || width(shorter) <= most) return shorter;
    bool fromHead = head > 0 && head >= text.size() - tail;
    fromHead ? --head : ++tail;
  }
}

/// Words in lines, each as full as it gets.
std::vector<std::string> Letters::filled(const std::vector<std::string>& words, double most) const {
  std::vector<std::string> lines(1);
  double used = 0.0, blank = width(" ");
  for (std::string word : words) {
    bool isFirst = lines.back().empty();
    double longer = used + (isFirst ? 0.0 : blank) + width(word);
    if (longer <= most) {
      lines.back() += (isFirst ? "" : " ") + word;
      used = longer;
      continue;
    }
    if (!isFirst) lines.emplace_back();
    while (width(word) > most) {
      std::size_t end = nextLetter(word, 0);  // a line has one letter, however wide
      for (std::size_t next = end; next < word.size() && width(std::string_view(word).substr(0, next)) <= most;
           next = nextLetter(word, next))
        end = next;
      if (end == word.size()) break;
      lines.back() = word.substr(0, end);
      lines.emplace_back();
      word.erase(0, end);
    }
    used = width(word);
    lines.back() = std::move(word);
  }
  return lines;
}

std::vector<std::string> Letters::lines(std::string_view text, double most) const {
  std::vector<std::string> all;
  for (std::size_t begin = 0; begin <= text.size();) {
    std::size_t end = std::min(text.find('\n', begin), text.size());
    std::vector<std::string> words = wordsOf(text.substr(begin, end - begin)), lines = filled(words, most);
    double low = 0.0, high = most;
    for (const std::string& word : words) low = std::max(low, std::min(width(word), most));
    // The least width that gives as many lines, to a hundredth of the widest.
    while (lines.size() > 1 && high - low > 0.01 * most) {
      double middle = 0.5 * (low + high);
      auto narrower = filled(words, middle);
      if (narrower.size() > lines.size())
        low = middle;
      else
        high = middle, lines = std::move(narrower);
    }
    all.insert(all.end(), lines.begin(), lines.end());
    begin = end + 1;
  }
  return all;
}

void Letters::draw(std::string_view text, glm::dvec2 start, Mark& mark) const {
  FT_Face face = mFont->face;
  FT_Bitmap bitmap{};
  bitmap.rows = unsigned(mark.size.y);
  bitmap.width = unsigned(mark.size.x);
  bitmap.pitch = mark.size.x;
  bitmap.buffer = mark.covers.data();
  bitmap.num_grays = 256;
  bitmap.pixel_mode = FT_PIXEL_MODE_GRAY;
  start -= glm::dvec2(mark.corner);
  double x = start.x;
  std::uint32_t before = 0;
  for (std::uint32_t letter : lettersOf(text)) {
    double advance = mFont->advanceOf(letter) * mEm;
    x += mFont->kerningOf(std::exchange(before, letter), letter) * mEm;
    if (FT_Load_Char(face, letter, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) == 0) {
      FT_Outline_Translate(&face->glyph->outline, FT_Pos(std::lround(x * 64.0)),
                           FT_Pos(std::lround((mark.size.y - start.y) * 64.0)));
      FT_Outline_Get_Bitmap(mFont->library, &face->glyph->outline, &bitmap);
    }
    x += advance;
  }
}

}  // namespace velum::session
