#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "core/LabelVolume.h"
#include "membrane/forces/Gradients.h"
#include "membrane/forces/Pieces.h"
#include "membrane/forces/PotentialSource.h"
#include "scene/Membrane.h"

namespace velum::membrane {

/// Strengths of rows of voxels for one field: tables made once, then read by all threads.
class StrengthRows {
 public:
  /// @param gradients  needed where the field has a curve over gradients, else null
  /// @param small  pieces protected by value that are too small and get no strength by value; null: there are none
  StrengthRows(PotentialSource source, const Gradients* gradients, const scene::ForceField& field,
               std::shared_ptr<const SmallPieces> small = nullptr);
  /// Writes strengths of voxels (min x .. end x, y, z).
  void fill(int x, int end, int y, int z, float* out) const;
  /// The same of what comes from the volume alone, for voxels of the volume.
  void fillOfVolume(int x, int end, int y, int z, float* out) const;

 private:
  /// One piece of a curve: for from <= value < end the strength is at + slope * value.
  struct Piece {
    double from, end, at, slope;
  };

  void tabulateValues(const std::vector<scene::StrengthPoint>& curve);
  void fillValues(std::ptrdiff_t first, int count, float* out) const;
  void leaveOutSmall(int x, int end, std::size_t row, float* out) const;
  static void selectPiece(const Piece& piece, const double* values, int count, double* strengths);
  /// Strengths by number on a grid of their own.
  struct ByNumber {
    const LabelVolume* grid = nullptr;  ///< null: there are none
    std::vector<float> strengths;       ///< of each number
    glm::dmat4 gridFromVoxel{1.0};
    bool isSameGrid = false;  ///< it lies on the voxels
    glm::ivec3 samples{1};    ///< places along each axis of a voxel whose mean its strength is
  };
  ByNumber byNumber(const Shared<LabelVolume>& grid) const;
  static void addNumbers(const ByNumber& by, int x, int end, int y, int z, float* out);
  /// @param gridFromVoxel  that of `by`, or one that is shifted a little
  static void addNearest(const ByNumber& by, const glm::dmat4& gridFromVoxel, int x, int end, int y, int z, float* out);
  static void addMeans(const ByNumber& by, int x, int end, int y, int z, float* out);

  PotentialSource mSource;
  const Gradients* mGradients = nullptr;
  std::shared_ptr<const SmallPieces> mSmall;
  bool mHasValues = false;
  std::vector<float> mByRaw;   ///< of types with 8 and 16 bits, from the smallest raw value
  std::vector<Piece> mPieces;  ///< of the other types
  std::vector<float> mByCode;  ///< of gradients
  ByNumber mLabels, mTypes;
};

}  // namespace velum::membrane
