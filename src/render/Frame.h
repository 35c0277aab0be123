#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <memory>

#include "membrane/sheet/Sheet.h"
#include "scene/Scene.h"

namespace velum::render {

/// A sheet as a solver has it on the GPU, at one moment.
struct FrameSheet {
  std::shared_ptr<const membrane::Sheet> sheet;
  std::uint64_t revision = 0;  ///< Of the sheet: frames that show it at different moments differ.
  bool operator==(const FrameSheet&) const = default;
};

/// Which parts of a scene with inlays (scene::MembraneUse::Inlay) are drawn, for pictures that are put together
/// elsewhere: front over inlay over behind is the picture. Of scenes without inlays all of it is drawn. Not for maxima.
struct InlayParts {
  bool front = true;   ///< what lies before the image of the first inlay on a ray, and where there is none
  bool inlay = true;   ///< the images
  bool behind = true;  ///< what lies behind the first; surfaces of meshes
  bool operator==(const InlayParts&) const = default;
};

/// What is to be drawn. A value: the same frame gives the same picture, and a changed one starts it anew.
struct Frame {
  scene::Scene scene;
  glm::ivec2 pictureSize{0};   ///< The whole picture, pixels.
  glm::ivec2 windowOrigin{0};  ///< Top left corner of the part that is drawn, pixels of the whole.
  glm::ivec2 windowSize{0};    ///< Size of that part; {0,0}: all of it.
  double stepFactor = 1.0;     ///< Coarse pictures take longer steps, >= 1.
  /// A picture at once, for while something moves: shadows and occlusion as they stand in the last full frame of the
  /// same material, or none; a smaller copy of a volume that is not on the GPU yet.
  bool isPreview = false;
  /// Of enabled membranes, by the id of the cut. One that is missing, empty, or made for a frame of another size is
  /// drawn as `Cut::membrane` says, or flat.
  std::map<int, FrameSheet> sheets;
  InlayParts parts;
  bool marksOverlaps = false;    ///< colours what the spares of joined cuts share ([ACS] fig. 6), for who edits them
  bool countsInstances = false;  ///< Renderer::bits() is wanted of the model's instances
  bool operator==(const Frame&) const = default;
};

}  // namespace velum::render
