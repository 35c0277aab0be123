#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace velum {

/// One kind of thing that the counters of the bars count ([VE] 3): what became of the instances of a model, or of the
/// pixels of a structure.
struct CountKind {
  std::string_view name;          ///< name of the kind's column in tables, files and JSON
  std::string_view adjective;     ///< in the window: "By share that is seen"
  std::string_view fill, letter;  ///< colours of its part of a bar and of letters on that, sRGB; the same everywhere
  bool isSeen;                    ///< some pixel shows instances or pixels of this kind
  bool isLeft;                    ///< instances or pixels of this kind are left by cuts
  std::string_view instances;     ///< names the counted instances in the window: "Seen: 12"
  std::string_view pixels;  ///< says in the window which share of a structure's pixels is of this kind: "%1 % show it"
};

/// Indices into kCountKinds.
enum class CountOf : std::size_t { Visible, Hidden, Clipped };

/// All kinds; each instance or pixel is of exactly one of them. A bar shows their parts in this order: the kinds that
/// cuts leave come first, and of these the kinds that are seen. The colours are those of [VE]: dark what is seen, light
/// what is hidden, grey what is removed, in files and in windows dark and light, so that a bar means the same wherever
/// it stands. They differ in lightness, so that people who cannot tell red from green, and prints without colours,
/// still show the parts apart; and each stands out from white paper and from a dark window.
inline constexpr std::array kCountKinds{
    CountKind{"visible", "seen", "#14805f", "#ffffff", true, true, "Seen", "%1 % show it"},
    CountKind{"hidden", "hidden", "#84cbb2", "#0b2b22", false, true,
              "Drawn, but hidden behind others or outside the picture", "on %1 % it is behind others"},
    CountKind{"clipped", "removed", "#969ca4", "#14181d", false, false, "Removed by cuts or not shown",
              "on %1 % cuts remove it"},
};

/// How many instances or pixels there are of each kind.
struct Counts {
  std::array<std::uint64_t, kCountKinds.size()> parts{};

  std::uint64_t& operator[](CountOf kind) { return parts[std::size_t(kind)]; }
  std::uint64_t operator[](CountOf kind) const { return parts[std::size_t(kind)]; }
  /// Instances that some pixel shows; for a structure: pixels that show the structure.
  std::uint64_t visible() const { return sumOf(&CountKind::isSeen); }
  /// Left by cuts, but hidden behind other things, outside the picture, or too small for any pixel to show.
  std::uint64_t hidden() const { return (*this)[CountOf::Hidden]; }
  /// Removed by cuts, or part of something that is switched off.
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

/// A forecast of the counts when cuts leave `left` of `total` instances: the share of the left ones that is seen is
/// taken to be the same as in `before`, or all of them where `before` had none left.
Counts expectedCounts(const Counts& before, std::uint64_t left, std::uint64_t total);

/// The columns of tables: countColumns() gives their names, "visible,hidden,clipped,total", countFields() the numbers
/// in the same order.
std::string countColumns();
std::string countFields(const Counts& counts);

/// The count as people read it: "12,345".
std::string countText(std::uint64_t count);

}  // namespace velum
