#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "model/FocusRows.h"
#include "render/Frame.h"
#include "render/upload/CutSheets.h"
#include "render/upload/VolumeUpload.h"
#include "shared/cut.h"
#include "shared/frame.h"
#include "shared/instance.h"

namespace velum::render {

/// The grid of a frame's data, whether a volume or labels alone.
struct FrameGrid {
  glm::ivec3 dims{1};
  CellGrid cells;
  glm::dmat4 worldFromTex{1.0};
  double valueScale = 1, valueOffset = 0;
  double gradientScale = 0;        ///< As GpuVolume::gradientScale.
  glm::ivec3 labelDims{0};         ///< Voxels of the labels as they are drawn,
  glm::dmat4 worldFromLabel{1.0};  ///< and where they lie; nothing where none are drawn.
};

/// Length of the diagonal of the data's box.
double diameterOf(const FrameGrid& grid);

/// The origin of the scene frame: scene frame = world - origin, so that floats are precise enough for data far from the
/// world's origin.
glm::dvec3 sceneOrigin(const FrameGrid& grid);

/// The rays of a camera's picture, scene frame.
struct EyeRays {
  glm::dvec3 eye;        ///< orthographic: a point in front of everything
  glm::dvec3 right, up;  ///< from the middle of the picture to its edges, at distance 1 (orthographic: lengths)
  glm::dvec3 forward;    ///< unit
  bool isOrthographic = false;
};
/// @param aspect  width by height  @param radius  of a sphere about the data
EyeRays makeEyeRays(const scene::Camera& camera, double aspect, glm::dvec3 origin, double radius);

/// The view in which a focus is kept visible: the picture's, or the view to which the focus is locked. @param aspect
/// the picture's
shared::FocusView makeFocusView(const scene::Scene& scene, const model::FocusRow& row, double aspect, glm::dvec3 origin,
                                double radius);

/// Radius of a sphere about the data: half the diagonal of its box, or more.
double sceneRadius(const FrameGrid& grid);

/// Moves the rays of sample n within their pixel and along themselves: the [R2] sequence and the golden ratio.
void setSample(shared::FrameParams& params, const Frame& frame, int sample);

/// The point at a distance along the ray of sample 0 of a pixel of the whole picture; scene frame.
glm::vec3 pointOnRay(const shared::FrameParams& params, glm::ivec2 pixel, float distance);

/// The part of the window that a grid's box can cover: x, y of its corner, width, height; may be empty.
glm::ivec4 coveredRect(const shared::FrameParams& params, const Frame& frame);
/// The same of a box in the grid. @param low, high  its corners, texture coordinates
glm::ivec4 rectOfBox(const shared::FrameParams& params, const Frame& frame, glm::vec3 low, glm::vec3 high);

/// The enabled cuts as the shaders read them, in the scene frame.
/// @param sheetScale  factor that turns lengths in the rows of sheets into the scene frame's unit
std::vector<shared::CutData> makeCutData(const scene::Scene& scene, glm::dvec3 origin, const SheetPlans& sheets,
                                         double sheetScale = 1.0);

/// Colour and opacity by label id, [largest id + 1]; row 0 unused.
std::vector<shared::StructureRow> makeStructureRows(const scene::LabelLayer& labels);

}  // namespace velum::render
