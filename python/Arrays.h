#pragma once
#include <pybind11/numpy.h>

#include <array>
#include <map>
#include <optional>
#include <string>

#include "core/Image.h"
#include "core/LabelVolume.h"
#include "core/Volume.h"

/// Arrays of numpy as data, and data as arrays. All functions want Python's lock. Arrays of voxels are
/// [z][y][x], whatever their strides; with more axes [z][y][x][channel] and [time step][z][y][x][channel].
namespace velum::python {

/// Where voxels are.
struct Place {
  glm::dmat4 worldFromVoxel{1.0};
  LengthUnit lengthUnit = LengthUnit::Millimetre;
};
/// @param affine  a matrix of 4 x 4, row by row, whose last row is 0 0 0 1  @param unit  of its lengths, by any name
/// that files have for one. Angstrom stay angstrom, all else becomes millimetres, as of files.
/// @throw ArgumentError when the matrix is none, or is singular, and for other units
Place placeOf(const pybind11::array_t<double>& affine, const std::string& unit);
pybind11::array_t<double> arrayOf(const glm::dmat4& affine);

/// What an array does not say of a volume.
struct VolumeFacts {
  Place place;
  std::string unit, name;
  Modality modality = Modality::Unknown;
  bool isColor = false;
  double timeStepSeconds = 0.0;
};

/// A volume over the memory of an array, which it keeps and which cannot be written to from now on; or of a copy, from
/// whatever strides, as the type that holds the voxels: bool becomes uint8, float16 becomes float32. A copy is made
/// where the array's samples do not lie as a volume's do, or where others could still write to them. The values' range
/// is found without Python's lock.
/// @param copy  true: it is copied in any case  @throw ArgumentError for other types and shapes, and where false
/// forbids a copy that is needed
Volume volumeOf(const pybind11::array& array, std::optional<bool> copy, const VolumeFacts& facts);
/// The samples of a volume as they are, not copied and not to be written to.
pybind11::array arrayOf(const Shared<Volume>& volume);

/// What an array does not say of labels.
struct LabelFacts {
  Place place;
  std::map<int, std::string> names;
  std::map<int, std::array<float, 3>> colors;  ///< sRGB, 0..1
  std::string name;
};
/// Whole numbers of any type as labels, which are held compressed, and never over an array's memory. @throw
/// ArgumentError for other types and shapes, and ids beyond 65535
LabelVolume labelsOf(const pybind11::array& array, const LabelFacts& facts);
/// A copy of the ids, uint16.
pybind11::array arrayOf(const LabelVolume& labels);

/// A picture as [row][column][channel], float32 as it is; or as the bytes that 8-bit files have.
pybind11::array arrayOf(Image image, bool asBytes);

}  // namespace velum::python
