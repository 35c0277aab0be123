#pragma once
#include "io/looks/TransferFile.h"

/// Conversion between the volume properties of 3D Slicer, in text and JSON, and our transfer functions.
namespace velum::io {

/// Reads the old form: nine lines (interpolation, shade, diffuse, ambient, specular, power; then, each led by how many
/// numbers follow, pairs of opacity, pairs of gradient opacity, quadruples of colour).
TransferFile parseSlicerText(std::string_view text);

/// Reads the new form, schema volume-property-schema-v1.0.0: the first component of the first property. Bent segments
/// (midpoint, sharpness) become short straight ones.
TransferFile parseSlicerJson(std::string_view text);

/// @throw InputError when a line would be longer than Slicer reads
TransferText slicerText(const scene::TransferFunction& transfer, const scene::Lighting& lighting);
TransferText slicerJson(const scene::TransferFunction& transfer, const scene::Lighting& lighting);

}  // namespace velum::io
