// The outline of a shape on a section, from nothing but its distance: marching squares.
#include "session/cut/SectionContour.h"

#include <array>
#include <cmath>
#include <map>

#include "core/Vectors.h"
#include "shared/cut.h"

namespace velum::session {

namespace {

/// Side of a square; corners of a shape are cut by about half of it.
constexpr double kCellPixels = 4.0;
constexpr int kMarginCells = 8;

/// A side of a square: its left or upper corner, and whether it goes down.
using Side = std::array<int, 3>;

class Contour {
 public:
  Contour(const scene::SectionPlane& plane, const scene::Cut& cut)
      : mPlane(plane),
        mLocalFromWorld(glm::inverse(scene::worldFromCut(cut))),
        mShape(static_cast<int>(cut.shape)),
        mHalf(solidEdges(cut.size) * 0.5) {}

  /// Squares that lie wholly inside or outside, as their middle tells, are left out unseen.
  void march(int x, int y, int cells) {
    double middle = at({x + 0.5 * cells, y + 0.5 * cells});
    double corner = 0.5 * std::sqrt(2.0) * cells * kCellPixels * mPlane.lengthPerPixel;
    if (std::abs(middle) > 1.001 * corner) return;
    if (cells == 1) return addSquare(x, y, middle < 0);
    int half = cells / 2;
    for (int i = 0; i < 4; ++i) march(x + (i & 1 ? half : 0), y + (i & 2 ? half : 0), half);
  }

  /// The pieces put end to end: first those that leave the view, then what goes round.
  std::vector<std::vector<glm::dvec2>> curves() {
    std::vector<std::vector<glm::dvec2>> curves;
    for (bool wantsEnds : {true, false})
      for (auto& [side, next] : mNext)
        if (!next.empty() && (next.size() == 1) == wantsEnds) curves.push_back(follow(side));
    return curves;
  }

 private:
  glm::dvec2 pixelOf(glm::dvec2 cell) const { return cell * kCellPixels; }

  double at(glm::dvec2 cell) const {
    glm::dvec3 world = scene::worldFromSectionPixel(mPlane, pixelOf(cell));
    return shared::cutShapeDistance(mShape, mHalf, glm::vec3(mLocalFromWorld * glm::dvec4(world, 1.0)));
  }

  void addSquare(int x, int y, bool middleIsInside) {
    // Around the square; side i lies between corner i and the next.
    constexpr int kX[] = {0, 1, 1, 0}, kY[] = {0, 0, 1, 1};
    const Side sides[] = {{x, y, 0}, {x + 1, y, 1}, {x, y + 1, 0}, {x, y, 1}};
    bool inside[4];
    for (int i = 0; i < 4; ++i) inside[i] = at({x + kX[i], y + kY[i]}) < 0;
    std::vector<int> crossed;
    for (int i = 0; i < 4; ++i)
      if (inside[i] != inside[(i + 1) % 4]) crossed.push_back(i);
    if (crossed.size() == 2) join(sides[crossed[0]], sides[crossed[1]]);
    if (crossed.size() != 4) return;
    // Two corners across are inside: the middle tells whether they hang together.
    int first = inside[0] == middleIsInside ? 0 : 3;
    join(sides[first], sides[(first + 1) % 4]);
    join(sides[(first + 2) % 4], sides[(first + 3) % 4]);
  }

  void join(const Side& a, const Side& b) {
    mNext[a].push_back(b);
    mNext[b].push_back(a);
  }

  /// Where the surface crosses a side, by halves, as the distance may have corners.
  glm::dvec2 placeOf(const Side& side) const {
    glm::dvec2 a(side[0], side[1]), b = a + (side[2] ? glm::dvec2(0, 1) : glm::dvec2(1, 0));
    bool isInside = at(a) < 0;
    for (int i = 0; i < 12; ++i) {
      glm::dvec2 middle = 0.5 * (a + b);
      ((at(middle) < 0) == isInside ? a : b) = middle;
    }
    return pixelOf(0.5 * (a + b));
  }

  std::vector<glm::dvec2> follow(Side side) {
    std::vector<glm::dvec2> curve{placeOf(side)};
    for (auto next = mNext.find(side); !next->second.empty(); next = mNext.find(side)) {
      Side to = next->second.back();
      next->second.pop_back();
      std::erase(mNext[to], side);
      side = to;
      curve.push_back(placeOf(side));
    }
    return curve;
  }

  const scene::SectionPlane& mPlane;
  glm::dmat4 mLocalFromWorld;
  int mShape;
  glm::vec3 mHalf;
  std::map<Side, std::vector<Side>> mNext;
};

}  // namespace

double shapeDistance(const scene::Cut& cut, glm::dvec3 world) {
  if (cut.shape == scene::CutShape::Everywhere) return -scene::Spare::kEndless;
  glm::dvec3 local(glm::inverse(scene::worldFromCut(cut)) * glm::dvec4(world, 1.0));
  return shared::cutShapeDistance(static_cast<int>(cut.shape), solidEdges(cut.size) * 0.5, local);
}

std::vector<std::vector<glm::dvec2>> shapeContour(const scene::SectionPlane& plane, const scene::Cut& cut) {
  Contour contour(plane, cut);
  double longest = std::max(plane.size.x, plane.size.y) / kCellPixels + 2 * kMarginCells;
  int cells = 1;
  while (cells < longest) cells *= 2;
  contour.march(-kMarginCells, -kMarginCells, cells);
  return contour.curves();
}

}  // namespace velum::session
