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
  void addSteps(const FrameData& data, Then bind, Then cast);
  /// Adds, after a sample, the question whether it met bricks that are not there. If so what is left of the picture is
  /// given up. @param again  called when they have come: adds the work that draws the sample, and what is left, again
  void addCheck(const FrameData& data, Then again);
  /// Adds the work before a picture once more, without its first rays.
  void addStepsAgain();

 private:
  void addRound(int pixelStep);
  bool take();
  void takeNews();
  bool isPatient() const;
  Residency::MayShow whatShows() const;

  SkipPass& mSkip;
  RayCastPass& mRayCast;
  FrameInputs& mInputs;
  WorkQueue& mQueue;
  const FrameData* mData = nullptr;
  Then mBind, mCast;
  bool mWaits = false;
  bool mHadAll = false;                       ///< The last picture met no brick that was not there,
  scene::Camera mView;                        ///< seen like this,
  glm::ivec2 mViewSize{0};                    ///< on so many pixels.
  Clock::time_point mDrawnAt = Clock::now();  ///< When there was something new to be seen.
};

}  // namespace velum::render
