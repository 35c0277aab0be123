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

/// What becomes of each instance in a frame: three bits for each, stored as three arrays of bits one after the other.
/// They say that the instance is removed by cuts because of its place (or is of a hidden type), that it is cleared
/// because it hides something that a cut keeps in view, and that some pixel of the picture shows it. Cost: a look at
/// each instance for the first kind and for each focus; the pixels of spheres in the mask of a focus; a look at each
/// pixel for the last kind. GL thread.
///
/// Callers must have bound the frame's InstanceView and cuts, and the rows of the InstanceSet.
class InstanceStates {
 public:
  void resize(const InstanceRoom& instances);
  /// How many 32-bit words one kind of bits takes.
  int words() const { return int((mCount + 31) / 32); }

  /// Clears all bits: nothing is removed, nothing shown.
  void begin();
  void clip(InstancePrograms& programs, bool hasMembranes, const InstancePart& part);
  /// Begins with the focus of a cut ([VE] 6). To be followed by drawFocus() for all parts, flood() where the focus has
  /// apertures, then clear() for all parts.
  void beginFocus(const shared::FocusView& view);
  void drawFocus(InstancePrograms& programs, bool hasMembranes, const InstancePart& part);
  void flood(InstancePrograms& programs);
  void clear(InstancePrograms& programs, bool hasMembranes, const InstancePart& part);
  /// Sets the bits of the instances that pixels show. @param ids  of each pixel: structure, instance + 1 @param first
  /// number of the model's first instance among these
  void noteShown(InstancePrograms& programs, const gpu::Texture& ids, std::uint32_t first);

  void bind() const;
  const gpu::Buffer& bits() const { return mBits; }
  /// For tests: the mask of a focus, as bits of depths, and the seeds of the distances from the mask after flood(), x
  /// and y in 16 bits each.
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
