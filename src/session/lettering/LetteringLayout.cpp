#include "session/lettering/LetteringLayout.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>

#include "core/Text.h"
#include "scene/Scene.h"

namespace velum::session {

namespace {

// Lengths, in ems.
constexpr double kMargin = 1.3, kLine = 1.5, kSwatch = 0.82, kSwatchGap = 0.5, kCapHeight = 0.72, kCorner = 0.16;
constexpr double kBarThickness = 0.22, kBarGap = 0.42, kBlockGap = 0.6;
constexpr double kWidestName = 0.36;                        // of the picture's width
constexpr double kOutline = 0.05, kOutlineShare = 0.4;      // line around a colour that is near the ground's
constexpr double kSmallestEm = 5.0;                         // pixels; of captions that find no other room
constexpr double kCaptionLine = 1.3, kReach = 0.35;         // how far letters reach below and above capitals, at most
constexpr double kWidestMiddle = 0.86, kWidestSide = 0.46;  // of the picture's width
constexpr double kShrink = 0.87;
constexpr double kWholeRoom = 0.5, kLeastWeight = 1e-6;  // opacity at which a caption has all of its room
constexpr std::size_t kMostBytes = 1000;                 // of a caption

using scene::CaptionPlace;

CaptionPlace placeOf(scene::Corner corner) {
  constexpr CaptionPlace kPlaces[] = {CaptionPlace::TopLeft, CaptionPlace::TopRight, CaptionPlace::BottomLeft,
                                      CaptionPlace::BottomRight};
  return kPlaces[int(corner)];
}

}  // namespace

std::string drawable(std::string_view text) {
  std::size_t end = std::min(text.size(), kMostBytes);
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xc0u) == 0x80u) ++end;
  std::string out(text.substr(0, end));
  if (end < text.size()) out += "\u2026";
  for (char& c : out)
    if (static_cast<unsigned char>(c) < ' ' && c != '\n') c = ' ';
  return std::string(trimmed(out));
}

/// A caption as it is laid out at one size.
struct LetteringLayout::LaidCaption {
  const scene::Caption* caption;
  vector::Letters letters;
  std::vector<std::string> lines;
  bool breaksWords = false;
  glm::dvec2 size{0.0};  ///< from the tops of the first line's capitals to the last base line, pixels
  double weight;         ///< 0..1: how much of its room it has; others glide into the rest while it fades
  double top = 0.0;      ///< see stack()

  /// @param widest  pixels
  LaidCaption(const scene::Caption& of, vector::Font font, double em, double widest)
      : caption(&of),
        letters(font, em),
        lines(letters.lines(drawable(of.text), widest)),
        weight(std::max(kLeastWeight, glm::smoothstep(0.0, kWholeRoom, of.opacity))) {
    std::size_t words = 0;
    for (const std::string& line : lines) {
      size.x = std::max(size.x, letters.width(line));
      words += wordsOf(line).size();
    }
    breaksWords = words > wordsOf(drawable(of.text)).size();
    size.y = (kCapHeight + kCaptionLine * double(lines.size() - 1)) * em;
  }
};

LetteringLayout::LetteringLayout(const scene::Scene& scene, glm::ivec2 size, std::optional<glm::vec3> ground)
    : mScene(scene),
      mSize(size),
      mGround(ground),
      mStyle(scene.lettering, size),
      mLetters(mStyle.font(), mStyle.em()),
      mPlaces(mSize) {}

glm::vec3 LetteringLayout::ground(CaptionPlace place) const { return mGround ? *mGround : groundOf(mScene, place); }

std::optional<glm::dvec2> LetteringLayout::place(CaptionPlace place, glm::dvec2 room, double em) {
  double margin = std::max(kMargin * mLetters.em(), kReach * em);
  glm::dvec2 wanted = margin + 0.5 * glm::dvec2(cellOf(place)) * (mSize - 2.0 * margin - room);
  return mPlaces.take(room, wanted, margin, kBlockGap * em);
}

LetteringBlock& LetteringLayout::add(const char* layer, glm::vec3 ground, double em) {
  return mBlocks.emplace_back(LetteringBlock{layer, {}, ground, em, mScene.lettering.halo, 1.0});
}

