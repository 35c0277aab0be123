#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "gpu/Buffer.h"
#include "membrane/forces/PushField.h"
#include "scene/Membrane.h"

namespace velum::membrane {

/// The sheet to be simulated: a rectangle of particles in a frame.
struct SheetSetup {
  glm::ivec2 particles{50};
  glm::dvec3 half{50.0};  ///< half of the rest plane's width and height, and how far the sheet may go along the normal
  scene::Cloth cloth;     ///< Cloth::particles and Cloth::finest are ignored
  bool isAlongNormal = true;  ///< particles move along z only, and so do forces (the sided rule)
  bool operator==(const SheetSetup&) const = default;
};

/// The elastic sheet on the GPU: position based dynamics [PBD] in compute shaders, in the cut's local frame.
///
/// Differs: Jacobi passes that gather per particle instead of Gauss-Seidel, so that the result does not depend on the
/// order of threads; bending by the quadratic model of [BERGOU], whose stiffness is that of dihedral angles near rest
/// and which has no singularity when flat; constraints over strides of 2, 4, ... particles, so that stiffness does not
/// depend on the resolution; the distance that a particle goes in a step is bounded; once a sheet has had time to
/// settle, each step goes only a share of the way, less and less, because the force of [IMC] eq. 3 jumps at the faces
/// of a kernel's box and would keep the sheet trembling for ever. The same setup, field and number of steps give the
/// same places, bit for bit on one driver. A step costs O(particles), whatever the number of kernels. GL thread of the
/// current context.
class Solver {
 public:
  Solver();
  ~Solver();

  /// Begins with another sheet: flat, at rest, without forces or pins. Does nothing where the setup is the same.
  void setSheet(const SheetSetup& setup);
  const SheetSetup& sheet() const { return mSetup; }
  void setField(const PushField& field);
  /// Sets the lowest and highest z of each particle; empty: the whole reach.
  void setRoom(std::span<const glm::vec2> room);
  /// Puts the particles into places, without speed. @param places  frame-local, one a particle; the border does not
  /// move
  void setPlaces(std::span<const glm::vec3> places);
  /// From now on holds these particles in their places; particles held before become free. The border always stays
  /// held.
  void hold(std::span<const HeldParticle> held);

  void step(int count);
  /// How many steps were done since the last change of sheet, forces or places.
  int age() const { return mAge; }
  /// Largest speed of a particle in the last step, length/s. Waits for the GPU.
  double speed() const;
  /// A speed at which the eye sees no motion and the sheet counts as at rest: 1/1000 of the rest plane's mean edge a
  /// second.
  double restSpeed() const;

  /// The particles' places on the GPU: a vec4 each, w is 0 for a particle that is held.
  const gpu::Buffer& places() const { return mPlaces; }
  /// Waits for the GPU.
  std::vector<glm::vec3> readPlaces() const;
  std::vector<glm::vec3> readVelocities() const;

 private:
  struct Programs;

  int count() const { return mSetup.particles.x * mSetup.particles.y; }
  void writeParams();
  void fillStiffness();
  bool isBorder(int particle) const;

  std::unique_ptr<Programs> mPrograms;
  SheetSetup mSetup;
  PushField mField;
  int mAge = 0;
  gpu::Buffer mPlaces, mVelocities, mPing, mPong, mKernels, mPlacedKernels, mRoom, mBend, mRest;
};

}  // namespace velum::membrane
