#pragma once
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

namespace velum::membrane {

/// A kernel put in by hand, in the local frame of the cut.
struct PlacedKernel {
  glm::dvec3 centre{0.0};
  double halfWidth = 1.0;
  double push = 0.0;  ///< strength along the normal; its sign says to which side
  double pull = 0.0;  ///< > 0 pushes away from the centre, < 0 pulls to it
  double lift =
      0.0;  ///< raises the rest plane to which the sheet is pulled back, around the centre; along the normal only
};

/// The forces on the sheet: kernels on a regular lattice, prepared for one of the two rules (scene::KernelRule).
struct PushField {
  glm::ivec3 dims{0};                ///< kernels along the lattice's axes, x fastest
  std::vector<glm::vec2> strengths;  ///< push along the normal (signed by side), pull (> 0 away from the kernel)
  glm::dmat4 kernelFromLocal{1.0};   ///< kernels at integers
  double areaOfEffect = 2.0;         ///< half-width, kernels
  std::vector<PlacedKernel> placed;
};

/// A particle that stays where it is put.
struct HeldParticle {
  int particle = 0;
  glm::vec3 place{0.0f};  ///< frame-local
};

/// Mean edge of a frame with these half sizes; the unit of forces is 1/128 of the mean edge.
inline double meanEdge(glm::dvec3 half) { return 2.0 * std::sqrt(half.x * half.y); }

}  // namespace velum::membrane
