#pragma once
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/Volume.h"
#include "gpu/Buffer.h"
#include "gpu/Context.h"
#include "gpu/Texture.h"
#include "render/upload/CellGrid.h"
#include "render/upload/PackedTexels.h"
#include "render/upload/VolumeTexels.h"
#include "scene/SceneFwd.h"

namespace velum::render {

/// Where the pages of a streamed volume lie in its texture coordinates (shaders/common/bricks.glsl).
struct PagePlace {
  glm::ivec3 grid{0};                  ///< Pages.
  std::size_t firstRow = 0;            ///< Where they begin in their table, rows of four words.
  glm::dvec3 perTex{1.0}, first{0.0};  ///< As FrameParams has them.
};

/// One time step of a volume on the GPU, one channel or all of them mixed, at the best level that fits.
struct GpuVolume {
  gpu::Texture texture;  ///< 3D; where values are packed, the texture of the buffer `packed`.
  gpu::Buffer packed;
  Packing packing = Packing::None;
  gpu::Texture gradient;              ///< Gradients as packGradients() makes them, where there is room.
  glm::ivec3 storeSize{0};            ///< Texels of the textures; of a streamed volume its slots lie there, too.
  double gradientScale = 0;           ///< Length of a full-length gradient texel, texels times 255/127.
  std::vector<glm::vec2> cellRanges;  ///< By cell: smallest and largest texel, with a halo of one voxel.
  gpu::Buffer cellRange;              ///< cellRanges on the GPU.
  std::uint64_t cellsRevision = 0;    ///< Changes with cellRanges.
  CellGrid cells;
  std::optional<PagePlace> pages;          ///< Of a streamed volume.
  glm::ivec3 dims{0};                      ///< Voxels of the volume.
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
  /// Into textures that are there, whose first texels become the volume's. @param into  must outlive this object;
  /// large enough; take() gives all but its textures
  VolumeUpload(const scene::VolumeLayer& layer, const gpu::Limits& limits, const TexelPlan& plan, GpuVolume& into);
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
