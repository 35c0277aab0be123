#pragma once
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/Mark.h"
#include "session/lettering/FreePlaces.h"
#include "session/lettering/LetteringBlock.h"
#include "session/lettering/LetteringStyle.h"
#include "session/lettering/MarkView.h"
#include "session/lettering/SeenPlaces.h"
#include "session/mark/MarkHands.h"
#include "session/measure/Measure.h"
#include "vector/Letters.h"

namespace velum::session {

/// Draws marks: their lines, and beside them what they measure or say.
class MarkLayout {
 public:
  /// @param measured  by the marks' ids, of those that are not measured at once; where one is missing it has no words
  /// @param seen  where leaders go; a mark that is not in it points at its own place. Outlives this object
  /// @param ground  before which all stands, sRGB  @param places  where words can stand
  /// @param leastEm  of letters, pixels
  MarkLayout(const MarkView& view, const std::map<int, Measured>& measured, const std::vector<SeenPlace>& seen,
             glm::vec3 ground, double leastEm, FreePlaces& places);

  /// Nothing of a mark that is not seen here.
  void add(const scene::Mark& mark);
  std::vector<LetteringBlock> blocks() && { return std::move(mBlocks); }
  const std::vector<PlacedWords>& words() const { return mWords; }

 private:
  struct Words {
    std::vector<std::string> lines;
    glm::dvec2 at{0.0};                     ///< the place that they belong to, pixels
    glm::dvec2 aside{0.0};                  ///< where their middle should rather stand from there: a direction, pixels
    std::optional<glm::dvec2> target = {};  ///< of a leader, pixels; none: there is none
  };
  using Pixels = std::vector<glm::dvec2>;
  void addCrossing(scene::Mark mark, const Measured& measured);
  void addDistance(const scene::Mark& mark, const Pixels& at, const Measured& measured);
  void addAngle(const scene::Mark& mark, const Pixels& at, const Measured& measured);
  void addPath(const scene::Mark& mark, const Pixels& at, const Measured& measured);
  void addArea(const scene::Mark& mark, const Pixels& at, const Measured& measured);
  void addArrow(const scene::Mark& mark, const Pixels& at);
  void addLabel(const scene::Mark& mark, glm::dvec2 at, glm::dvec2 target);
  void addCircle(const scene::Mark& mark, const Measured& measured);
  void addBall(const scene::Mark& mark, const Measured& measured);
  void addBox(const scene::Mark& mark, const Measured& measured);
  void addProfile(const scene::Mark& mark, const Pixels& at, const Measured& measured);
  void addPlot(const scene::Mark& mark, glm::dvec2 at, const Measured& measured);

  void addLine(const Pixels& points, bool isClosed, double fill = 0.0);
  void addOutline(vector::Outline outline, double fill = 0.0);
  /// A stroke across a line's end. @param from  the line's other end
  void addTick(glm::dvec2 end, glm::dvec2 from);
  void addDot(glm::dvec2 at);
  void addWords(const scene::Mark& mark, Words words);
  /// A way over a surface, where it was measured, else straight from point to point.
  Pixels wayOf(const Pixels& at, const Measured& measured) const;
  std::vector<std::string> linesOf(const scene::Mark& mark, const Measured& measured) const;

  const MarkView& mView;
  const std::map<int, Measured>& mMeasured;
  const std::vector<SeenPlace>& mSeen;
  glm::vec3 mGround;
  FreePlaces& mPlaces;
  LetteringStyle mStyle;
  vector::Letters mLetters;
  LetteringBlock mLines;  ///< of the mark that is being added
  vector::Pen mPen;       ///< the same
  std::vector<LetteringBlock> mBlocks;
  std::vector<PlacedWords> mWords;
};

}  // namespace velum::session
