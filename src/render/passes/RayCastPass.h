#pragma once
#include <deque>
#include <glm/glm.hpp>

#include "gpu/Program.h"
#include "render/FrameData.h"
#include "render/Gbuffer.h"
#include "render/passes/Pass.h"
#include "render/passes/ProgramCache.h"

namespace velum::render {

/// How far a picture is: each pixel is the mean of the samples that it has.
struct PictureProgress {
  int samples = 0;      ///< Complete ones.
  int rowsDone = 0;     ///< Rows from the top that have one more.
  glm::ivec2 strip{0};  ///< First row and one past the last of the strip in work;
  int columnsDone = 0;  ///< of it, the columns that have one more.
};

/// One ray a pixel through the data, piece by piece, up to what the surfaces hide. Keeps nothing from frame to frame
/// but programs, and how fast it was: pieces are as large as keeps no window waiting. No pixel depends on their size.
class RayCastPass : public Pass {
 public:
  RayCastPass(Gbuffer& target, bool isSoftware);
  /// Its program has been asked for before: to compile one takes seconds with some drivers.
  bool isKnown(const FrameData& data) const;
  void prepare(FrameData& data) override;
  bool isReady() override { return mProgram->isReady(); }
  void addSteps(const FrameData& data, int sample, WorkQueue& queue) override;
  void took(double ms) override;

  const PictureProgress& progress() const { return mProgress; }
  /// Nothing of the next picture is there yet.
  void restart() {
    mProgress = {};
    mNext = {0, 0};
  }

 private:
  /// How many groups of pixels make a piece. Times are those that a group of the piece took.
  struct Pace {
    double wantedMs = 0;           ///< For a piece.
    double last = 0, slowest = 0;  ///< In the last piece; the slowest of the last picture; 0: not known.
    double slowestNow = 0;         ///< Of this picture.
    int most = 0;                  ///< Groups of this picture's largest piece.
    std::deque<int> handedOver;    ///< Groups of the pieces that are with the driver.
    void begin(double pieceMs);
    void took(double ms);
    int next(int first);
  };
  bool castNext(const FrameData& data, int sample, glm::ivec4 covered);
  void finishSample(int sample);
  void castTile(const FrameData& data, glm::ivec4 rect);

  Gbuffer& mTarget;
  ProgramCache<RayVariant> mPrograms;
  const gpu::Program* mProgram = nullptr;  ///< The frame's.
  PictureProgress mProgress;
  Pace mPace;
  int mFirst;           ///< Groups of a piece while nothing is known.
  glm::ivec2 mNext{0};  ///< Where the next piece begins in what is covered, pixels.
  int mStripRows = 0;   ///< Rows of the strip that it is of.
};

}  // namespace velum::render
