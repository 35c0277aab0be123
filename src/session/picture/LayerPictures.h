#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/Image.h"

namespace velum::session {

/// Layers of a scene with inlays, from front to back.
inline constexpr const char* kInlayLayers[] = {"front", "inlay", "behind"};

/// "front.R", ..., "front.A".
std::vector<std::string> colorChannels(const std::string& layer);

/// Writes the layers of a picture as pictures beside it ("name.depth.png"), 16 bits a sample: alpha, and depth from
/// near (1) to far (a tenth; 0: nothing is there), in grey; normals from -1..1 to 0..1; positions within the box of
/// what is hit; ids in the colours that structures have by themselves, each surface and each instance of a model in one
/// of its own; types in theirs; the parts of an inlay with alpha.
/// @param typeColors  of the types of a model; empty: there is none
/// @param dpi  pixels an inch in print, as the picture says it; 0: nothing is said
void writeLayerPictures(const Image& image, const std::vector<glm::vec3>& typeColors, double dpi,
                        const std::filesystem::path& output);

}  // namespace velum::session
