#include "vector/ThinLines.h"

#include <algorithm>
#include <array>
#include <bit>

namespace velum::vector {

namespace {

constexpr std::array<glm::ivec2, 8> kAround{{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

/// Whether what is around a pixel hangs together without it, and what is not, too.
bool isSimplePixel(unsigned around) {
  int pieces = 0;
  for (int i = 0; i < 8; i += 2) {  // edges that are not set, of which each piece of eight ends once
    bool own = (around >> i & 1u) != 0, next = (around >> ((i + 1) % 8) & 1u) != 0;
    bool over = (around >> ((i + 2) % 8) & 1u) != 0;
    if (!own && (next || over)) ++pieces;
  }
  return pieces == 1;
}

void thin(Mask& mask) {
  std::vector<glm::ivec2> left;
  for (int y = 0; y < mask.size().y; ++y)
    for (int x = 0; x < mask.size().x; ++x)
      if (mask.at({x, y})) left.push_back({x, y});
  for (bool hasChanged = true; hasChanged;) {
    hasChanged = false;
    for (int side : {0, 4, 2, 6}) {
      std::vector<glm::ivec2> border;
      for (glm::ivec2 p : left)
        if (mask.at(p) && !mask.at(p + kAround[std::size_t(side)])) border.push_back(p);
      for (glm::ivec2 p : border) {
        unsigned around = mask.around(p);
        if (std::popcount(around) < 2 || !isSimplePixel(around)) continue;
        mask.set(p, false);
        hasChanged = true;
      }
    }
    std::erase_if(left, [&](glm::ivec2 p) { return !mask.at(p); });
  }
}

/// A stretch between places where lines meet or end, pixel by pixel.
struct Stretch {
  std::vector<glm::ivec2> pixels;
  bool meetsAtStart = false, meetsAtEnd = false;  // the pixel there is one where lines meet
};

bool isMeeting(const Mask& mask, glm::ivec2 p) {
  unsigned around = mask.around(p);
  int turns = 0;  // from not set to set, once round
  for (int i = 0; i < 8; ++i) turns += !(around >> i & 1u) && (around >> ((i + 1) % 8) & 1u);
  return turns >= 3 || (turns == 2 && std::popcount(around) > 3);
}

/// Walks along thin lines.
class LineWalk {
 public:
  explicit LineWalk(const Mask& mask) : mMask(mask), mDone(mask.size()) {}

  std::vector<Stretch> all() {
    auto eachPixel = [&](auto&& call) {
      for (int y = 0; y < mMask.size().y; ++y)
        for (int x = 0; x < mMask.size().x; ++x)
          if (mMask.at({x, y}) && !mDone.at({x, y})) call(glm::ivec2(x, y));
    };
    eachPixel([&](glm::ivec2 p) {
      if (isMeeting(mMask, p)) mMeetings.push_back(p);
    });
    for (glm::ivec2 p : mMeetings) mDone.set(p, true);
    for (glm::ivec2 p : mMeetings)
      for (glm::ivec2 way : kAround)
        if (mMask.at(p + way) && !mDone.at(p + way)) walk({{p}, true, false}, p + way);
    eachPixel([&](glm::ivec2 p) {
      if (std::popcount(mMask.around(p)) <= 1) walk({}, p);
    });
    eachPixel([&](glm::ivec2 p) { walk({}, p); });  // what is left goes round
    return std::move(mFound);
  }

 private:
  void walk(Stretch stretch, glm::ivec2 p) {
    for (;;) {
      stretch.pixels.push_back(p);
      mDone.set(p, true);
      glm::ivec2 next = p, meeting = p;
      // Edges first, so that no corner is cut.
      for (std::size_t i : {0u, 2u, 4u, 6u, 1u, 3u, 5u, 7u}) {
        glm::ivec2 there = p + kAround[i];
        if (!mMask.at(there)) continue;
        if (next == p && !mDone.at(there)) next = there;
        bool isOrigin = stretch.meetsAtStart && stretch.pixels.size() <= 3 && there == stretch.pixels.front();
        if (meeting == p && !isOrigin && mDone.at(there) && isMeeting(mMask, there)) meeting = there;
      }
      bool hasJustLeft = stretch.meetsAtStart && stretch.pixels.size() <= 2 && next != p;
      if (meeting != p && !hasJustLeft) {
        stretch.pixels.push_back(meeting);
        stretch.meetsAtEnd = true;
        break;
      }
      if (next == p) break;
      p = next;
    }
    mFound.push_back(std::move(stretch));
  }

  const Mask& mMask;
  Mask mDone;
  std::vector<glm::ivec2> mMeetings;
  std::vector<Stretch> mFound;
};

/// Takes ends that stick out of the mask. @return whether there were some
bool prune(Mask& mask, const std::vector<Stretch>& stretches, int spur) {
  bool hasChanged = false;
  for (const Stretch& stretch : stretches) {
    if (stretch.meetsAtStart == stretch.meetsAtEnd || int(stretch.pixels.size()) > spur) continue;
    for (std::size_t i = 0; i < stretch.pixels.size(); ++i) {
      bool isKept = (i == 0 && stretch.meetsAtStart) || (i + 1 == stretch.pixels.size() && stretch.meetsAtEnd);
      if (!isKept) mask.set(stretch.pixels[i], false);
    }
    hasChanged = true;
  }
  if (hasChanged) thin(mask);
  return hasChanged;
}

/// An end of a stretch where others meet it.
struct MeetingEnd {
  glm::ivec2 place;
  std::size_t stretch;
  bool isEnd;
  glm::dvec2 outwards;  // away from the meeting, unit
};

std::vector<MeetingEnd> meetingEnds(const std::vector<Stretch>& stretches) {
  std::vector<MeetingEnd> ends;
  for (std::size_t i = 0; i < stretches.size(); ++i)
    for (bool isEnd : {false, true}) {
      const auto& pixels = stretches[i].pixels;
      if (!(isEnd ? stretches[i].meetsAtEnd : stretches[i].meetsAtStart) || pixels.size() < 2) continue;
      std::size_t far = std::min(pixels.size() - 1, std::size_t(10));
      glm::ivec2 place = isEnd ? pixels.back() : pixels.front();
      glm::ivec2 there = isEnd ? pixels[pixels.size() - 1 - far] : pixels[far];
      if (place != there) ends.push_back({place, i, isEnd, glm::normalize(glm::dvec2(there - place))});
    }
  return ends;
}

/// By stretch and end (twice its number, plus 1 at its end): the end of another one with which it goes on; -1: none.
std::vector<int> pairEnds(const std::vector<Stretch>& stretches) {
  constexpr double kStraight = -0.6;
  std::vector<int> partner(2 * stretches.size(), -1);
  std::vector<MeetingEnd> ends = meetingEnds(stretches);
  auto isBefore = [](const MeetingEnd& a, const MeetingEnd& b) {
    return a.place.y != b.place.y ? a.place.y < b.place.y : a.place.x < b.place.x;
  };
  std::stable_sort(ends.begin(), ends.end(), isBefore);
  struct Pair {
    double straight;
    std::size_t a, b;
  };
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < ends.size(); ++a)
    for (std::size_t b = a + 1; b < ends.size() && ends[b].place.y <= ends[a].place.y + 1; ++b) {
      glm::ivec2 off = glm::abs(ends[a].place - ends[b].place);
      if (off.x > 1 || off.y > 1 || ends[a].stretch == ends[b].stretch) continue;
      pairs.push_back({glm::dot(ends[a].outwards, ends[b].outwards), a, b});
    }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.straight < b.straight; });
  for (const Pair& pair : pairs) {
    auto keyOf = [&](std::size_t end) { return 2 * ends[end].stretch + (ends[end].isEnd ? 1u : 0u); };
    std::size_t a = keyOf(pair.a), b = keyOf(pair.b);
    if (pair.straight > kStraight || partner[a] >= 0 || partner[b] >= 0) continue;
    partner[a] = int(b);
    partner[b] = int(a);
  }
  return partner;
}

std::vector<PixelChain> joined(const std::vector<Stretch>& stretches) {
  std::vector<int> partner = pairEnds(stretches);
  std::vector<PixelChain> chains;
  std::vector<bool> isDone(stretches.size());
  auto follow = [&](int from) {  // from is the end at which the walk enters the first stretch
    PixelChain chain;
    int at = from;
    while (at >= 0 && !isDone[std::size_t(at / 2)]) {
      isDone[std::size_t(at / 2)] = true;
      auto pixels = stretches[std::size_t(at / 2)].pixels;
      if (at % 2 == 1) std::reverse(pixels.begin(), pixels.end());
      bool isTwice = !chain.pixels.empty() && chain.pixels.back() == pixels.front();
      chain.pixels.insert(chain.pixels.end(), pixels.begin() + (isTwice ? 1 : 0), pixels.end());
      at = partner[std::size_t(at ^ 1)];
    }
    glm::ivec2 off = glm::abs(chain.pixels.front() - chain.pixels.back());
    chain.isClosed = chain.pixels.size() > 7 && off.x <= 1 && off.y <= 1;
    if (chain.isClosed && off == glm::ivec2(0)) chain.pixels.pop_back();
    chains.push_back(std::move(chain));
  };
  for (int end = 0; end < int(partner.size()); ++end)
    if (partner[std::size_t(end)] < 0 && !isDone[std::size_t(end / 2)]) follow(end);
  for (int end = 0; end < int(partner.size()); ++end)
    if (!isDone[std::size_t(end / 2)]) follow(end);
  return chains;
}

}  // namespace

unsigned Mask::around(glm::ivec2 p) const {
  unsigned bits = 0;
  for (unsigned i = 0; i < 8; ++i) bits |= unsigned(at(p + kAround[i])) << i;
  return bits;
}

std::vector<PixelChain> thinLines(Mask& mask, int spur) {
  thin(mask);
  std::vector<Stretch> stretches = LineWalk(mask).all();
  for (int round = 0; round < 3 && prune(mask, stretches, spur); ++round) stretches = LineWalk(mask).all();
  return joined(stretches);
}

}  // namespace velum::vector