void LetteringLayout::addLegend(const std::vector<LegendEntry>& entries) {
  double em = mLetters.em();
  std::vector<std::string> names;
  for (const LegendEntry& entry : entries) names.push_back(mLetters.fitted(entry.name, kWidestName * mSize.x));
  // As many rows as there is room for.
  for (std::size_t rows = entries.size(); rows > 0; --rows, names.pop_back()) {
    double room = 0.0;
    for (const std::string& name : names) room = std::max(room, mLetters.width(name));
    glm::dvec2 size((kSwatch + kSwatchGap) * em + room, kLine * em * double(rows));
    if (auto at = place(placeOf(mScene.lettering.legendCorner), size, em)) return addLegendRows(entries, names, *at);
  }
}

void LetteringLayout::addLegendRows(const std::vector<LegendEntry>& entries, const std::vector<std::string>& names,
                                    glm::dvec2 at) {
  double em = mLetters.em(), line = kLine * em, swatch = kSwatch * em, before = swatch + kSwatchGap * em;
  glm::vec3 ground = this->ground(placeOf(mScene.lettering.legendCorner)), ink = mStyle.inkOn(ground);
  LetteringBlock& block = add("legend", LetteringStyle::glowOf(ink, ground), em);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::vector<glm::vec3>& colors = entries[i].colors;
    glm::dvec2 low(at.x, at.y + line * double(i) + 0.5 * (line - swatch)), high = low + swatch;
    vector::Outline edge = vector::rectangle(low - kOutline * em, high + kOutline * em, (kCorner + kOutline) * em);
    block.items.push_back(vector::Shape{names[i], {edge}, {}, vector::Fill{ink, kOutlineShare}});
    // Each band lies over the right part of those before it.
    for (std::size_t c = 0; c < colors.size(); ++c) {
      double from = low.x + swatch * double(c) / double(colors.size());
      vector::Outline band = vector::rectangle({from, low.y}, high, c == 0 ? kCorner * em : 0.0, kCorner * em);
      block.items.push_back(vector::Shape{names[i], {band}, {}, vector::Fill{colors[c], 1.0}});
    }
  }
  for (std::size_t i = 0; i < names.size(); ++i)
    block.items.push_back(
        mLetters.words(names[i], {at.x + before, at.y + line * double(i) + 0.5 * (line + kCapHeight * em)}, ink));
}

void LetteringLayout::addScaleBar(const ScaleBar& bar) {
  double em = mLetters.em(), text = mLetters.width(bar.text);
  glm::dvec2 size(std::max(bar.pixels, text), (kCapHeight + kBarGap + kBarThickness) * em);
  CaptionPlace corner = placeOf(mScene.lettering.scaleBarCorner);
  auto at = place(corner, size, em);
  if (!at) return;
  glm::vec3 ground = this->ground(corner), ink = mStyle.inkOn(ground);
  LetteringBlock& block = add("scale bar", LetteringStyle::glowOf(ink, ground), em);
  double middle = cellOf(corner).x == 0 ? at->x + 0.5 * bar.pixels : at->x + size.x - 0.5 * bar.pixels;
  glm::dvec2 low(middle - 0.5 * bar.pixels, at->y + (kCapHeight + kBarGap) * em),
      high(low.x + bar.pixels, at->y + size.y);
  block.items.push_back(vector::Shape{"scale bar", {vector::rectangle(low, high, 0.0)}, {}, vector::Fill{ink, 1.0}});
  block.items.push_back(mLetters.words(
      bar.text, {std::clamp(middle - 0.5 * text, at->x, at->x + size.x - text), at->y + kCapHeight * em}, ink));
}

/// The unit stays where it is, whatever the time.
void LetteringLayout::addTimeStamp(const TimeStamp& stamp) {
  double em = mLetters.em();
  glm::dvec2 size(mLetters.width(stamp.widest), kCapHeight * em);
  CaptionPlace corner = placeOf(mScene.lettering.timeStampCorner);
  auto at = place(corner, size, em);
  if (!at) return;
  glm::vec3 ground = this->ground(corner), ink = mStyle.inkOn(ground);
  LetteringBlock& block = add("time", LetteringStyle::glowOf(ink, ground), em);
  block.items.push_back(mLetters.words(stamp.text, *at + size - glm::dvec2(mLetters.width(stamp.text), 0.0), ink));
}

