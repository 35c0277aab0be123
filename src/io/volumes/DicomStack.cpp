#include "io/volumes/DicomStack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/SayCount.h"
#include "io/read/Refuse.h"

namespace velum::io {

namespace {

/// Positions nearer than this are one place: scanners write three decimals.
constexpr double kSamePlaceMm = 0.01;
/// Distances that differ by less than this share are even: rounding of the file, not a missing plane.
constexpr double kEvenShare = 0.02;
/// Slices that are farther apart than so many steps say nothing of what lies between them, if it is not as near as the
/// one, or farther than the other.
constexpr double kMostSteps = 4.5, kNearMm = 10.0, kFarMm = 25.0;
/// Planes of the grid that a few slices far apart are spread over, at most.
constexpr double kMostSpread = 1024.0;
/// Tilt below this is rounding of the direction cosines.
constexpr double kTiltDeg = 0.1;

using Group = std::vector<std::size_t>;  // frames at one place

glm::dvec3 normalOf(const DicomFrame& f) { return glm::normalize(glm::cross(f.rowDirection, f.columnDirection)); }

std::vector<Group> groupByPlace(const std::vector<DicomFrame>& frames) {
  glm::dvec3 normal = normalOf(frames[0]);
  std::vector<std::size_t> order(frames.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<double> distance;
  for (const DicomFrame& f : frames) distance.push_back(glm::dot(f.position, normal));
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return distance[a] < distance[b]; });
  std::vector<Group> groups;
  double last = 0;
  for (std::size_t i : order) {
    if (groups.empty() || distance[i] - last > kSamePlaceMm) groups.emplace_back();
    groups.back().push_back(i);
    last = distance[i];
  }
  return groups;
}

/// Without places: one plane per frame, as numbered, else as the files came.
std::vector<Group> groupByNumber(const std::vector<DicomFrame>& frames) {
  std::vector<std::size_t> order(frames.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
    return std::pair(frames[a].instance, frames[a].index) < std::pair(frames[b].instance, frames[b].index);
  });
  std::vector<Group> groups;
  for (std::size_t i : order) groups.push_back({i});
  return groups;
}

/// Time steps per place, when all places have equally many and a key tells them apart; else 1. Sorts each group.
int timeStepsOf(std::vector<Group>& groups, const std::vector<DicomFrame>& frames) {
  std::size_t count = groups[0].size();
  bool distinct = count > 1;
  for (Group& group : groups) {
    distinct = distinct && group.size() == count;
    std::stable_sort(group.begin(), group.end(), [&](auto a, auto b) {
      return std::pair(frames[a].timeKey, frames[a].instance) < std::pair(frames[b].timeKey, frames[b].instance);
    });
    for (std::size_t i = 1; i < group.size(); ++i)
      distinct = distinct && frames[group[i]].timeKey != frames[group[i - 1]].timeKey;
  }
  return distinct ? int(count) : 1;
}

