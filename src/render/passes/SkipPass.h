#pragma once
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "gpu/Texture.h"
#include "render/FrameData.h"
#include "render/passes/Pass.h"
#include "render/upload/SkipMap.h"

namespace velum::render {

/// The map of empty space: for each cell the Chebyshev distance, in cells, to the nearest cell with content (r) and to
/// the nearest cell with content that some cut spares (g). Conservative: a cell without content adds nothing to any
/// picture. Cost: cells (at most 64^3), whatever the volume's size; made on the processor, which handles 64 cells as
/// one word, where a shader would go cell by cell.
class SkipPass : public Pass {
 public:
  SkipPass() : Pass("Skip") {}
  void prepare(FrameData& data) override;
  void addSteps(const FrameData& data, int sample, WorkQueue& queue) override;
  void bind(const FrameData& data) const override;
  /// Tells whether values, smallest and largest, may show something in the frame for which the map was made. Any
  /// thread.
  std::function<bool(glm::vec2 texels)> whatShows() const;

 private:
  enum class Content { Opacity, Iso, Labels };
  /// The values by which cells with content are found. Members that do not matter to the kind of content keep their
  /// defaults.
  struct Key {
    Content content = Content::Opacity;
    VolumeKey volume;
    std::uint64_t cellRanges = 0;           ///< Revision of the ranges of a streamed volume's cells.
    std::uint64_t labelCells = 0;           ///< Revision of the labels' cells; 0: no labels.
    std::uint64_t visible = 0, spared = 0;  ///< Sets of ids mod 64: ids that show; ids that some cut spares.
    std::uint64_t hidden = 0, solid = 0;  ///< Ids that do not show; ids that show whatever the values of their voxels.
    // Filled only where some spare ends at a depth: what is needed to find the cells in which spares end.
    std::vector<shared::CutData> cuts;
    std::vector<float> deepest;  ///< [64][cuts]: the largest depth to which a cut spares the ids of a bit, scene frame.
    glm::mat4 sceneFromTex{0.0f};
    glm::ivec3 cells{0};
    float tablePerTexel = 0, tableOffset = 0, isoValue = 0;
    std::vector<std::uint32_t> extinctionSums;
    bool operator==(const Key&) const = default;
  };
  /// A ball around a part of the data's box that holds some ids.
  struct Ball {
    glm::vec3 centre{0.0f};  ///< scene frame
    float radius = 0;
  };
  /// The cells with content.
  struct Found {
    CellSet all, spared;
    bool operator==(const Found&) const = default;
  };
  static Key keyOf(const FrameData& data);
  static bool hasContent(const Key& key, glm::vec2 texels);
  static bool hasEnds(const Key& key, glm::vec2 texels);
  static bool maySpare(const Key& key, std::uint64_t ids, const Ball& ball);
  static Found find(const Key& key, const FrameData& data);

  gpu::Texture mMap;
  std::optional<Key> mKey;
  Found mFound;  ///< The cells that the map was made from: an edit seldom changes them.
};

}  // namespace velum::render
