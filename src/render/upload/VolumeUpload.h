#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "core/Volume.h"
#include "gpu/Buffer.h"
#include "gpu/Context.h"
#include "gpu/Texture.h"
#include "render/upload/CellGrid.h"
#include "render/upload/PackedTexels.h"
#include "scene/SceneFwd.h"

namespace velum::render {

/// One time step of a volume on the GPU, one channel or all of them mixed, at the best level that fits.
struct GpuVolume {
  gpu::Texture texture;  ///< 3D; where values are packed, the texture of the buffer `packed`.
  gpu::Buffer packed;
  Packing packing = Packing::None;
  gpu::Texture gradient;              ///< Gradients as packGradients() makes them, where there is room.
  double gradientScale = 0;           ///< Length of a full-length gradient texel, texels times 255/127.
  std::vector<glm::vec2> cellRanges;  ///< By cell: smallest and largest texel, with a halo of one voxel.
  gpu::Buffer cellRange;              ///< cellRanges on the GPU.
  CellGrid cells;
  glm::ivec3 dims{0};                      ///< Voxels of the texture.
  glm::dmat4 worldFromTex{1.0};            ///< From texture coordinates 0..1.
  double valueScale = 1, valueOffset = 0;  ///< value = texel * scale + offset, texel as a sampler returns it
  bool isColor = false;                    ///< rgb holds colours, alpha the value
  bool isMixed = false;                    ///< rgb and alpha as MixTable says
  std::string reduction;                   ///< In words for people, where the resolution is reduced.
};

/// Brings a volume to the GPU slab by slab, so that the caller can stop in between.
class VolumeUpload {
 public:
  /// Chooses the level and allocates. @throw gpu::GpuError
  /// @param mostAlong  most texels along the longest side of a quick copy, whose texels are single voxels of the
  /// volume; 0: the best level that fits, whose texels are means where it is reduced
  VolumeUpload(const scene::VolumeLayer& layer, const gpu::Limits& limits, int mostAlong = 0);
  ~VolumeUpload();
  /// Converts and uploads one slab of about 4 MB. @return true when that was the last slab
  bool step();
  double fractionDone() const;
  /// The finished volume; only after step() returned true.
  GpuVolume take();

 private:
  struct Impl;
  std::unique_ptr<Impl> mImpl;
};

}  // namespace velum::render
