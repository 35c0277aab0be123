#include "session/lettering/NameLayout.h"

#include <algorithm>
#include <cmath>

#include "scene/Scene.h"
#include "session/lettering/Leaders.h"
#include "session/lettering/LetteringLayout.h"
#include "session/mark/MarkHands.h"
#include "session/mark/MarkWords.h"

namespace velum::session {

namespace {

constexpr double kNameLine = 1.22, kNameCap = 0.72, kNameDot = 0.15;  // ems
constexpr double kWidestWords = 0.24;                                 // of the picture's width
constexpr double kFarthestGlide = 12.0;                               // ems: what goes farther fades
constexpr double kMarkWeight = 1e12;                                  // marks that the user has set stay before all

/// A name with all that is drawn of it.
struct NameWords {
  NameToPlace name;
  std::vector<std::string> lines;
  glm::vec3 ink{0.0f};
  double opacity = 1.0;
  PlacedWords placed;
};

class NameLayout {
 public:
  NameLayout(const scene::Scene& scene, const NamePaper& paper)
      : mScene(scene),
        mSize(paper.size),
        mGround(paper.ground),
        mStyle(scene.lettering, paper.size, paper.leastEm),
        mLetters(mStyle.font(), mStyle.em()) {}

  void add(int key, const std::string& text, const SeenName& seen, double weight, const scene::Mark* mark) {
    glm::dvec2 anchor = seen.anchor;
    std::string drawn = drawable(text);
    if (drawn.empty()) return;
    NameWords words{{key, {}, anchor, weight, {}},
                    mLetters.lines(drawn, kWidestWords * mSize.x),
                    {},
                    1.0,
                    {mark ? mark->id : 0, seen.structure, seen.type, {}, {}, anchor}};
    for (const std::string& line : words.lines) words.name.size.x = std::max(words.name.size.x, mLetters.width(line));
    words.name.size.y = (kNameCap + kNameLine * double(words.lines.size() - 1)) * mStyle.em();
    words.ink = mark && mark->color ? *mark->color : mStyle.inkOn(mGround);
    if (mark) words.opacity = mark->opacity;
    if (mark && mark->wordsAt) words.name.fixed = anchor + *mark->wordsAt * mSize.y - 0.5 * words.name.size;
    mWords.push_back(std::move(words));
  }

  LaidNames lay(const SeenNames& seen, const FreePlaces& places, const std::vector<NamePlace>* before,
                const NamesBetween* between) {
    NameRoom room{mSize, seen.subject, {}, mScene.lettering.nameOrder, mStyle.em()};
    for (const FreePlaces::Taken& taken : places.taken())
      room.taken.push_back({taken.low - taken.gap, taken.high + taken.gap});
    std::vector<NameToPlace> names;
    for (const NameWords& words : mWords) names.push_back(words.name);
    LaidNames laid;
    laid.places = between ? pointed(placesBetween(*between, mStyle.em()), room) : placeNames(names, room, before);
    for (const NamePlace& place : laid.places) {
      auto words = std::ranges::find(mWords, place.key, [](const NameWords& of) { return of.name.key; });
      addLeader(laid.blocks, *words, place);
      addWords(laid.blocks, *words, place);
      laid.words.push_back(words->placed);
      laid.words.back().low = place.block.low;
      laid.words.back().high = place.block.high;
    }
    return laid;
  }

