#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/LabelCover.h"
#include "gpu/Texture.h"
#include "render/upload/StructureSets.h"

namespace velum::render {

/// What a texture of shares holds. Shares reach shaders as r, g: share that cuts spare, by class (or g: share of
/// veils), b: share of solid structures, a: share that is shown. Sets that are equal share one component of the
/// texture.
struct ShareLayout {
  std::vector<std::uint8_t> sets;              ///< A component for each: bits of StructureSets.
  std::array<gpu::Component, 4> components{};  ///< Which component of the texture shaders get as r, g, b and a.
  /// Bytes of a voxel's shares before they are uploaded.
  std::size_t bytes() const { return sets.size() > 2 ? 4 : std::max(sets.size(), std::size_t(1)); }
  gpu::Format format() const;
  bool operator==(const ShareLayout&) const = default;
};
/// As few components as the sets need.
ShareLayout shareLayoutOf(const StructureSets& sets);

/// Of the voxels of a box, x fastest.
struct ShareTexels {
  std::vector<std::uint8_t> covers;  ///< see LabelCover
  std::vector<std::uint8_t> shares;  ///< ShareLayout::bytes() each, 0..255
  std::vector<std::uint8_t> means;   ///< of 2 x 2 x 2 voxels, as many as there are
};

/// Cost: the voxels of the box. Any thread. @param low  even @param size  the box lies in the grid
ShareTexels shareTexelsOf(const StructureField& field, const StructureSets& sets, const ShareLayout& layout,
                          glm::ivec3 low, glm::ivec3 size);
/// The shares of a voxel around which all is one structure's.
std::vector<std::uint8_t> wholeShare(const StructureSets& sets, const ShareLayout& layout, std::uint16_t id);
/// Shares in the texture's format: a single one takes 16 bits.
std::vector<std::uint8_t> shareUpload(const ShareLayout& layout, std::vector<std::uint8_t> texels);

}  // namespace velum::render
