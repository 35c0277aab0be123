#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/Image.h"
#include "core/Task.h"
#include "render/Renderer.h"
#include "render/section/SectionImage.h"
#include "scene/SceneFwd.h"
#include "scene/Sections.h"
#include "session/Part.h"

namespace velum::session {

struct Seen;

/// How a picture of a scene is made.
struct PictureOptions {
  glm::ivec2 size{1280, 720};  ///< pixels, 1..65536
  int samples = 0;             ///< how many pictures are averaged; 0: as the scene says
  bool transparent = false;    ///< no background, with alpha
  /// Also writes alpha, depth, normal, structure id and position: in the EXR, or as files of 16 bits beside the
  /// picture. For a scene with inlays also what lies before them, their images, and what lies behind: front over inlay
  /// over behind is the picture. For a scene with a model also the type, and in the EXR mattes by name (Cryptomatte.h).
  bool layers = false;
  double dpi = 0;  ///< pixels an inch in print, which the file says; 0: the file says nothing
  /// Of a sample of colour: 8, or 16, with which an .exr is as fine as the mean of the samples, too.
  int bits = 8;
  /// Of a picture that several machines draw: which of its bands of rows, see PictureParts.h.
  Part part;
};

/// A size as people write it: "1280x720" (pixels), "12x8cm", "120x80mm", "5x3in" (at `dpi`; 0 counts as 300).
/// @throw ArgumentError for anything else, and outside 1..65536 pixels
glm::ivec2 parsePictureSize(const std::string& text, double dpi);

/// The command line that makes a picture of a scene file without a window: the same bytes on the same driver.
/// @param verb  "render", or "film" for the beginning of a film's command line
std::string pictureCommand(const std::filesystem::path& scene, const PictureOptions& options,
                           const std::filesystem::path& output, std::string_view verb = "render");

/// The scene with the options applied: as it is drawn, and as it is saved in the picture. With a resolution the page of
/// its lettering is as wide as the picture's pixels say.
scene::Scene sceneForPicture(const scene::Scene& scene, const PictureOptions& options);

/// Draws a scene in the GL context that is current, membranes with the shapes that the scene holds (see
/// settleMembranes()): the same scene, options and driver give the same samples everywhere.
/// @param known  of a frame of a film: what its lettering knows already, see seenIn(); null: nothing
/// @throw Cancelled, gpu::GpuError
Image drawPicture(render::Renderer& renderer, const scene::Scene& scene, const PictureOptions& options,
                  const gpu::Limits& limits, Progress& progress, const Seen* known = nullptr);

/// The two halves of drawPicture(): the pixels of a part's rows, as an image of all rows has them, and the lettering
/// that is laid over all rows.
Image drawPixels(render::Renderer& renderer, const scene::Scene& scene, const PictureOptions& options,
                 const gpu::Limits& limits, Progress& progress);
Image withLettering(Image pixels, const scene::Scene& scene, const PictureOptions& options, Progress& progress);

/// A section view as a picture: R, G, B, A. Without a graphics context. @throw Cancelled. Any thread.
/// @param known  as of drawPicture()
Image drawSectionPicture(const scene::Scene& scene, scene::SectionKind kind, const PictureOptions& options,
                         Progress& progress, const Seen* known = nullptr);
/// The pixels of a section: R, G, B, A.
Image imageOf(const render::SectionImage& section);

/// @throw InputError where pictures are written in no such format
void expectPictureFormat(const std::filesystem::path& path);
/// Checks before a picture is drawn whether it could be written to a path. @throw InputError for an unknown format, no
/// folder
void expectPictureFile(const std::filesystem::path& path);

/// Writes a picture of drawPicture() or drawSectionPicture(), with the scene inside: colour (and alpha where the
/// background is transparent) to .png, .tif or .exr; layers into the .exr or as pictures beside it ("name.depth.png").
/// @param path  "-" writes PNG to stdout, without layers
/// @return the files written, the picture's first  @throw InputError when the disk refuses
std::vector<std::filesystem::path> savePicture(const Image& image, const scene::Scene& scene,
                                               const PictureOptions& options, const std::filesystem::path& path);

}  // namespace velum::session
