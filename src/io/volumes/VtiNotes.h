#pragma once

/// Our own notes in the FieldData of a .vti: a number each, or a text as bytes, for texts of VTK are stored its own
/// way.
namespace velum::io::vti {

constexpr const char* kScale = "velum.scale";
constexpr const char* kOffset = "velum.offset";
constexpr const char* kOriented = "velum.orientationKnown";
constexpr const char* kSpacing = "velum.spacingKnown";
constexpr const char* kColor = "velum.color";
constexpr const char* kName = "velum.name";
constexpr const char* kUnit = "velum.unit";
constexpr const char* kModality = "velum.modality";
constexpr const char* kLengthUnit = "velum.lengthUnit";  ///< To be shown in; the file's lengths are millimetres.

}  // namespace velum::io::vti
