#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "session/picture/Picture.h"

namespace velum::session {

/// Draws one band of rows of a picture that several processes draw, wherever they run, and writes it into the folder
/// PATH.parts; whoever finds all of them there puts the picture together, which is then the same bytes as that of one
/// process, and removes them. Bands that are there already, of the same scene and options, are not drawn again, nor is
/// a picture that is done: a part may be stopped and called again at any time.
/// @param scene  settled  @param kept  the scene that the picture holds  @param options  whose part says which band
/// @param path  as of savePicture(), no drawing
/// @return what there is to say of it, a line each  @throw Cancelled, gpu::GpuError; InputError when the disk refuses
std::vector<std::string> savePicturePart(render::Renderer& renderer, const scene::Scene& scene,
                                         const scene::Scene& kept, const PictureOptions& options,
                                         const gpu::Limits& limits, const std::filesystem::path& path,
                                         Progress& progress);

}  // namespace velum::session
