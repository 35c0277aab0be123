#pragma once
#include "io/phantoms/Phantom.h"

/// Trees of tubes that fill a region: vessels, bronchi.
namespace velum::io::phantom {

struct TreeNode {
  Vec position;
  float radius = 1.0f;
  int parent = -1;  ///< Index of the node before it; -1 for the root. Always smaller than its own index.
};
using Tree = std::vector<TreeNode>;

struct TreeOptions {
  Vec root{0.0f};
  Vec direction{0.0f, 0.0f, 1.0f};  ///< Direction of the trunk at the root, unit.
  float rootRadiusMm = 5.0f;
  float leastRadiusMm = 0.5f;  ///< Branches that would be thinner get this radius.
  float reach = 0.42f;         ///< How far a branch runs towards the centre of the region that it feeds.
  float wobble = 0.06f;        ///< Sideways sway, as a part of the branch's length.
  std::uint64_t seed = 1;
};

/// Points inside a region: one jittered point for each cell of a lattice.
/// @param pitchMm  width of a lattice cell
std::vector<Vec> scatter(const Box& box, float pitchMm, const Distance& region, float marginMm, std::uint64_t seed);

/// A tree that reaches every target: the targets are halved again and again, and a branch runs towards the middle of
/// each half, as a lung's airways do. Radii follow Murray's law: r^3 is shared in proportion to the targets fed.
Tree growTree(std::vector<Vec> targets, const TreeOptions& options);

/// Moves the nodes of `tree`, except its root, until its tubes are `gapMm` away from those of `fixed`, where that is
/// possible.
void pushApart(Tree& tree, const Tree& fixed, float gapMm);

std::vector<Segment> segments(const Tree& tree);

}  // namespace velum::io::phantom
