#pragma once
#include "core/Volume.h"
#include "scene/Source.h"

/// Functions that place a volume in the world. Lengths are in the volume's lengthUnit.
namespace velum::io {

/// worldFromVoxel of a grid along the world's axes whose voxel (0, 0, 0) lies at `origin`.
glm::dmat4 gridMatrix(glm::dvec3 spacing, glm::dvec3 origin = glm::dvec3(0.0));

/// True for a spacing of voxels that can be drawn: between scene::kLeastSpacing and kMostSpacing.
bool isUsableSpacing(double length);

/// True when the columns, edges of a voxel, have usable lengths and the matrix is far enough from singular to be
/// inverted.
bool isInvertible(const glm::dmat3& columns);

/// Sets worldFromVoxel from columns (lengths per voxel step) and the centre of the first voxel. Columns that are zero,
/// not finite or in one plane are replaced by axes of @p fallbackSpacing (1 where that is not usable as a length), with
/// a warning.
void placeInWorld(Volume& volume, const glm::dmat3& columns, const glm::dvec3& origin,
                  const glm::dvec3& fallbackSpacing);

/// The warning for a file that does not give the patient's axes.
inline constexpr const char* kNoAxes =
    "the file does not say how the body lies in it; axes were taken as right, anterior, superior";

/// Places a volume whose file does not give its place on the grid of another volume, and removes the warnings about the
/// missing place.
void placeOn(Volume& volume, const glm::dmat4& worldFromVoxel, LengthUnit unit);

/// Uses the user's spacing (Source::spacing) where it is positive, of a streamed volume for the finest level; then
/// warns when the spacing is still unknown.
void applySpacing(Volume& volume, const scene::Source& source);

/// What readers leave to be done when all but the voxels is known: the user's spacing, a place that can be drawn where
/// the file gives none, and a name. Nothing changes when it is done again.
void completeHead(Volume& volume, const scene::Source& source);

}  // namespace velum::io
