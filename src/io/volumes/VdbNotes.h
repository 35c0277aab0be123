#pragma once

/// Names of our own metadata of a grid in a .vdb.
namespace velum::io::vdb {

constexpr const char* kDims = "velum:dims";
constexpr const char* kOriented = "velum:orientationKnown";
constexpr const char* kSpacing = "velum:spacingKnown";
constexpr const char* kUnit = "velum:lengthUnit";
constexpr const char* kValueUnit = "velum:unit";
constexpr const char* kModality = "velum:modality";

}  // namespace velum::io::vdb
