#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/SceneFwd.h"
#include "scene/Sections.h"
#include "session/lettering/Legend.h"
#include "session/lettering/Mark.h"

/// What is written over pictures (scene::Lettering): legend, scale bar, time and captions.
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

/// What is to be laid over a picture of so many pixels: dark on a light ground, light on a dark one, each letter on a
/// little of the ground's colour. Sizes go with the picture's rows.
std::vector<Mark> letteringMarks(const scene::Scene& scene, glm::ivec2 size, const TypePixels& pixels);
/// The same for a picture of a section: it has no legend.
std::vector<Mark> letteringMarks(const scene::Scene& scene, scene::SectionKind kind, glm::ivec2 size);

}  // namespace velum::session
