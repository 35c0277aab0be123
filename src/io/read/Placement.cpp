#include "io/read/Placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/BrickCache.h"
#include "io/read/FileNames.h"

namespace velum::io {

namespace {
constexpr double kFarthestOrigin = 1e15;  ///< in any unit: beyond it doubles tell no voxels apart

std::string noSpacing(LengthUnit unit) {
  return fmt::format("the file has no voxel spacing, 1 {0} is taken; give it as spacing in {0} (x, y, z)",
                     symbolOf(unit));
}
}  // namespace

bool isUsableSpacing(double length) { return length >= scene::kLeastSpacing && length <= scene::kMostSpacing; }

glm::dmat4 gridMatrix(glm::dvec3 s, glm::dvec3 o) {
  return {{s.x, 0.0, 0.0, 0.0}, {0.0, s.y, 0.0, 0.0}, {0.0, 0.0, s.z, 0.0}, {o.x, o.y, o.z, 1.0}};
}

bool isInvertible(const glm::dmat3& columns) {
  double lengths = glm::length(columns[0]) * glm::length(columns[1]) * glm::length(columns[2]);
  double volume = std::abs(glm::determinant(columns));
  for (int i = 0; i < 3; ++i)
    if (!isUsableSpacing(glm::length(columns[i]))) return false;
  // A millionth of a box's volume: no scanner shears so far, and the inverse is still good to nine digits.
  return volume > 1e-6 * lengths;
}

void placeInWorld(Volume& volume, const glm::dmat3& columns, const glm::dvec3& origin,
                  const glm::dvec3& fallbackSpacing) {
  glm::dmat3 axes = columns;
  if (!isInvertible(axes)) {
    glm::dvec3 spacing;
    for (int i = 0; i < 3; ++i) {
      bool usable = isUsableSpacing(fallbackSpacing[i]);
      spacing[i] = usable ? fallbackSpacing[i] : 1.0;
      if (!usable) volume.isSpacingKnown = false;
    }
    axes = glm::dmat3(spacing.x, 0, 0, 0, spacing.y, 0, 0, 0, spacing.z);
    volume.isOrientationKnown = false;
    volume.warnings.push_back(
        fmt::format("the orientation in the file cannot be used; axes along x, y, z with {} x {} x {} {} were taken",
                    spacing.x, spacing.y, spacing.z, symbolOf(volume.lengthUnit)));
  }
  glm::dvec3 start = origin;
  for (int i = 0; i < 3; ++i)
    if (!(std::abs(start[i]) <= kFarthestOrigin)) {
      start[i] = 0.0;
      volume.warnings.push_back("the origin in the file is not a number of use; 0 was taken");
    }
  volume.worldFromVoxel = glm::dmat4(axes);
  volume.worldFromVoxel[3] = glm::dvec4(start, 1.0);
}

void applySpacing(Volume& volume, const scene::Source& source) {
  glm::dvec3 known = finestSpacing(volume);
  for (int axis = 0; axis < 3; ++axis)
    if (isUsableSpacing(source.spacing[axis]) && known[axis] > 0)
      volume.worldFromVoxel[axis] *= source.spacing[axis] / known[axis];
  if (glm::all(glm::greaterThan(source.spacing, glm::dvec3(0.0)))) volume.isSpacingKnown = true;
  std::string words = noSpacing(volume.lengthUnit);
  bool isSaid = std::find(volume.warnings.begin(), volume.warnings.end(), words) != volume.warnings.end();
  if (!volume.isSpacingKnown && !isSaid) volume.warnings.push_back(words);
}

void completeHead(Volume& volume, const scene::Source& source) {
  applySpacing(volume, source);
  // Most readers have placed it so; the rest take any spacing, and so may the user's be.
  if (!isInvertible(glm::dmat3(volume.worldFromVoxel)))
    placeInWorld(volume, glm::dmat3(volume.worldFromVoxel), volume.worldFromVoxel[3], spacingOf(volume));
  if (volume.name.empty()) volume.name = titleOf(source.path);
}

void placeOn(Volume& volume, const glm::dmat4& worldFromVoxel, LengthUnit unit) {
  std::erase(volume.warnings, noSpacing(volume.lengthUnit));
  std::erase(volume.warnings, kNoAxes);
  volume.worldFromVoxel = worldFromVoxel;
  volume.lengthUnit = unit;
  volume.isSpacingKnown = true;
}

}  // namespace velum::io
