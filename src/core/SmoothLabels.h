#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/LabelVolume.h"
#include "core/Task.h"

namespace velum {

/// How far the shape of one structure is smoothed.
struct ShapeSmoothing {
  std::uint16_t id = 0;
  double deviation = 0.0;  ///< standard deviation of the Gaussian, in the unit of the labels' world; > 0
  bool operator==(const ShapeSmoothing&) const = default;
};

/// The largest standard deviation, in voxels along an axis; larger ones are reduced to it.
constexpr double kWidestSmoothing = 5.0;

/// Smooths the shapes of the structures that `smoothings` names. Each voxel goes to the structure whose smoothed shape
/// has the largest share of the voxel; only the named structures and unlabelled material take part. All other
/// structures stay as they are, and their voxels add to nobody's share. The share is g + 2.41 (g - h), where g is the
/// Gaussian of a shape and h the Gaussian of g, so that round shapes do not shrink. Parts thinner than the Gaussian
/// stay: a voxel keeps its structure where that structure's share is at least 0.85 of the largest nearby. Bricks
/// without a border of a named structure are shared with `labels`.
/// @param smoothings  ascending by id; no id twice
/// @throw ArgumentError where a deviation is not above 0; Cancelled. Any thread.
/// @note O(voxels near borders of named structures x width of the Gaussian x structures that meet there).
LabelVolume smoothLabels(const LabelVolume& labels, std::span<const ShapeSmoothing> smoothings, Progress& progress);

/// A structure that is made of blocks rather than of voxels.
struct BlockShape {
  std::uint16_t id = 0;
  glm::dvec3 size{1.0};  ///< size of the structure's blocks, in voxels; 1 along axes on which its surface has steps of
                         ///< single voxels
};

/// The structures whose surfaces have steps of more than 1.4 voxels along at least two axes, as in labels that were
/// brought onto a finer grid by the nearest voxel. Structures may have blocks of different sizes, and a size need not
/// be a whole number: then the steps alternate between the whole numbers around it. Only borders to unlabelled material
/// are looked at; along an axis with fewer than eight steps a structure counts as having no blocks.
/// @return ascending by id. Any thread. O(voxels of the bricks that are not uniform).
std::vector<BlockShape> findBlocks(const LabelVolume& labels);

}  // namespace velum
