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

/// The widest Gaussian, in voxels along an axis: a wider one is taken as that wide.
constexpr double kWidestSmoothing = 5.0;

/// Gives each voxel to the structure whose smoothed shape has the largest share of it, among those that are named and
/// what has no label; all other structures stay as they are, and what they fill counts for nobody. The share is g
/// + 2.41 (g - h), where g is the Gaussian of a shape and h the Gaussian of g, so that what is round does not shrink.
/// What is thinner than the Gaussian stays: a voxel keeps its structure where the share is at least 0.85 of the largest
/// nearby. Bricks without a border of a named structure stay the same ones.
/// @param smoothings  ascending by id; no id twice
/// @throw ArgumentError where a deviation is not above 0; Cancelled. Any thread.
/// @note O(voxels near borders of named structures x width of the Gaussian x structures that meet there).
LabelVolume smoothLabels(const LabelVolume& labels, std::span<const ShapeSmoothing> smoothings, Progress& progress);

/// A structure that is made of blocks rather than of voxels.
struct BlockShape {
  std::uint16_t id = 0;
  glm::dvec3 size{1.0};  ///< of its blocks, in voxels; 1 along axes with steps of single voxels
};

/// The structures with steps of more than 1.4 voxels along at least two axes, as labels have that were brought onto a
/// finer grid by the nearest voxel. Blocks of structures may differ, and their size needs not be a whole number: then
/// steps are of the whole numbers around it. Looked at is where structures border on what has no label; those with
/// fewer than eight steps along an axis have none there.
/// @return ascending by id. Any thread. O(voxels of the bricks that are not uniform).
std::vector<BlockShape> findBlocks(const LabelVolume& labels);

}  // namespace velum
