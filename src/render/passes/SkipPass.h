#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "FrameData.h"
#include "Pass.h"
#include "velum/gpu/Program.h"
#include "velum/gpu/Texture.h"

namespace velum::render {

/// The map of empty space: for each cell the Chebyshev distance, in cells, to the nearest cell with content (r) and to
/// the nearest with content that some cut spares (g). Conservative: a cell without content adds nothing to any picture.
/// Cost: cells (at most 64^3) x 4 small dispatches, whatever the volume's size.
class SkipPass : public Pass {
 public:
  SkipPass();
  void prepare(FrameData& data) override;
  void addSteps(const FrameData& data, int sample, WorkQueue& queue) override;
  void bind(const FrameData& data) const override;

 private:
  enum class Content { Opacity = 0, Iso = 1, Labels = 2 };
  /// What the map is made from. Of values, what their kind of content does not ask about stays as it is here.
  struct Key {
    Content content = Content::Opacity;
    VolumeKey volume;
    LabelKey labels;
    glm::uvec2 visible{0};  ///< 64-bit set of visible ids, mod 64
    glm::uvec2 spared{0};   ///< 64-bit set of ids that some cut spares
    glm::ivec3 cells{0};
    float tablePerTexel = 0, tableOffset = 0, isoValue = 0;
    std::vector<std::uint32_t> extinctionSums;
    bool operator==(const Key&) const = default;
  };
  static Key keyOf(const FrameData& data);
  void run(const Key& key);

  gpu::Program mOccupancy, mDistance;
  gpu::Texture mMap[2];
  std::optional<Key> mKey;
};

}  // namespace velum::render
