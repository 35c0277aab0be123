#pragma once
#include <filesystem>
#include <glm/glm.hpp>

#include "velum/core/Image.h"
#include "velum/core/Task.h"
#include "velum/render/Renderer.h"
#include "velum/scene/Scene.h"

namespace velum::session {

/// What picture to make of a scene.
struct PictureOptions {
  glm::ivec2 size{1280, 720};  ///< pixels, 1..65536
  int samples = 0;             ///< pictures that are averaged; 0: as the scene says
  bool transparent = false;    ///< no background, with alpha
  bool layers = false;         ///< also alpha, depth, normal, structure id, position: in the EXR, or as files beside
};

/// The scene as it is drawn, and as it rides in the picture: with the options applied.
scene::Scene sceneForPicture(const scene::Scene& scene, const PictureOptions& options);

/// Draws it on the context that is current: the same scene, options and driver give the same samples everywhere.
/// @throw Cancelled, gpu::GpuError
Image drawPicture(render::Renderer& renderer, const scene::Scene& scene, const PictureOptions& options,
                  const gpu::Limits& limits, Progress& progress);

/// A slice view as a picture: R, G, B, A. Without a graphics context. Any thread.
Image drawSlicePicture(const scene::Scene& scene, scene::SliceKind kind, const PictureOptions& options);

/// Writes what drawPicture or drawSlicePicture gave, with the scene inside: colour (and alpha where the background is
/// transparent) to .png, .tif or .exr; layers into the .exr or as pictures beside ("name.depth.png").
/// @param path  "-" writes PNG to stdout, without layers
/// @throw InputError when the disk refuses
void savePicture(const Image& image, const scene::Scene& scene, const PictureOptions& options,
                 const std::filesystem::path& path);

/// Both, on a headless context of its own. Any thread that has no current context of ours.
void renderPictureFile(const scene::Scene& scene, const PictureOptions& options, const std::filesystem::path& path,
                       Progress& progress);

}  // namespace velum::session
