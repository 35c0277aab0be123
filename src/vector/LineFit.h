#pragma once
#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

namespace velum::vector {

/// A point and the way on from there.
struct Tangent {
  glm::dvec2 place{0.0};
  glm::dvec2 direction{1.0, 0.0};  ///< unit
};

/// A straight line through points: the least squares of distances from it.
struct FittedLine {
  Tangent middle;        ///< mean of the points; from the first to the last
  double squares = 0.0;  ///< sum of the squares of distances from it
  int count = 0;
  double meanSquare() const { return squares / count; }
};
/// Distance from a line, positive to the right of who walks along it, as y is down.
inline double offsetOf(const Tangent& line, glm::dvec2 point) {
  glm::dvec2 way = point - line.place;
  return line.direction.x * way.y - line.direction.y * way.x;
}
inline double alongOf(const Tangent& line, glm::dvec2 point) { return glm::dot(line.direction, point - line.place); }
/// Where two lines cross; nothing where they are parallel within two degrees.
std::optional<glm::dvec2> crossingOf(const Tangent& a, const Tangent& b);

/// Lines through any stretch of points, each in the time of one.
class LineFits {
 public:
  explicit LineFits(std::span<const glm::dvec2> points);
  /// @param first, end  end > first
  FittedLine line(int first, int end) const;

 private:
  struct Sums {
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  };
  std::span<const glm::dvec2> mPoints;
  std::vector<Sums> mSums;
};

/// How points lie about a curve that is a cubic polynomial along a line: least squares.
struct LocalCurve {
  Tangent tangent;          ///< where the curve passes the place about which it was asked
  double meanSquare = 0.0;  ///< of distances from it
  double largest = 0.0;     ///< distance
  double bend = 0.0;        ///< how far it turns from the first point to the last, radians
};
/// @param points  at least degree + 1  @param about  a place on the curve, nearly  @param direction  along it there
/// @param degree  1..3
std::optional<LocalCurve> fitLocalCurve(std::span<const glm::dvec2> points, const Tangent& about, int degree);

/// Solves a few linear equations in place. @param matrix  square, row by row; is lost  @param right  becomes the answer
/// @return false where they have no single answer
bool solveEquations(std::span<double> matrix, std::span<double> right);

}  // namespace velum::vector
