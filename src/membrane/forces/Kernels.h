#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/LabelVolume.h"
#include "core/Shared.h"
#include "core/Task.h"
#include "membrane/forces/FieldStrength.h"
#include "scene/Membrane.h"
#include "scene/SceneFwd.h"

namespace velum::membrane {

struct PotentialSource;

/// The kernels of one level of the octree ([IMC] 3.2): the mean strength of each super-voxel of 2^level voxels per
/// axis.
struct KernelGrid {
  glm::ivec3 dims{0};            ///< super-voxels along x (fastest), y, z; the last along an axis may hold fewer voxels
  int level = 0;                 ///< 0..6
  std::vector<float> strengths;  ///< [z][y][x]; 0 where there is no kernel, i.e. below the field's threshold
  glm::dmat4 worldFromKernel{1.0};  ///< kernels, the middles of whole super-voxels, are at integers
  std::size_t count = 0;            ///< how many super-voxels have a kernel
};

/// A box of voxels from `min` to before `end`.
struct VoxelBox {
  glm::ivec3 min{0}, end{0};
  bool operator==(const VoxelBox&) const = default;
};

/// Which voxels of a box are protected, so that the sheet should leave them whole: those with a strength above 0.
struct ProtectedVoxels {
  VoxelBox box;
  std::vector<std::uint8_t> mask;  ///< [z][y][x] of the box: 0, kOfData or kPlaced
  static constexpr std::uint8_t kOfData = 1, kPlaced = 2;
  glm::dmat4 worldFromVoxel{1.0};  ///< of the whole grid: voxel (0, 0, 0) need not lie in the box
  /// [z][y][x]: how strong each voxel is, 1 to kStrongest; empty: all are equally strong
  std::vector<std::uint8_t> weight;
  static constexpr int kStrongest = 64;
};

/// The voxels protected by value that do not count, as they are in pieces that are too small (ForceField::leastPiece).
/// For the whole grid.
struct LeftOut {
  int leastPiece = 1;                  ///< voxels that a piece must have to count; 1: all pieces count
  std::size_t pieces = 0, voxels = 0;  ///< how many pieces are left out, and how many voxels they have
  std::size_t protectedVoxels = 0;     ///< by value, including those left out; not counted where all pieces count
  bool operator==(const LeftOut&) const = default;
};

/// Piecewise linear curve: 0 before the first point and after the last; where two points share a value, the later one
/// holds there. @param curve  ascending
double strengthAt(std::span<const scene::StrengthPoint> curve, double value);

/// The potential field transfer function (PFTF) over a scene's data: strengths by value, by gradient magnitude and by
/// structure and by molecular type, which add up ([IMC] 3.2). A type's strength is that of the voxels that its
/// instances fill, so that a kernel is as strong as the instances are dense; where they are is found when first asked
/// for (a second for the largest models). The grid is the volume's, or that of the labels where there is no volume,
/// with more voxels around it where a model reaches out of it; in a scene with only a model a grid of its own.
///
/// The potential keeps the data and, once asked for, gradient magnitudes (16 bits a voxel), so that an edited curve is
/// evaluated anew in a few tens of milliseconds. Samples of 8 and 16 bits go through a table over the raw values;
/// others are interpolated one by one, in double. Values that are not numbers have no strength. Any thread.
///
/// Pieces protected by value that are too small to count have no strength by value, in all results of this class. Which
/// pieces these are is found once for each curve, over the whole grid (a second for 512^3 voxels).
class Potential {
 public:
  /// Takes the volume's current time step and channel, and the labels, which may lie on another grid.
  explicit Potential(const scene::Scene& scene);
  explicit Potential(PotentialSource source);
  ~Potential();
  Potential(Potential&&) noexcept;
  Potential& operator=(Potential&&) noexcept;

  /// True when this potential was made from the same data, time step and channel.
  bool matches(const scene::Scene& scene) const;
  const PotentialSource& source() const;
  glm::ivec3 dims() const;                    ///< 0 when the scene has no data
  const Shared<LabelVolume>& labels() const;  ///< the scene's; may be empty
  /// The model's types by their numbers, counted from 1, as makeTypeGrid(); empty where there is no model.
  Shared<LabelVolume> types(Progress& progress) const;
  /// False where there is no model, and where it reaches far out of the other data, so that the grid does not hold it.
  bool holdsModel() const;
  const glm::dmat4& worldFromVoxel() const;

  /// The kernels of the field's level, all cores. The mean is taken over strengths, never the strength of a mean.
  /// @throw Cancelled
  KernelGrid computeKernels(const scene::ForceField& field, Progress& progress) const;
  /// Kernels of several levels: the finest is made from the voxels in one pass, coarser ones from the finest, weighted
  /// by the number of voxels that super-voxels hold.
  /// @param finest, coarsest  0..6
  std::vector<KernelGrid> computeLevels(const scene::ForceField& field, int finest, int coarsest,
                                        Progress& progress) const;

  /// Strength of each voxel of a box, [z][y][x]. @throw ArgumentError when the box leaves the grid
  std::vector<float> computeStrengths(const scene::ForceField& field, VoxelBox box, Progress& progress) const;
  /// How strong the protected voxels of a box are, as ProtectedVoxels::weight. @param strongest  the strength whose
  /// weight is kStrongest @throw ArgumentError when the box leaves the grid
  std::vector<std::uint8_t> computeWeights(const scene::ForceField& field, VoxelBox box, double strongest,
                                           Progress& progress) const;
  /// Which voxels of a box are protected. @throw ArgumentError when the box leaves the grid
  ProtectedVoxels computeProtected(const scene::ForceField& field, VoxelBox box, Progress& progress) const;
  /// The pieces that are too small to be protected by value. @throw Cancelled
  LeftOut computeLeftOut(const scene::ForceField& field, Progress& progress) const;

 private:
  struct Data;
  std::unique_ptr<Data> mData;
};

}  // namespace velum::membrane
