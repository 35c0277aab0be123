#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace velum::session {

/// Finds places for rectangles in a picture, so that none covers another.
class FreePlaces {
 public:
  explicit FreePlaces(glm::dvec2 picture) : mPicture(picture) {}

  /// Takes the free place that is nearest to the wanted one, and rather above or below it than beside it.
  /// @param size, wanted  of the rectangle, pixels; its top left corner  @param margin, gap  way to the picture's edge
  /// and to other rectangles, pixels  @return its top left corner; none: there is no such place, and none was taken
  std::optional<glm::dvec2> take(glm::dvec2 size, glm::dvec2 wanted, double margin, double gap);

  /// Takes a rectangle wherever it lies.
  void add(glm::dvec2 low, glm::dvec2 size, double gap) { mTaken.push_back({low, low + size, gap}); }

  /// A rectangle that is taken, and how far others keep away from it.
  struct Taken {
    glm::dvec2 low, high;
    double gap;
  };
  const std::vector<Taken>& taken() const { return mTaken; }

 private:
  bool isFree(glm::dvec2 at, glm::dvec2 size, double margin, double gap) const;

  glm::dvec2 mPicture;
  std::vector<Taken> mTaken;
};

}  // namespace velum::session
