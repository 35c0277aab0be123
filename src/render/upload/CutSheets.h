#pragma once
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <vector>

#include "gpu/Buffer.h"
#include "gpu/Texture.h"
#include "membrane/sheet/SheetIndex.h"
#include "render/Frame.h"
#include "render/SheetIndices.h"
#include "shared/types.h"

namespace velum::render {

/// The enabled membranes of a scene.
std::vector<const scene::Cut*> membranesOf(const scene::Scene& scene);

/// CutData::sheet of each enabled membrane, without its look, by the id of the cut.
using SheetPlans = std::map<int, glm::ivec4>;

/// The live sheet that a frame shows for a membrane; nullptr: the sheet is made as the scene says.
const FrameSheet* liveSheet(const Frame& frame, const scene::Cut& cut);

/// What the sheet of a membrane was made from.
struct SheetSource {
  FrameSheet live;
  scene::SheetShape shape;
  glm::ivec2 particles{0};
  glm::dvec3 size{0.0};
  bool operator==(const SheetSource&) const = default;
};
/// What the sheet of each membrane was made from, by the id of the cut.
using SheetSources = std::map<int, SheetSource>;

/// The sheets of a frame's membranes, one after the other in one buffer, as they were when the frame was prepared: a
/// solver may go on meanwhile. GL thread.
class CutSheets {
 public:
  void prepare(const Frame& frame);
  const SheetPlans& plans() const { return mPlans; }
  const SheetSources& sources() const { return mSources; }
  void bind() const;

 private:
  SheetSources mSources;
  SheetPlans mPlans;
  gpu::Buffer mRows;
  gpu::Texture mTexels;  ///< the rows, as shaders fetch them
};

/// The sheets of a scene's membranes in the processor's memory.
struct CpuSheets {
  std::vector<glm::vec4> rows;
  SheetPlans plans;
  shared::SheetRows view() const { return {rows.data()}; }
};
/// @param sheets  a solver's sheets; sheets that are missing or empty are made as the scene says
CpuSheets makeCpuSheets(const scene::Scene& scene, const SheetIndices& sheets);

}  // namespace velum::render
