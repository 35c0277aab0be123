#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace velum {

/// What a counter of the bars counts ([VE] 3): what became of instances of a model, or of the pixels of a structure.
struct CountKind {
  std::string_view name;          ///< of its column in tables, files and JSON
  std::string_view adjective;     ///< in the window: "By share that is seen"
  std::string_view role;          ///< colour of its part of a bar in the window, see gui/kit/Theme.h
  std::string_view fill, letter;  ///< its colours in files of bars, sRGB
  bool isSeen;                    ///< some pixel shows these
  bool isLeft;                    ///< cuts leave these
  std::string_view instances;     ///< which instances it counts, in the window: "Seen: 12"
  std::string_view pixels;        ///< of a structure, a share of whose pixels it is: "%1 % show it"
};

/// Places in kCountKinds.
enum class CountOf : std::size_t { Visible, Hidden, Clipped };

/// All there are; each instance or pixel is of one of them. A bar is their parts, in this order: those that are left
/// come first, and of these what is seen. They differ in lightness: whoever sees red and green alike, and prints
/// without colours, can tell them apart.
inline constexpr std::array kCountKinds{
    CountKind{"visible", "seen", "seen", "#0f6b52", "#ffffff", true, true, "Seen", "%1 % show it"},
    CountKind{"hidden", "hidden", "hidden", "#84cbb2", "#0b2b22", false, true,
              "Drawn, but hidden behind others or outside the picture", "on %1 % it is behind others"},
    CountKind{"clipped", "removed", "removed", "#dedede", "#4a4a4a", false, false, "Removed by cuts or not shown",
              "on %1 % cuts remove it"},
};

/// How many of each kind.
struct Counts {
  std::array<std::uint64_t, kCountKinds.size()> parts{};

  std::uint64_t& operator[](CountOf kind) { return parts[std::size_t(kind)]; }
  std::uint64_t operator[](CountOf kind) const { return parts[std::size_t(kind)]; }
  /// Some pixel shows these; of a structure: they show it.
  std::uint64_t visible() const { return sumOf(&CountKind::isSeen); }
  /// Left by cuts, but behind others, beside the picture, or smaller than a pixel sees.
  std::uint64_t hidden() const { return (*this)[CountOf::Hidden]; }
  /// Removed by cuts, or of what is not shown.
  std::uint64_t clipped() const { return (*this)[CountOf::Clipped]; }
  std::uint64_t left() const { return sumOf(&CountKind::isLeft); }
  std::uint64_t total() const {
    std::uint64_t sum = 0;
    for (std::uint64_t part : parts) sum += part;
    return sum;
  }
  Counts& operator+=(const Counts& other) {
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i] += other.parts[i];
    return *this;
  }
  bool operator==(const Counts&) const = default;

 private:
  std::uint64_t sumOf(bool CountKind::*isMeant) const {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) sum += kCountKinds[i].*isMeant ? parts[i] : 0;
    return sum;
  }
};

/// Of so many that are left and so many in all, as many are seen as of those of `before` that were left; all, where
/// none was.
Counts expectedCounts(const Counts& before, std::uint64_t left, std::uint64_t total);

/// "visible,hidden,clipped,total", and numbers in their places: the columns of tables.
std::string countColumns();
std::string countFields(const Counts& counts);

/// For people: "12,345".
std::string countText(std::uint64_t count);

}  // namespace velum
