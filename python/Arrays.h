#pragma once
#include <pybind11/numpy.h>

#include <array>
#include <map>
#include <string>

#include "core/Image.h"
#include "core/LabelVolume.h"
#include "core/Volume.h"

/// Arrays of numpy as data, and data as arrays. All functions want Python's lock. Arrays of voxels are
/// [z][y][x], whatever their strides; with more axes [z][y][x][channel] and [time step][z][y][x][channel].
namespace velum::python {

/// What an array does not say of a volume.
struct VolumeFacts {
  glm::dmat4 worldFromVoxel{1.0};
  LengthUnit lengthUnit = LengthUnit::Millimetre;
  std::string unit, name;
  Modality modality = Modality::Unknown;
  bool isColor = false;
  double timeStepSeconds = 0.0;
};

/// Copies voxels once, from whatever strides, as the type that holds them: bool becomes uint8, float16 becomes float32.
/// The values' range is found without Python's lock. @throw ArgumentError for other types and shapes
Volume volumeOf(const pybind11::array& array, const VolumeFacts& facts);
/// The samples of a volume as they are, not copied and not to be written to.
pybind11::array arrayOf(const Shared<Volume>& volume);

/// What an array does not say of labels.
struct LabelFacts {
  glm::dmat4 worldFromVoxel{1.0};
  LengthUnit lengthUnit = LengthUnit::Millimetre;
  std::map<int, std::string> names;
  std::map<int, std::array<float, 3>> colors;  ///< sRGB, 0..1
  std::string name;
};
/// Whole numbers of any type as labels. @throw ArgumentError for other types and shapes, and ids beyond 65535
LabelVolume labelsOf(const pybind11::array& array, const LabelFacts& facts);
/// A copy of the ids, uint16.
pybind11::array arrayOf(const LabelVolume& labels);

/// A picture as [row][column][channel], float32 as it is; or as the bytes that 8-bit files have.
pybind11::array arrayOf(Image image, bool asBytes);

/// A matrix of 4 x 4, row by row, whose last row is 0 0 0 1. @throw ArgumentError when it is none, or is singular
glm::dmat4 affineOf(const pybind11::array_t<double>& array);
pybind11::array_t<double> arrayOf(const glm::dmat4& affine);

}  // namespace velum::python