/// The one of a group of repeats that is kept: the file that the user named, else the first.
std::size_t pick(const Group& group, const std::vector<DicomFrame>& frames, int preferred) {
  for (std::size_t i : group)
    if (int(frames[i].file) == preferred) return i;
  return *std::min_element(group.begin(), group.end());
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// Planes of the grid that are farther than half a step from any that is there.
std::vector<glm::ivec2> gapsOf(const std::vector<double>& positions, int gridPlanes) {
  std::vector<glm::ivec2> gaps;
  std::size_t next = 0;
  for (int plane = 0; plane < gridPlanes; ++plane) {
    while (next + 1 < positions.size() && positions[next + 1] <= plane) ++next;
    double before = plane - positions[next];
    double after = next + 1 < positions.size() ? positions[next + 1] - plane : before;
    if (std::min(std::abs(before), std::abs(after)) < 0.5) continue;
    bool goesOn = !gaps.empty() && gaps.back()[0] + gaps.back()[1] == plane;
    goesOn ? void(++gaps.back()[1]) : gaps.push_back({plane, 1});
  }
  return gaps;
}

/// How far apart the planes of the grid are: as most slices are; where most are too far apart to be a volume, as thick
/// as one of them is.
double stepOf(const std::vector<double>& gaps, double thickness) {
  double step = median(gaps), length = std::accumulate(gaps.begin(), gaps.end(), 0.0);
  if (step <= kFarMm) return step;
  double thin = thickness > 0 && thickness < kFarMm ? thickness : 0.25 * kFarMm;
  return std::max(thin, length / kMostSpread);
}

std::string sayUneven(const DicomStack& stack, glm::dvec2 apart, std::size_t count, double step) {
  int between = stack.gridPlanes - int(count), empty = 0;
  for (std::size_t i = 1; i < stack.positions.size(); ++i)
    if (double wide = stack.positions[i] - stack.positions[i - 1]; wide > stack.farthest) empty += int(wide + 0.5) - 1;
  std::string text = fmt::format(
      "distances between slices run from {:.3f} to {:.3f} mm ({} slices); resampled onto {} slices {:.3f} mm apart",
      apart[0], apart[1], count, stack.gridPlanes, step);
  if (between > empty) text += fmt::format(", {} missing ones filled in linearly", between - empty);
  if (empty > 0)
    text += fmt::format(", {} left empty where slices are more than {:.0f} mm apart", empty, stack.farthest * step);
  return text;
}

/// Fills positions, gaps and gridPlanes. @return the step of the even grid along the normal, mm
double layOnGrid(DicomStack& stack, const std::vector<double>& distances, double thickness, const Path& path) {
  std::size_t n = distances.size();
  std::vector<double> gaps;
  for (std::size_t i = 1; i < n; ++i) gaps.push_back(distances[i] - distances[i - 1]);
  double step = stepOf(gaps, thickness);
  auto [smallest, largest] = std::minmax_element(gaps.begin(), gaps.end());
  double tolerance = std::max(kEvenShare * step, 2 * kSamePlaceMm);
  stack.isEven = *largest - step <= tolerance && step - *smallest <= tolerance;
  double length = distances.back() - distances.front();
  if (stack.isEven) {
    for (std::size_t i = 0; i < n; ++i) stack.positions.push_back(double(i));
    stack.gridPlanes = int(n);
    return length / double(n - 1);
  }
  double planes = std::round(length / step) + 1;
  if (planes > std::max(2.0 * double(n), kMostSpread + 1.0))
    refuse(path, fmt::format("planes are missing: {} of {} are there, {:.3f} mm apart", n, planes, step));
  stack.gridPlanes = std::max(2, int(planes));
  step = length / double(stack.gridPlanes - 1);
  stack.farthest = std::max(1.5, std::min(kFarMm, std::max(kMostSteps * step, kNearMm)) / step);
  for (double d : distances) stack.positions.push_back((d - distances.front()) / step);
  stack.gaps = gapsOf(stack.positions, stack.gridPlanes);
  stack.warnings.push_back(sayUneven(stack, {*smallest, *largest}, n, step));
  return step;
}

void placeStack(DicomStack& stack, const std::vector<const DicomFrame*>& planes, const Path& path) {
  const DicomFrame& first = *planes.front();
  glm::dvec3 normal = normalOf(first);
  glm::dvec2 spacing = first.spacing;
  stack.isSpacingKnown = spacing.x > 0 && spacing.y > 0;
  if (!stack.isSpacingKnown) spacing = glm::dvec2(1.0);
  double along = first.sliceSpacing > 0 ? first.sliceSpacing : 1.0;
  glm::dvec3 step = normal * along;
  if (planes.size() > 1 && first.hasPlace) {
    std::vector<double> distances;
    for (const DicomFrame* f : planes) distances.push_back(glm::dot(f->position, normal));
    along = layOnGrid(stack, distances, first.sliceSpacing, path);
    glm::dvec3 way = planes.back()->position - first.position;
    step = way / double(stack.gridPlanes - 1);
    double tilt = glm::degrees(std::acos(std::clamp(glm::dot(glm::normalize(step), normal), -1.0, 1.0)));
    if (tilt > kTiltDeg)
      stack.warnings.push_back(fmt::format(
          "the slices are stacked {:.1f} degrees off their normal (gantry tilt); the volume is sheared accordingly",
          tilt));
  } else {
    for (std::size_t i = 0; i < planes.size(); ++i) stack.positions.push_back(double(i));
    stack.gridPlanes = int(planes.size());
    if (planes.size() > 1) {
      stack.isSpacingKnown = stack.isSpacingKnown && first.sliceSpacing > 0;
      stack.warnings.push_back(
          fmt::format("the slices have no position; they are stacked by number, {:.6g} mm apart", along));
    }
  }
  stack.isOrientationKnown = first.hasPlace;
  auto& m = stack.worldFromVoxel;
  m[0] = glm::dvec4(first.rowDirection * spacing.x, 0);
  m[1] = glm::dvec4(first.columnDirection * spacing.y, 0);
  m[2] = glm::dvec4(step, 0);
  m[3] = glm::dvec4(first.position, 1);
}

}  // namespace

DicomStack stackFrames(const std::vector<DicomFrame>& frames, int preferred, const Path& path) {
  bool havePlaces = std::all_of(frames.begin(), frames.end(), [](const DicomFrame& f) { return f.hasPlace; });
  auto groups = havePlaces ? groupByPlace(frames) : groupByNumber(frames);
  DicomStack stack;
  stack.planes = int(groups.size());
  stack.timeSteps = timeStepsOf(groups, frames);
  stack.slots.assign(frames.size(), -1);
  std::vector<const DicomFrame*> planes;
  std::size_t dropped = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    std::size_t kept = stack.timeSteps > 1 ? groups[g][0] : pick(groups[g], frames, preferred);
    planes.push_back(&frames[kept]);
    if (stack.timeSteps > 1)
      for (std::size_t t = 0; t < groups[g].size(); ++t) stack.slots[groups[g][t]] = int(t) * stack.planes + int(g);
    else
      stack.slots[kept] = int(g);
    if (stack.timeSteps == 1) dropped += groups[g].size() - 1;
  }
  if (dropped > 0)
    stack.warnings.push_back(sayCount(dropped, "1 image repeats the place of another and was left out",
                                      "{} images repeat the place of another and were left out"));
  // One frame without a place spoils the order by place for all; then none of them has one.
  std::vector<DicomFrame> placeless;
  if (!havePlaces) {
    for (const DicomFrame* f : planes) placeless.push_back(*f);
    for (std::size_t i = 0; i < placeless.size(); ++i) {
      placeless[i].hasPlace = false;
      planes[i] = &placeless[i];
    }
  }
  placeStack(stack, planes, path);
  return stack;
}

}  // namespace velum::io