void LetteringLayout::addCaptions() {
  for (std::size_t i = 0; i < std::size(EnumNames<CaptionPlace>::kNames); ++i) {
    std::vector<const scene::Caption*> captions;
    for (const scene::Caption& caption : mScene.lettering.captions)
      if (caption.place == CaptionPlace(i) && caption.opacity > 0.0 && !drawable(caption.text).empty())
        captions.push_back(&caption);
    if (!captions.empty()) addCaptionsAt(CaptionPlace(i), captions);
  }
}

/// Stands captions below each other, each in as much of its room as it has, so that one that fades takes and gives room
/// bit by bit, and stays where it is when it is alone. Their tops are told from the place that lies at `share` of the
/// whole, 0..1. @return the size of a part in which all lie, with that place at the same share of it
glm::dvec2 LetteringLayout::stack(std::deque<LaidCaption>& captions, double share, double gap) {
  double all = 0.0, above = 0.0, below = 0.0, width = 0.0;
  for (LaidCaption& laid : captions) {
    double room = laid.weight * (laid.size.y + gap);
    laid.top = all + share * (room - laid.size.y);
    all += room;
  }
  for (LaidCaption& laid : captions) {
    laid.top -= share * all;
    above = std::max(above, -laid.top);
    below = std::max(below, laid.top + laid.size.y);
    width = std::max(width, laid.size.x);
  }
  return {width, std::max(share > 0.0 ? above / share : 0.0, share < 1.0 ? below / (1.0 - share) : 0.0)};
}

/// Those of one place go together, smaller where there is no room or large letters would break words, and are left out
/// where letters would be too small.
void LetteringLayout::addCaptionsAt(CaptionPlace at, const std::vector<const scene::Caption*>& captions) {
  double widest = mSize.x * (cellOf(at).x == 1 ? kWidestMiddle : kWidestSide), largest = 2.0 * kSmallestEm;
  for (double shrink = 1.0; largest > kSmallestEm; shrink *= kShrink) {
    std::deque<LaidCaption> all;
    largest = 0.0;
    bool breaksWords = false;
    for (const scene::Caption* caption : captions) {
      const LaidCaption& laid =
          all.emplace_back(*caption, mStyle.font(), std::max(kSmallestEm, shrink * mStyle.em(caption->size)), widest);
      largest = std::max(largest, laid.letters.em());
      breaksWords |= laid.breaksWords;
    }
    if (breaksWords && largest > mLetters.em()) continue;
    double em = 0.0, most = 0.0;
    for (const LaidCaption& laid : all) {
      em = std::max(em, laid.weight * laid.letters.em());
      most = std::max(most, laid.weight);
    }
    em /= most;
    glm::dvec2 share = 0.5 * glm::dvec2(cellOf(at)), size = stack(all, share.y, kBlockGap * em);
    auto corner = place(at, size, em);
    if (!corner) continue;
    for (const LaidCaption& laid : all)
      addCaption(laid, *corner + share * size + glm::dvec2(-share.x * laid.size.x, laid.top));
    return;
  }
}

void LetteringLayout::addCaption(const LaidCaption& laid, glm::dvec2 at) {
  const scene::Caption& caption = *laid.caption;
  double em = laid.letters.em(), share = 0.5 * cellOf(caption.place).x;
  glm::vec3 ground = this->ground(caption.place), ink = caption.color.value_or(mStyle.inkOn(ground));
  LetteringBlock& block = add("captions", LetteringStyle::glowOf(ink, ground), em);
  block.opacity = caption.opacity;
  for (std::size_t i = 0; i < laid.lines.size(); ++i) {
    double indent = share * (laid.size.x - laid.letters.width(laid.lines[i]));
    block.items.push_back(
        laid.letters.words(laid.lines[i], at + glm::dvec2(indent, (kCapHeight + kCaptionLine * double(i)) * em), ink));
  }
}

}  // namespace velum::session
