#pragma once
#include <glm/glm.hpp>

#include "velum/gpu/Program.h"
#include "velum/gpu/Texture.h"

namespace velum::render {

/// The light grid: how much key light reaches each place and how open its surroundings are, computed once for a scene
/// and a direction of the light, then looked up once a shaded sample. Cuts and hidden structures count as not there.
/// Cost: grid cells (at most ~96^3 in software), not voxels or pixels; sliced along z.
class LightPass {
 public:
  /// @param defines  the variant of the shaders: LABELS, COLOR, MODE, and MEMBRANES where there are any
  explicit LightPass(gpu::Defines defines);
  /// Cells for a box of the given edges (mm), `longest` along the longest.
  void resize(glm::dvec3 edgesMm, int longest);
  glm::ivec3 size() const { return mSize; }
  double cellMm() const { return mCellMm; }
  /// Layers z0..z1 of what the light has to pass.
  void extinction(int z0, int z1);
  /// @param keyTex  one cell size towards the light in grid texture coordinates; reachCells: occlusion reach;
  ///                keepOpenness: the light alone has turned
  void light(int z0, int z1, glm::vec3 keyTex, glm::vec3 cellTex, double reachCells, bool keepOpenness);
  const gpu::Texture& map() const { return mLight; }

 private:
  gpu::Program mExtinctionProgram, mLightProgram;
  gpu::Texture mExtinction, mLight;
  glm::ivec3 mSize{0};
  double mCellMm = 1;
};

}  // namespace velum::render
