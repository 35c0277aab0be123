#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "core/Image.h"
#include "gpu/Context.h"
#include "render/Renderer.h"
#include "session/Job.h"
#include "session/Worker.h"
#include "session/document/Document.h"
#include "session/document/WorkFile.h"
#include "session/growth/GrowthWorker.h"
#include "session/look/ValueHistogram.h"
#include "session/membrane/MembraneMover.h"
#include "session/membrane/Membranes.h"
#include "session/model/PictureCounter.h"

namespace velum::session {

struct FilmOptions;
struct PictureOptions;

/// What is open, and all that goes on beside it: the document with its file and journal, what workers compute and
/// movers move, jobs, and, where nobody lends one, a GL context. The window, `velum-batch`, scripts and tests drive it
/// alike; it knows of no widget. One thread, in which a context is current where it says GL thread.
///
/// A window lends its context, calls collect() when it is woken and advance() while it draws. Whoever has none calls
/// settle(), picture() and film(), which take as long as they take; a context is made when the first of them needs one.
class Session {
 public:
  /// @param scene  that is there already, with its data
  explicit Session(scene::Scene scene = {});
  /// Cancels what is running, and waits for it.
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  const scene::Scene& scene() const { return mDocument.scene(); }
  Document& document() { return mDocument; }
  const Document& document() const { return mDocument; }
  WorkFile& file() { return mFile; }
  const WorkFile& file() const { return mFile; }

  /// Called after every change of the document, when workers and journal have heard of it.
  void setListener(std::function<void()> listener) { mListener = std::move(listener); }
  /// Called when collect() has something to do. From any thread.
  void setWaker(std::function<void()> waker) { mWaker = std::move(waker); }

  // What goes on beside the document.
  MembraneMover& membranes() { return mMembranes; }
  const MembraneMover& membranes() const { return mMembranes; }
  GrowthWorker& growth() { return mGrowth; }
  const GrowthWorker& growth() const { return mGrowth; }
  /// What tools that measure materials ask.
  HistogramMemo& histograms() { return mHistograms; }
  /// Takes in what jobs have computed, writes down what has come to rest, begins what is due of workers that move
  /// nothing, and tells the end of the user's job. Needs no context.
  void collect();
  /// Lets the movers go on for about so long, with jobs for what is to be computed beside, and writes down what has
  /// come to rest. GL thread.
  /// @return true when more is due at once
  bool advance(double budgetMs);
  /// What is shown is not yet what the scene asks for; what is paused is not waited for.
  bool isOnItsWay() const;
  /// Nothing is to be done.
  bool isSettled() const;
  /// Nothing is to be done by advance().
  bool isStill() const;
  /// Another number when movers show something else.
  std::uint64_t shownCount() const { return mMembranes.shownCount(); }
  /// A picture of the scene with what the movers have. GL thread. @param size  pixels
  render::Frame frame(glm::ivec2 size);
  /// Gives up everything on the GPU; what moved starts anew. GL thread.
  void releaseGpu() { mMembranes.releaseGpu(); }
  /// GL is somebody else's, whose context is current wherever it says GL thread: there are eyes and hands.
  void borrowContext();

  // For those who wait. A context of its own is current afterwards, where one was needed.
  /// How it makes a context. @param kind  Auto unless told otherwise
  void setContextKind(gpu::ContextKind kind) { mContextKind = kind; }
  /// Lets all come to rest that is not paused. @throw Cancelled, gpu::GpuError, InputError where forces cannot be made
  void settle(Progress& progress);
  /// Lets all grow that the scene asks for. Needs no context. @return what there is to tell of it, one line each
  /// @throw Cancelled, and what growing throws
  std::vector<std::string> grow(Progress& progress);
  /// The scene with all at rest, the shapes of its sheets in it. @throw as settle()
  scene::Scene settled(Progress& progress);
  /// A picture of the scene with all at rest, as drawPicture() makes it. @throw Cancelled, gpu::GpuError
  Image picture(const PictureOptions& options, Progress& progress);
  /// Draws and writes one picture or several, with the scene in them, all at rest in each. @param path  "-": standard
  /// output, of one  @return the files  @throw Cancelled, gpu::GpuError, InputError when the disk refuses,
  /// ArgumentError where whyStill() says why there is no animation
  std::vector<std::filesystem::path> film(const FilmOptions& options, const std::filesystem::path& path,
                                          Progress& progress);
  /// What became of the membranes that are on, at rest. @throw Cancelled, gpu::GpuError
  std::vector<MembraneReport> membraneReports(MembraneQuestions questions, Progress& progress);
  /// Counts what shows in pictures of so many pixels. Ends before the session does. @throw gpu::GpuError
  PictureCounter counter(glm::ivec2 size, Progress& progress);
  /// What its pictures are drawn with. @throw gpu::GpuError
  render::Renderer& renderer();

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
  /// A worker and what is computed for it.
  struct Working {
    Worker* worker;
    Mover* mover = nullptr;  ///< the same, where it is one
    std::unique_ptr<Job> job;
    Worker::Finish finish;
    JobOutcome outcome;
  };
  void changed();
  /// Makes its context the current one, where it has one of its own.
  void bindContext();
  void collect(Working& working);
  void complete(Working& working);
  void startWork(Working& working);
  void bringToRest(Working& working, Progress& progress);
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
  GrowthWorker mGrowth;
  MembraneMover mMembranes{MembraneMover::Purpose::Rest};
  HistogramMemo mHistograms;
  std::vector<Working> mWorking;  ///< Never grows while jobs run: they know their place in it.
  std::function<void()> mListener, mWaker;
  std::unique_ptr<Job> mJob;
  JobOutcome mJobOutcome;
  Job::Ended mJobEnded;
};

}  // namespace velum::session
