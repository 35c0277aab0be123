#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "core/Image.h"
#include "gpu/Context.h"
#include "render/Renderer.h"
#include "session/Job.h"
#include "session/Player.h"
#include "session/document/Document.h"
#include "session/document/WorkFile.h"
#include "session/growth/GrowthPlayer.h"
#include "session/look/ValueHistogram.h"
#include "session/membrane/MembranePlayer.h"

namespace velum::session {

struct PictureOptions;

/// What is open, and all that goes on beside it: the document with its file and journal, the players, the jobs. Both
/// programs drive it; it knows of no widget. One thread, in which a context is current where it says GL thread; where
/// nobody has lent it one, it makes one of its own when it first needs it.
class Session {
 public:
  Session();
  /// Cancels what is running, and waits for it.
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  const scene::Scene& scene() const { return mDocument.scene(); }
  Document& document() { return mDocument; }
  const Document& document() const { return mDocument; }
  WorkFile& file() { return mFile; }
  const WorkFile& file() const { return mFile; }

  /// Called after every change of the document, when players and journal have heard of it.
  void setListener(std::function<void()> listener) { mListener = std::move(listener); }
  /// Called when a job has ended: collect() has something to do. From the job's thread.
  void setWaker(std::function<void()> waker) { mWaker = std::move(waker); }

  // Players.
  MembranePlayer& membranes() { return mMembranes; }
  const MembranePlayer& membranes() const { return mMembranes; }
  GrowthPlayer& growth() { return mGrowth; }
  const GrowthPlayer& growth() const { return mGrowth; }
  /// What tools that measure materials ask.
  HistogramMemo& histograms() { return mHistograms; }
  /// Takes in what jobs have computed, and tells the end of the user's. Needs no context.
  void collect();
  /// Lets the players go on for about so long, with jobs for what is to be computed beside, and writes down what has
  /// come to rest. GL thread.
  /// @return true when more is due at once
  bool advance(double budgetMs);
  /// What players show is the scene as it is; those that are paused are not waited for.
  bool isOnItsWay() const;
  /// Nothing is to be done.
  bool isSettled() const;
  /// Another number when players show something else.
  std::uint64_t shownCount() const;
  /// A picture of the scene with what the players have. GL thread. @param size  pixels
  render::Frame frame(glm::ivec2 size);
  /// Lets all come to rest that is not paused. GL thread where there are membranes. @throw Cancelled, gpu::GpuError
  void settle(Progress& progress);
  /// A picture of the scene with all at rest, as drawPicture() makes it. For sessions without a window: with a context
  /// of its own, which is current afterwards. @throw Cancelled, gpu::GpuError
  Image picture(const PictureOptions& options, Progress& progress);
  /// How it makes a context of its own. @param kind  Auto unless told otherwise
  void setContextKind(gpu::ContextKind kind) { mContextKind = kind; }
  /// GL is somebody else's, whose context is current wherever it says GL thread.
  void borrowContext() { mOwnsContext = false; }
  /// Gives up everything on the GPU; what moved starts anew. GL thread.
  void releaseGpu();

  // The job on whose end the user waits: a load, a picture.
  /// @param progressed  from the job's thread  @param ended  from collect()
  /// @return false while another one runs
  bool startJob(Job::Work work, Progress::Listener progressed, Job::Ended ended);
  void cancelJob();
  /// Waits for the end of the job, which is told before this returns, no longer than so many milliseconds.
  void awaitJob(double longestMs);
  /// Cancels, waits, and tells nobody.
  void dropJob();
  bool isBusy() const { return mJob != nullptr; }

 private:
  /// A player and what is computed for it.
  struct Playing {
    Player* player;
    std::unique_ptr<Job> job;
    Player::Finish finish;
    JobOutcome outcome;
  };
  void changed();
  /// Makes its context the current one, where it has one of its own.
  void bindContext();
  void collect(Playing& playing);
  void startWork(Playing& playing);
  void collectJob();
  void wake() const {
    if (mWaker) mWaker();
  }

  // What is on the GPU goes before its context.
  gpu::ContextKind mContextKind = gpu::ContextKind::Auto;
  bool mOwnsContext = true;
  std::unique_ptr<gpu::Context> mContext;
  std::unique_ptr<render::Renderer> mRenderer;
  Document mDocument;
  WorkFile mFile{mDocument};
  GrowthPlayer mGrowth;
  MembranePlayer mMembranes;
  HistogramMemo mHistograms;
  std::vector<Playing> mPlaying;  ///< Never grows while jobs run: they know their place in it.
  std::function<void()> mListener, mWaker;
  std::unique_ptr<Job> mJob;
  JobOutcome mJobOutcome;
  Job::Ended mJobEnded;
};

}  // namespace velum::session
