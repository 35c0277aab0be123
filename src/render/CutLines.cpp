// Where cuts cross a slice.
#include <algorithm>
#include <cmath>
#include <optional>

#include "FrameSetup.h"
#include "velum/render/SliceImage.h"

namespace velum::render {

namespace {

/// Points outside the view by more than this are brought nearer: nobody sees them, and painters like small numbers.
constexpr double kMarginPixels = 64.0;

/// A line a x + b y + c = 0 inside the view.
std::vector<glm::dvec2> clippedLine(double a, double b, double c, glm::dvec2 size) {
  double length = std::hypot(a, b);
  if (length < 1e-12) return {};
  glm::dvec2 foot = glm::dvec2(a, b) * (-c / (length * length)), along = glm::dvec2(-b, a) / length;
  double from = -1e12, to = 1e12;
  for (int i = 0; i < 2; ++i) {
    double low = -kMarginPixels - foot[i], high = size[i] + kMarginPixels - foot[i];
    if (std::abs(along[i]) < 1e-12) {
      if (low > 0 || high < 0) return {};
      continue;
    }
    from = std::max(from, std::min(low / along[i], high / along[i]));
    to = std::min(to, std::max(low / along[i], high / along[i]));
  }
  if (from >= to) return {};
  return {foot + along * from, foot + along * to};
}

/// The stretch of the row at height y that lies in a shape, pixels.
std::optional<glm::dvec2> stretchAt(const shared::CutData& cut, const scene::SliceFrame& frame, double y) {
  glm::vec3 start(scene::worldFromSlicePixel(frame, {0.0, y}) - frame.centreMm);
  glm::dvec2 inside(shared::cutInterval(cut, start, glm::vec3(frame.right)));
  if (inside.x > inside.y) return std::nullopt;
  return glm::clamp(inside / frame.mmPerPixel, glm::dvec2(-kMarginPixels), glm::dvec2(frame.size.x + kMarginPixels));
}

/// Every shape is convex: its outline goes down along the right ends of its rows and up along the left ones.
std::vector<glm::dvec2> shapeOutline(const shared::CutData& cut, const scene::SliceFrame& frame) {
  std::vector<glm::dvec2> right, left;
  auto add = [&](double y, glm::dvec2 x) {
    left.emplace_back(x.x, y);
    right.emplace_back(x.y, y);
  };
  /// The last row that meets the shape between one that does and one that does not.
  auto end = [&](double with, double without) {
    for (int i = 0; i < 20; ++i) {
      double middle = 0.5 * (with + without);
      (stretchAt(cut, frame, middle) ? with : without) = middle;
    }
    return with;
  };
  double top = -kMarginPixels, bottom = frame.size.y + kMarginPixels;
  bool before = false;
  for (double y = top; y <= bottom; y += 1.0) {
    auto here = stretchAt(cut, frame, y);
    if (here && !before && y > top) {
      double first = end(y, y - 1.0);
      add(first, *stretchAt(cut, frame, first));
    }
    if (!here && before) {
      double last = end(y - 1.0, y);
      add(last, *stretchAt(cut, frame, last));
      break;
    }
    if (here) add(y, *here);
    before = here.has_value();
  }
  right.insert(right.end(), left.rbegin(), left.rend());
  return right;
}

}  // namespace

std::vector<CutLine> cutLines(const scene::Scene& scene, const scene::SliceFrame& frame) {
  std::vector<CutLine> lines;
  std::vector<shared::CutData> cuts = makeCutData(scene, frame.centreMm);
  std::size_t next = 0;
  for (std::size_t i = 0; i < scene.cuts.size(); ++i) {
    const scene::Cut& cut = scene.cuts[i];
    if (!cut.enabled) continue;
    const shared::CutData& data = cuts[next++];
    CutLine line{i, cut.shape != scene::CutShape::Plane, {}};
    if (line.closed) {
      line.points = shapeOutline(data, frame);
    } else {
      glm::dvec3 axis = glm::length(cut.axis) > 1e-12 ? glm::normalize(cut.axis) : glm::dvec3(0, -1, 0);
      double c = glm::dot(axis, scene::worldFromSlicePixel(frame, {0, 0}) - cut.centreMm) / frame.mmPerPixel;
      line.points = clippedLine(glm::dot(axis, frame.right), -glm::dot(axis, frame.up), c, frame.size);
    }
    if (line.points.size() > 1) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace velum::render
