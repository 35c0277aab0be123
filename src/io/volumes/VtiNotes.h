#pragma once

/// Names of our own notes in the FieldData of a .vti. Each note is a number, or a text stored as bytes, as VTK stores
/// texts in a way of its own.
namespace velum::io::vti {

constexpr const char* kScale = "velum.scale";
constexpr const char* kOffset = "velum.offset";
constexpr const char* kOriented = "velum.orientationKnown";
constexpr const char* kSpacing = "velum.spacingKnown";
constexpr const char* kColor = "velum.color";
constexpr const char* kName = "velum.name";
constexpr const char* kUnit = "velum.unit";
constexpr const char* kModality = "velum.modality";
constexpr const char* kLengthUnit = "velum.lengthUnit";  ///< Unit to show lengths in; the file's are millimetres.

}  // namespace velum::io::vti
