#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/Image.h"
#include "io/images/ImageFile.h"
#include "scene/SceneFwd.h"

/// Mattes by name for programs that put pictures together, as the Cryptomatte specification 1.1.0 says [CRYPTOMATTE]:
/// each pixel holds the hash of the name of what is seen there, and how much of the pixel this covers; the metadata
/// holds the names.
namespace velum::session {

/// MurmurHash3_x86_32 with seed 0 [CRYPTOMATTE].
std::uint32_t cryptoHash(std::string_view name);
/// The bits of a hash as a number, changed so that it is neither infinite, nor NaN, nor denormal.
float cryptoNumber(std::uint32_t hash);

/// A picture with layers, of a scene with a model, with mattes added behind its channels: "CryptoType00.r/g/b/a" for
/// types, named by their paths, and "CryptoInstance00.r/g/b/a" for instances, named "PATH 17" by their numbers in the
/// model, over all copies. Of a crowd (scene::isCrowd()) instances are its copies, "copy 17".
///
/// Layers are those of the first sample, so one name covers a pixel: rank 0 has coverage 1, rank 1 is empty. Where no
/// instance is in front both are 0.
/// @param image  with the channels "type" and "instance"
/// @param attributes  gets name, hash, conversion and manifest of each matte
Image withMattes(const Image& image, const scene::Scene& scene, std::vector<io::ImageAttribute>& attributes);

}  // namespace velum::session
