#pragma once
#include <glm/glm.hpp>
#include <map>

#include "FrameData.h"
#include "Gbuffer.h"
#include "Pass.h"
#include "velum/gpu/Program.h"

namespace velum::render {

/// How far a picture is: each pixel is the mean of the samples that it has.
struct PictureProgress {
  int samples = 0;      ///< Complete ones.
  int rowsDone = 0;     ///< Rows from the top that have one more.
  glm::ivec2 strip{0};  ///< First row and one past the last of the strip of tiles in work;
  int columnsDone = 0;  ///< of it, the columns that have one more.
};

/// One ray a pixel through the data, tile by tile, up to what the surfaces hide. Keeps nothing from frame to frame but
/// programs, and the size of tiles that keeps no window waiting.
class RayCastPass : public Pass {
 public:
  RayCastPass(Gbuffer& target, bool isSoftware);
  void prepare(FrameData& data) override;
  void addSteps(const FrameData& data, int sample, WorkQueue& queue) override;
  void bind(const FrameData& data) const override;
  void took(double ms) override;

  const PictureProgress& progress() const { return mProgress; }
  /// Nothing of the next picture is there yet.
  void restart() { mProgress = {}; }

 private:
  void adaptTileSize();
  void castTile(const FrameData& data, glm::ivec4 rect);

  Gbuffer& mTarget;
  std::map<RayVariant, gpu::Program> mPrograms;
  const gpu::Program* mProgram = nullptr;  ///< The frame's.
  PictureProgress mProgress;
  bool mIsPreview = false;
  int mLargestTile;  ///< Pixels along an edge.
  int mTileSize;
  double mLongestTileMs = 0;  ///< Of the pictures since it was chosen.
};

}  // namespace velum::render
