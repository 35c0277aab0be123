#pragma once

/// Our own metadata of a grid in a .vdb.
namespace velum::io::vdb {

constexpr const char* kDims = "velum:dims";
constexpr const char* kOriented = "velum:orientationKnown";
constexpr const char* kSpacing = "velum:spacingKnown";
constexpr const char* kUnit = "velum:lengthUnit";

}  // namespace velum::io::vdb