 private:
  /// Places with leaders to the anchors of now; without those of which nothing is seen now.
  std::vector<NamePlace> pointed(const std::vector<NamePlace>& places, const NameRoom& room) const {
    std::vector<NamePlace> out;
    for (const NamePlace& place : places) {
      auto words = std::ranges::find(mWords, place.key, [](const NameWords& of) { return of.name.key; });
      if (words == mWords.end()) continue;
      out.push_back(placeAt(words->name, place.block.low, room));
      out.back().strength = place.strength;
    }
    return out;
  }
  LetteringBlock blockOf(const char* layer, const NameWords& words, const NamePlace& place) const {
    return {layer,
            {},
            LetteringStyle::glowOf(words.ink, mGround),
            mStyle.em(),
            mScene.lettering.halo,
            words.opacity * place.strength};
  }
  void addLeader(std::vector<LetteringBlock>& blocks, const NameWords& words, const NamePlace& place) const {
    LetteringBlock block = blockOf("leaders", words, place);
    vector::Pen pen{words.ink, mStyle.lineWidth(), 1.0, {}};
    block.items.push_back(vector::Shape{words.lines.front(), {vector::outlineThrough(place.leader, false)}, pen, {}});
    double radius = std::max(kNameDot * mStyle.em(), pen.width);
    block.items.push_back(vector::Shape{
        words.lines.front(), {vector::circle(place.leader.back(), radius)}, {}, vector::Fill{words.ink, 1.0}});
    blocks.push_back(std::move(block));
  }
  /// Flush on the side of what is named.
  void addWords(std::vector<LetteringBlock>& blocks, const NameWords& words, const NamePlace& place) const {
    LetteringBlock block = blockOf("labels", words, place);
    bool isLeft = 0.5 * (place.block.low.x + place.block.high.x) < words.name.anchor.x;
    for (std::size_t i = 0; i < words.lines.size(); ++i) {
      double indent = isLeft ? words.name.size.x - mLetters.width(words.lines[i]) : 0.0;
      glm::dvec2 start = place.block.low + glm::dvec2(indent, (kNameCap + kNameLine * double(i)) * mStyle.em());
      block.items.push_back(mLetters.words(words.lines[i], start, words.ink));
    }
    blocks.push_back(std::move(block));
  }

  const scene::Scene& mScene;
  glm::dvec2 mSize;
  glm::vec3 mGround;
  LetteringStyle mStyle;
  vector::Letters mLetters;
  std::vector<NameWords> mWords;
};

}  // namespace

std::vector<NamePlace> placesBetween(const NamesBetween& names, double em) {
  std::vector<NamePlace> out;
  auto faded = [&](NamePlace place, double strength) {
    place.strength *= std::clamp(strength, 0.0, 1.0);
    if (place.strength > 0.0) out.push_back(std::move(place));
  };
  for (const NamePlace& from : names.from) {
    auto to = std::ranges::find(names.to, from.key, &NamePlace::key);
    if (to == names.to.end() || glm::distance(from.block.low, to->block.low) > kFarthestGlide * em) {
      faded(from, 1.0 - 2.0 * names.share);
      continue;
    }
    NamePlace place = from;
    place.block.low = glm::mix(from.block.low, to->block.low, names.share);
    place.block.high = place.block.low + from.block.high - from.block.low;
    place.strength = std::lerp(from.strength, to->strength, names.share);
    out.push_back(std::move(place));
  }
  for (const NamePlace& to : names.to) {
    auto from = std::ranges::find(names.from, to.key, &NamePlace::key);
    if (from == names.from.end() || glm::distance(from->block.low, to.block.low) > kFarthestGlide * em)
      faded(to, 2.0 * names.share - 1.0);
  }
  return out;
}

LaidNames layNames(const scene::Scene& scene, const NamePaper& paper, const SeenNames& seen,
                   const std::map<int, Measured>& measured, const FreePlaces& places,
                   const std::vector<NamePlace>* before, const NamesBetween* between) {
  if (seen.names.empty() && seen.marks.empty()) return {};
  NameLayout layout(scene, paper);
  for (const SeenName& name : seen.names) layout.add(2 * name.key, name.name, name, double(name.pixels), nullptr);
  for (const auto& [id, name] : seen.marks) {
    const scene::Mark* mark = findMark(scene, id);
    if (!mark) continue;
    auto found = measured.find(id);
    std::string words = markWords(scene, *mark, found == measured.end() ? "" : found->second.text);
    layout.add(2 * id + 1, words, name, kMarkWeight, mark);
  }
  return layout.lay(seen, places, before, between);
}

}  // namespace velum::session
