#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/Image.h"

namespace velum::session {

/// The layers of a picture of a scene with inlays, from front to back.
inline constexpr const char* kInlayLayers[] = {"front", "inlay", "behind"};

/// The names of a layer's channels: "front.R", ..., "front.A".
std::vector<std::string> colorChannels(const std::string& layer);

/// Writes the layers of a picture as pictures beside it ("name.depth.png"), 16 bits a sample. Alpha, and depth from
/// near (1) to far (a tenth; 0: nothing is there), are in grey; normals go from -1..1 to 0..1; positions lie within the
/// box of what is hit; ids have the colours that structures have by themselves, each surface and each instance of a
/// model a colour of its own; types have theirs; the parts of an inlay have alpha.
/// @param typeColors  of the types of a model; empty: there is no model
/// @param dpi  pixels an inch in print, which the files say; 0: they say nothing  @return the files written
std::vector<std::filesystem::path> writeLayerPictures(const Image& image, const std::vector<glm::vec3>& typeColors,
                                                      double dpi, const std::filesystem::path& output);

}  // namespace velum::session
