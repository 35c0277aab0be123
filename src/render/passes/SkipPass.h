#pragma once
#include <glm/glm.hpp>

#include "velum/gpu/Program.h"
#include "velum/gpu/Texture.h"

namespace velum::render {

/// What the skip map is made from, besides the buffers and tables that are bound.
struct SkipOptions {
  enum class Content { Opacity = 0, Iso = 1, Labels = 2 } content = Content::Opacity;
  bool hasLabels = false;
  glm::uvec2 visible{0};  ///< 64-bit set of visible ids, mod 64
  glm::uvec2 spared{0};   ///< 64-bit set of ids that some cut spares
};

/// The map of empty space: for each cell the Chebyshev distance, in cells, to the nearest cell with content (r) and to
/// the nearest with content that some cut spares (g). Conservative: a cell without content adds nothing to any picture.
/// Cost: cells (at most 64^3) x 4 small passes, whatever the volume's size.
class SkipPass {
 public:
  SkipPass();
  /// Needs the frame block, transfer table and cell buffers bound.
  void run(const SkipOptions& options, glm::ivec3 cells);
  const gpu::Texture& map() const { return mMap[1]; }

 private:
  gpu::Program mOccupancy, mDistance;
  gpu::Texture mMap[2];
};

}  // namespace velum::render
