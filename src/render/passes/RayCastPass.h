#pragma once
#include <algorithm>
#include <deque>
#include <glm/glm.hpp>
#include <vector>

#include "gpu/Program.h"
#include "render/FrameData.h"
#include "render/Gbuffer.h"
#include "render/passes/Pass.h"
#include "render/passes/ProgramCache.h"

namespace velum::render {

/// How far the picture has come: each pixel is the mean of its samples so far.
struct PictureProgress {
  int samples = 0;      ///< Complete ones.
  int rowsDone = 0;     ///< Rows, from the top, that have one sample more.
  glm::ivec2 strip{0};  ///< Strip of rows in work: first row, and one past the last.
  int columnsDone = 0;  ///< Columns of that strip that have one sample more.
};

/// Casts one ray a pixel through the data, piece by piece, up to the nearest surface. Keeps only programs from frame to
/// frame, and how fast it was, from which it chooses pieces so small that no window has to wait. No pixel depends on
/// the size of the pieces.
class RayCastPass : public Pass {
 public:
  RayCastPass(Gbuffer& target, bool isSoftware);
  /// True when the program for the frame has been asked for before; compiling one takes seconds with some drivers.
  bool isKnown(const FrameData& data) const;
  void prepare(FrameData& data) override;
  bool isReady() override { return mProgram->isReady(); }
  void addSteps(const FrameData& data, int sample, WorkQueue& queue) override;
  void took(double ms) override;

  /// The programs of another one, see FrameWork::takePrograms().
  void takePrograms(RayCastPass& other) { std::swap(mPrograms, other.mPrograms); }

  /// Casts the rays of a sample once more, in rectangles of the window that do not overlap (x, y of the corner; width,
  /// height): over what is there, from the sums that were kept before the sample was drawn.
  void addPatches(const FrameData& data, int sample, std::vector<glm::ivec4> rects, WorkQueue& queue);
  /// Casts rays through some pixels that leave nothing but marks on the pages of a streamed volume.
  /// @param pixelStep  one of so many pixels along each axis
  void markPages(const FrameData& data, int pixelStep);

  const PictureProgress& progress() const { return mProgress; }
  /// Pixels of this picture through which rays were cast, over all samples.
  std::size_t pixelsCast() const { return mPixelsCast; }
  /// What casting the rays of one sample would take, by those that left marks last; at first 0.
  double sampleMs() const { return mSampleMs; }
  /// Draws the first sample once more, over what is there, or over the sums that were kept after it.
  void redo();
  /// Begins the next picture: nothing of it is there yet.
  void restart() {
    mProgress = {};
    mNext = {0, 0};
    mPixelsCast = 0;
  }

 private:
  /// Chooses how many groups of pixels make a piece. Times, except wantedMs, are for one group.
  struct Pace {
    double wantedMs = 0;  ///< Wanted time of a piece.
    double last = 0,
           slowest = 0;     ///< Time in the last piece, and in the slowest piece of the last picture; 0: not known.
    double slowestNow = 0;  ///< The slowest of this picture.
    int most = 0;           ///< Groups in this picture's largest piece.
    std::deque<int> handedOver;  ///< Groups of the pieces that are with the driver.
    void begin(double pieceMs);
    void took(double ms);
    int next(int first);
  };
  bool castNext(const FrameData& data, int sample, glm::ivec4 covered);
  glm::ivec4 nextPiece(glm::ivec4 rect);
  void finishSample(int sample);
  void castTile(const FrameData& data, glm::ivec4 rect, int pixelStep = 1);

  Gbuffer& mTarget;
  ProgramCache<RayVariant> mPrograms;
  const gpu::Program* mProgram = nullptr;  ///< The program for the present frame.
  PictureProgress mProgress;
  Pace mPace;
  int mFirst;           ///< Groups of a piece while no time is known.
  glm::ivec2 mNext{0};  ///< Where, within the covered rectangle, the next piece begins, pixels.
  int mStripRows = 0;   ///< Rows of the strip in which the next piece lies.
  std::size_t mPixelsCast = 0;
  double mSampleMs = 0;
  double mMarkedShare = 0;  ///< of a sample's rays, that the driver casts for marks; 0: none
};

}  // namespace velum::render
