#pragma once
#include <vector>

#include "core/Shared.h"
#include "core/Volume.h"
#include "gpu/Texture.h"
#include "render/upload/PackedTexels.h"
#include "render/upload/TransferTable.h"

namespace velum::render {

/// How a sample type is kept on the GPU: integers of 8 and 16 bits as they are (signed ones shifted), all else as
/// float.
struct TexelPlan {
  gpu::Format format = gpu::Format::R8;
  double scale = 1, offset = 0;  ///< raw = texel * scale + offset
  Packing packing = Packing::None;
};
inline constexpr TexelPlan kAsFloats{gpu::Format::R32f, 1.0, 0.0};

TexelPlan planFor(const Volume& volume, bool isMixed);

/// One time step of a volume at a level, as texels.
struct VolumeTexels {
  Shared<Volume> volume;
  int channel = 0, timeStep = 0;
  MixTable mix;          ///< How channels are mixed; empty where they are not.
  glm::ivec3 dims{0};    ///< Size of the level, texels.
  int factor = 1;        ///< How many voxels of the volume lie along the edge of a texel of the level.
  bool isQuick = false;  ///< Texels are single voxels, not means.
  bool isMixed = false;

  /// The level's planes z0..z1: straight from the volume when nothing has to change, else converted into `scratch`.
  /// Texel is std::uint8_t, std::uint16_t, float or, for colours, glm::u8vec4.
  template <class Texel>
  const Texel* planes(int z0, int z1, std::vector<Texel>& scratch) const;

 private:
  template <class Raw>
  void mixPlanes(const Raw* samples, int z0, int z1, std::vector<glm::u8vec4>& texels) const;
  template <class Texel, class Raw>
  void convertPlanes(const Raw* samples, int z0, int z1, std::vector<Texel>& texels) const;
};

}  // namespace velum::render
