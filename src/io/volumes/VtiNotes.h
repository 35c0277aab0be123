#pragma once

/// Our own notes in the FieldData of a .vti, one number each.
namespace velum::io::vti {

constexpr const char* kScale = "velum.scale";
constexpr const char* kOffset = "velum.offset";
constexpr const char* kOriented = "velum.orientationKnown";

}  // namespace velum::io::vti
