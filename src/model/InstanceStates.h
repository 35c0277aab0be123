#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "gpu/Buffer.h"
#include "gpu/Texture.h"
#include "model/InstanceTarget.h"

namespace velum::shared {
struct FocusView;
}

namespace velum::model {

/// What becomes of each instance in a frame, a bit each of three kinds one after the other: removed by cuts for where
/// it stands (or of a hidden type), cleared as it hides what a cut keeps in view, shown by some pixel of the picture.
/// Cost: a look at each instance for the first and for each focus; the pixels of spheres in the focus's mask; a look at
/// each pixel for the last. GL thread.
///
/// The InstanceView of the frame, the frame's cuts and the set's rows are bound.
class InstanceStates {
 public:
  void resize(std::uint32_t instances, int copies);
  /// Words of one kind.
  int words() const { return int((mCount + 31) / 32); }

  /// Nothing is removed, nothing shown.
  void begin();
  void clip(InstancePrograms& programs, bool hasMembranes, const InstancePart& part);
  /// Begins with what a cut keeps in view ([VE] 6): drawFocus() of all parts, flood() where it has apertures, then
  /// clear() of all parts.
  void beginFocus(const shared::FocusView& view);
  void drawFocus(InstancePrograms& programs, bool hasMembranes, const InstancePart& part);
  void flood(InstancePrograms& programs);
  void clear(InstancePrograms& programs, bool hasMembranes, const InstancePart& part);
  /// What pixels show. @param ids  structure, instance + 1  @param first  the number of the model's first instance
  void noteShown(InstancePrograms& programs, const gpu::Texture& ids, std::uint32_t first);

  void bind() const;
  const gpu::Buffer& bits() const { return mBits; }
  /// The mask of a focus, bits of depths, and the seeds of its distances after flood(), x and y in 16 bits each. For
  /// tests.
  gpu::Buffer& mask() { return mMask; }
  const gpu::Buffer& seeds() const { return mSeeds[0]; }

 private:
  void look(const gpu::Program& program, const InstancePart& part) const;

  std::uint32_t mCount = 0;
  gpu::Buffer mBits, mView, mMask, mSeeds[2], mReach;
  gpu::Texture mMaskTexels, mSeedTexels[2];
  glm::ivec2 mSize{0};  ///< Of the mask.
};

}  // namespace velum::model
