#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "membrane/forces/Forces.h"
#include "membrane/forces/PushField.h"
#include "scene/SheetShape.h"

namespace velum::membrane {

/// Pulls the sheet of the sided rule tight within the room that its corridor leaves: the surface of least area over
/// rows and columns of particles, pulled back to a rest surface, each height between a lowest and a highest (an
/// obstacle problem). Projected over-relaxation over the red and the black particles by turns, on both sides of a
/// lagged weight that makes squared slopes into areas [BRANDT]; first with few rows and columns, at last with all, so
/// that distant particles influence each other. The result has no preferred direction, as the lattice of the least cut
/// has.
///
/// Differs: not in the paper, whose sheet is never refined. The same input gives the same heights, bit for bit, on any
/// machine. O(particles) a sweep; all cores.
class Fairing {
 public:
  struct Input {
    std::vector<float> xs, ys;  ///< places of columns and rows, frame-local, ascending; the outermost are the frame
    HeightOver start;           ///< surface from which the fairing begins
    HeightOver rest;            ///< surface to which the sheet is pulled back; empty: the rest plane
    Corridor corridor;
    double reach = 0.0;       ///< largest |z| of the sheet
    double pullLength = 0.0;  ///< distance beside an obstacle at which the sheet has fallen to a third
    std::function<std::vector<HeldParticle>(glm::ivec2, const std::vector<glm::vec3>&)> holds;  ///< pins
  };
  explicit Fairing(Input input);

  /// Does one sweep over all particles of the present level. @return false when that was the last sweep
  bool sweep();
  scene::SheetShape shape() const;

 private:
  struct Level {
    std::vector<float> xs, ys, height, rest, weight;
    std::vector<glm::vec2> room;
    glm::ivec2 dims() const { return {int(xs.size()), int(ys.size())}; }
    std::size_t at(int x, int y) const { return std::size_t(y) * xs.size() + std::size_t(x); }
  };
  /// A stake and the three particles of the triangle around it, with their shares in its height.
  struct Tie {
    std::uint32_t particle[3];
    float share[3];
    float height;  ///< least height of the sheet there if isBelow, else its largest
    bool isBelow;
  };
  void begin(int stride);
  void tie();
  void passStakes();
  void weigh();
  void relax(int colour, float over);

  Input mInput;
  Level mLevel;
  std::vector<std::vector<Tie>> mTies;  ///< ties of the finest level, by row of cells
  int mStride = 1, mSweep = 0;
};

}  // namespace velum::membrane
