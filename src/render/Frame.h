#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <memory>

#include "membrane/sheet/Sheet.h"
#include "scene/Scene.h"

namespace velum::render {

/// A solver's sheet on the GPU, as it is at one moment.
struct FrameSheet {
  std::shared_ptr<const membrane::Sheet> sheet;
  std::uint64_t revision = 0;  ///< Of the sheet: makes frames differ that show it at different moments.
  bool operator==(const FrameSheet&) const = default;
};

/// Which parts of a scene with inlays (scene::MembraneUse::Inlay) are drawn, for callers that compose the picture
/// themselves: the whole picture is front over inlay over behind. Ignored for scenes without inlays. Not for maximum
/// projections.
struct InlayParts {
  bool front = true;   ///< material in front of the first inlay's image on a ray, and on rays without an inlay
  bool inlay = true;   ///< the images of the inlays
  bool behind = true;  ///< material behind the first inlay; surfaces of meshes
  bool operator==(const InlayParts&) const = default;
};

/// Everything that a picture to be drawn depends on. A value: equal frames give the same picture, and a changed frame
/// starts the picture anew.
struct Frame {
  scene::Scene scene;
  glm::ivec2 pictureSize{0};   ///< The whole picture, pixels.
  glm::ivec2 windowOrigin{0};  ///< Top left corner of the part that is drawn, pixels of the whole.
  glm::ivec2 windowSize{0};    ///< Size of that part; {0,0}: all of it.
  double stepFactor = 1.0;     ///< Coarse pictures take longer steps, >= 1.
  /// A quick picture, drawn while something moves: shadows and occlusion are those of the last full frame of the same
  /// material, or left out; a volume that is not on the GPU yet is shown by a smaller copy.
  bool isPreview = false;
  /// Sheets of enabled membranes, by the id of the cut. Where a sheet is missing, empty, or made for a frame of another
  /// size, the membrane is drawn as `Cut::membrane` says, or flat.
  std::map<int, FrameSheet> sheets;
  InlayParts parts;
  bool marksOverlaps = false;  ///< colours where spares of joined cuts overlap ([ACS] fig. 6), for editing them
  double brickBytes =
      0;  ///< most of the GPU's memory for bricks of a streamed volume; 0: a quarter of it, 2 GiB at most
  bool saysFaces = false;        ///< rays note on which cut's face they end, for Layers::face; takes a tenth longer
  bool countsInstances = false;  ///< the model's instances are counted, for Renderer::bits()
  bool operator==(const Frame&) const = default;
};

}  // namespace velum::render
