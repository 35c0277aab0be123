#include <algorithm>

#include "session/lettering/Leaders.h"
#include "session/lettering/MarkLayout.h"

namespace velum::session {

namespace {

// Lengths, in ems.
constexpr double kMarkLine = 1.25, kMarkCap = 0.72, kMarkMargin = 0.6, kWordsGap = 0.35, kWordsApart = 0.35;
constexpr double kShortestLine = 0.9, kLabelAside = 3.0;

}  // namespace

void MarkLayout::addWords(const scene::Mark& mark, Words words) {
  bool isBeyond =
      glm::any(glm::lessThan(words.at, glm::dvec2(0.0))) || glm::any(glm::greaterThan(words.at, mView.space().size()));
  if (words.lines.empty() || isBeyond) return;
  double em = mStyle.em(), widest = 0.0;
  for (const std::string& line : words.lines) widest = std::max(widest, mLetters.width(line));
  glm::dvec2 size(widest, (kMarkCap + kMarkLine * double(words.lines.size() - 1)) * em);
  glm::dvec2 low;
  if (mark.wordsAt) {
    low = words.at + *mark.wordsAt * mView.space().size().y - 0.5 * size;
    mPlaces.add(low, size, kWordsApart * em);
  } else {
    // As far aside as the words reach in that direction.
    glm::dvec2 way = unitOr(words.aside, {0, -1});
    double reach = 0.5 * std::abs(way.x) * size.x + 0.5 * std::abs(way.y) * size.y + glm::length(words.aside);
    glm::dvec2 wanted = words.at + way * reach - 0.5 * size, most = mView.space().size() - kMarkMargin * em - size;
    wanted = glm::max(glm::min(wanted, most), glm::dvec2(kMarkMargin * em));
    auto free = mPlaces.take(size, wanted, kMarkMargin * em, kWordsApart * em);
    if (!free) return;
    low = *free;
  }
  glm::dvec2 target = words.target.value_or(words.at);
  glm::dvec2 nearest = glm::clamp(target, low - kWordsGap * em, low + size + kWordsGap * em);
  if (words.target || (mark.wordsAt && glm::distance(nearest, target) > kShortestLine * em)) {
    LetteringBlock leader = mLines;
    leader.layer = "leaders";
    leader.items = {vector::Shape{{}, {vector::outlineThrough({nearest, target}, false)}, mPen, {}}};
    mBlocks.push_back(std::move(leader));
  }
  mWords.push_back({mark.id, 0, {}, low, low + size, words.at});
  LetteringBlock block = mLines;
  bool isName = mark.kind == scene::MarkKind::Label || mark.kind == scene::MarkKind::Name;
  block.layer = isName ? "labels" : "marks";
  block.items.clear();
  for (std::size_t i = 0; i < words.lines.size(); ++i) {
    double indent = 0.5 * (size.x - mLetters.width(words.lines[i]));
    if (isName && low.x > target.x) indent = 0.0;
    block.items.push_back(
        mLetters.words(words.lines[i], low + glm::dvec2(indent, (kMarkCap + kMarkLine * double(i)) * em), mPen.color));
  }
  mBlocks.push_back(std::move(block));
}

/// Words beside a place, with a leader to what is seen of what they are of.
void MarkLayout::addLabel(const scene::Mark& mark, glm::dvec2 at, glm::dvec2 target) {
  addDot(target);
  glm::dvec2 size = mView.space().size();
  bool isIn = glm::all(glm::greaterThanEqual(at, glm::dvec2(0.0))) && glm::all(glm::lessThanEqual(at, size));
  if (!isIn || !mark.wordsAt) at = target;
  // Away from the picture's middle, where the subject is.
  glm::dvec2 out = unitOr((target - 0.5 * size) * glm::dvec2(1.0, 0.6), {1, 0});
  addWords(mark, {linesOf(mark, {}), at, kLabelAside * mStyle.em() * out, target});
}

}  // namespace velum::session
