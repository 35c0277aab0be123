#include "vector/LineFit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/Assert.h"

namespace velum::vector {

std::optional<glm::dvec2> crossingOf(const Tangent& a, const Tangent& b) {
  double turn = a.direction.x * b.direction.y - a.direction.y * b.direction.x;
  if (std::abs(turn) < 0.035) return {};
  glm::dvec2 way = b.place - a.place;
  return a.place + a.direction * ((way.x * b.direction.y - way.y * b.direction.x) / turn);
}

LineFits::LineFits(std::span<const glm::dvec2> points) : mPoints(points), mSums(points.size() + 1) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    glm::dvec2 p = points[i] - points.front();  // small numbers, so that squares are exact enough
    const Sums& s = mSums[i];
    mSums[i + 1] = {s.x + p.x, s.y + p.y, s.xx + p.x * p.x, s.xy + p.x * p.y, s.yy + p.y * p.y};
  }
}

FittedLine LineFits::line(int first, int end) const {
  VELUM_ASSERT(first >= 0 && end > first && end <= int(mPoints.size()), "a line goes through points");
  const Sums &a = mSums[std::size_t(first)], &b = mSums[std::size_t(end)];
  double count = end - first;
  glm::dvec2 mean((b.x - a.x) / count, (b.y - a.y) / count);
  double xx = (b.xx - a.xx) - count * mean.x * mean.x;
  double xy = (b.xy - a.xy) - count * mean.x * mean.y;
  double yy = (b.yy - a.yy) - count * mean.y * mean.y;
  double along = 0.5 * std::atan2(2.0 * xy, xx - yy);
  glm::dvec2 direction(std::cos(along), std::sin(along));
  glm::dvec2 way = mPoints[std::size_t(end - 1)] - mPoints[std::size_t(first)];
  if (glm::dot(direction, way) < 0.0) direction = -direction;
  double across =
      xx * direction.y * direction.y - 2.0 * xy * direction.x * direction.y + yy * direction.x * direction.x;
  return {{mean + mPoints.front(), direction}, std::max(0.0, across), end - first};
}

bool solveEquations(std::span<double> matrix, std::span<double> right) {
  std::size_t n = right.size();
  for (std::size_t column = 0; column < n; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column + 1; row < n; ++row)
      if (std::abs(matrix[row * n + column]) > std::abs(matrix[pivot * n + column])) pivot = row;
    if (std::abs(matrix[pivot * n + column]) < 1e-12) return false;
    for (std::size_t i = 0; i < n; ++i) std::swap(matrix[pivot * n + i], matrix[column * n + i]);
    std::swap(right[pivot], right[column]);
    for (std::size_t row = column + 1; row < n; ++row) {
      double share = matrix[row * n + column] / matrix[column * n + column];
      for (std::size_t i = column; i < n; ++i) matrix[row * n + i] -= share * matrix[column * n + i];
      right[row] -= share * right[column];
    }
  }
  for (std::size_t row = n; row-- > 0;) {
    for (std::size_t i = row + 1; i < n; ++i) right[row] -= matrix[row * n + i] * right[i];
    right[row] /= matrix[row * n + row];
  }
  return true;
}

std::optional<LocalCurve> fitLocalCurve(std::span<const glm::dvec2> points, const Tangent& about, int degree) {
  auto terms = std::size_t(degree + 1);
  if (points.size() < terms) return {};
  double reach = 1e-9;
  for (glm::dvec2 point : points) reach = std::max(reach, std::abs(alongOf(about, point)));
  std::array<double, 16> matrix{};
  std::array<double, 4> answer{};
  auto powersOf = [](double x) { return std::array<double, 4>{1.0, x, x * x, x * x * x}; };
  for (glm::dvec2 point : points) {
    auto powers = powersOf(alongOf(about, point) / reach);
    double y = offsetOf(about, point);
    for (std::size_t i = 0; i < terms; ++i) {
      for (std::size_t j = 0; j < terms; ++j) matrix[i * terms + j] += powers[i] * powers[j];
      answer[i] += powers[i] * y;
    }
  }
  if (!solveEquations(std::span(matrix).first(terms * terms), std::span(answer).first(terms))) return {};
  auto slopeAt = [&](double x) { return (answer[1] + x * (2.0 * answer[2] + x * 3.0 * answer[3])) / reach; };
  LocalCurve curve;
  for (glm::dvec2 point : points) {
    double x = alongOf(about, point) / reach;
    auto powers = powersOf(x);
    double y = offsetOf(about, point);
    for (std::size_t i = 0; i < terms; ++i) y -= answer[i] * powers[i];
    double slope = slopeAt(x);
    double square = y * y / (1.0 + slope * slope);
    curve.meanSquare += square / double(points.size());
    curve.largest = std::max(curve.largest, std::sqrt(square));
  }
  glm::dvec2 across(-about.direction.y, about.direction.x);
  curve.tangent = {about.place + answer[0] * across, glm::normalize(about.direction + slopeAt(0.0) * across)};
  curve.bend = std::abs(std::atan(slopeAt(alongOf(about, points.back()) / reach)) -
                        std::atan(slopeAt(alongOf(about, points.front()) / reach)));
  return curve;
}

}  // namespace velum::vector
