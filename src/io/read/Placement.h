#pragma once
#include "core/Volume.h"
#include "scene/Source.h"

/// Where a volume lies in the world. Lengths in its lengthUnit.
namespace velum::io {

/// A grid along the world's axes, voxel 0 at the origin.
glm::dmat4 gridMatrix(glm::dvec3 spacing, glm::dvec3 origin = glm::dvec3(0.0));

/// Of voxels that can be drawn: between scene::kLeastSpacing and kMostSpacing.
bool isUsableSpacing(double length);

/// Edges of voxels of usable lengths, and far enough from singular to be inverted.
bool isInvertible(const glm::dmat3& columns);

/// Sets worldFromVoxel from columns (lengths per voxel step) and the centre of the first voxel. Columns that are zero,
/// not finite or in one plane are replaced by axes of @p fallbackSpacing (1 where that is not a length), with a
/// warning.
void placeInWorld(Volume& volume, const glm::dmat3& columns, const glm::dvec3& origin,
                  const glm::dvec3& fallbackSpacing);

/// Said where a file has no axes of the patient.
inline constexpr const char* kNoAxes =
    "the file does not say how the body lies in it; axes were taken as right, anterior, superior";

/// Puts a volume whose file says nothing of its place onto the grid of another, and takes back what was said of that.
void placeOn(Volume& volume, const glm::dmat4& worldFromVoxel, LengthUnit unit);

/// Takes the user's spacing where positive, then warns when spacing is still unknown.
void applySpacing(Volume& volume, const scene::Source& source);

}  // namespace velum::io
