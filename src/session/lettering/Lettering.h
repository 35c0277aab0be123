#pragma once
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "render/Renderer.h"
#include "render/section/SectionImage.h"
#include "scene/SceneFwd.h"
#include "scene/Sections.h"
#include "session/ViewSpace.h"
#include "session/lettering/Legend.h"
#include "session/lettering/LetteringBlock.h"
#include "session/lettering/NameLayout.h"
#include "session/measure/Measure.h"

/// What is written over pictures (scene::Lettering): legend, scale bar, time, captions and marks.
namespace velum::session {

/// A bar that says how long things are: at the camera's target, in an orthographic picture everywhere.
struct ScaleBar {
  double length = 0.0;  ///< scene units: 1, 2 or 5 by a power of ten
  double pixels = 0.0;  ///< how long the bar is in the picture
  std::string text;     ///< "50 nm"
};
/// The bar for a picture of so many pixels; none where there is nothing, or nobody knows how long a voxel is.
std::optional<ScaleBar> scaleBarOf(const scene::Scene& scene, glm::ivec2 size);
/// The bar for a picture of a section, in which it holds everywhere.
std::optional<ScaleBar> scaleBarOf(const scene::Scene& scene, scene::SectionKind kind, glm::ivec2 size);

/// What is known of a picture that is written over.
struct Seen {
  TypePixels pixels;                 ///< for the legend
  std::map<int, Measured> measured;  ///< by the ids of marks, see measuredMarks()
  SeenNames names;                   ///< see seenNames() and seenPlaces()
  double leastEm = 0.0;              ///< of the letters of marks in a view, pixels
  const std::vector<NamePlace>* namesBefore =
      nullptr;                            ///< where names stood in the frame before; null: a still picture
  const NamesBetween* between = nullptr;  ///< of a film: see NamesBetween
  std::vector<Rectangle> taken = {};      ///< by what a window shows over the picture, pixels: nothing stands there
};
/// What the visible marks of a scene measure, of those that are not measured at once. @param scene  settled: with the
/// shapes of its sheets  @throw as measure(). Any thread.
std::map<int, Measured> measuredMarks(const scene::Scene& scene, Progress& progress);

/// A scene reduced to what measuredMarks() depends on: where it is the same, so is what the marks measure.
scene::Scene measuredScene(scene::Scene scene);

/// Layers of a picture with those from which seenIn() sees what the scene's lettering is about.
render::Layers withLetteringLayers(render::Layers layers, const scene::Scene& scene);
/// What a picture with these layers shows. @param scene  settled  @throw as measuredMarks(). Any thread.
/// @param known  of a frame of a film: what its marks measure, and where its names stand; null: nothing is known
Seen seenIn(const Image& image, const scene::Scene& scene, Progress& progress, const Seen* known = nullptr);
/// The same for a section: names are of the structures that it cuts; leaders of marks go to their own places.
/// @param section  drawn of the scene  @param plane  of the section
Seen seenInSection(const render::SectionImage& section, const scene::SectionPlane& plane, const scene::Scene& scene,
                   Progress& progress, const Seen* known = nullptr);

/// What is to be laid over a picture.
struct LaidLettering {
  std::vector<LetteringBlock> blocks;
  std::vector<NamePlace> names;    ///< where names stand that find their own places
  std::vector<PlacedWords> words;  ///< of marks and names
};
/// Lettering over a picture of so many pixels: dark on a light ground, light on a dark one, each letter on a little of
/// the ground's colour. Sizes go with the picture's rows, or with its page.
LaidLettering layLettering(const scene::Scene& scene, glm::ivec2 size, const Seen& seen);
/// The same for a picture of a section: it has no legend.
LaidLettering layLettering(const scene::Scene& scene, scene::SectionKind kind, glm::ivec2 size, const Seen& seen);
/// The marks and names alone, for a view. @param space  what the pixels of the view mean
LaidLettering layMarks(const scene::Scene& scene, const ViewSpace& space, const Seen& seen);

inline std::vector<LetteringBlock> letteringBlocks(const scene::Scene& scene, glm::ivec2 size, const Seen& seen) {
  return layLettering(scene, size, seen).blocks;
}
inline std::vector<LetteringBlock> letteringBlocks(const scene::Scene& scene, scene::SectionKind kind, glm::ivec2 size,
                                                   const Seen& seen) {
  return layLettering(scene, kind, size, seen).blocks;
}

}  // namespace velum::session
