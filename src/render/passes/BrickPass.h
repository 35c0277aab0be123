#pragma once
#include <functional>

#include "core/Clock.h"
#include "render/FrameData.h"
#include "render/passes/RayCastPass.h"
#include "render/passes/SkipPass.h"
#include "render/residency/Residency.h"

namespace velum::render {

/// Of a streamed volume: finds out by rays which bricks a frame needs, waits for them, and begins the picture again
/// where drawing it met others. Who looks on sees what is there at least twice a second; a picture that is saved waits
/// for all. GL thread.
class BrickPass {
 public:
  using Then = std::function<void()>;
  BrickPass(SkipPass& skip, RayCastPass& rayCast, FrameInputs& inputs, WorkQueue& queue)
      : mSkip(skip), mRayCast(rayCast), mInputs(inputs), mQueue(queue) {}

  /// Nobody looks on: nothing is drawn before all bricks are there.
  void setWaits(bool waits) { mWaits = waits; }
  /// Adds the work before a picture. @param bind  binds all that rays need  @param cast  adds the picture's own work
  /// @param restart  begins the frame anew: it is to be drawn at a coarser level
  void addSteps(FrameData& data, Then bind, Then cast, Then restart);
  /// Before the rays of a picture: what they meet from now on is marked. Their steps get longer where bricks hold
  /// larger voxels: FrameParams::coarsening.
  void beginCasting(FrameData& data) const;
  /// Adds, after a sample, the question whether it met bricks that are not there. If so what is left of the picture is
  /// given up. @param again  called when they have come: adds the work that draws the sample, and what is left, again
  void addCheck(const FrameData& data, Then again);
  /// Adds the work before a picture once more, without its first rays.
  void addStepsAgain();

 private:
  void addRound(int pixelStep);
  void addGathering();
  bool take();
  void takeNews();
  bool isPatient() const;
  Residency::MayShow whatShows() const;

  SkipPass& mSkip;
  RayCastPass& mRayCast;
  FrameInputs& mInputs;
  WorkQueue& mQueue;
  FrameData* mData = nullptr;
  Then mBind, mCast, mRestart;
  bool mWaits = false;
  bool mHadAll = false;                       ///< The last picture met no brick that was not there,
  scene::Camera mView;                        ///< seen like this,
  glm::ivec2 mViewSize{0};                    ///< on so many pixels.
  Clock::time_point mDrawnAt = Clock::now();  ///< When there was something new to be seen.
};

}  // namespace velum::render
