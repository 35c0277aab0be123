#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
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
#include "session/model/LevelWorker.h"
#include "session/model/PictureCounter.h"

namespace velum::vector {
struct Drawing;
}

namespace velum::session {

struct FilmOutput;
struct FilmReport;
struct PictureOptions;

/// An open document and all that goes on beside it: its file and journal, what workers compute and movers move, jobs,
/// and, where no caller lends one, a GL context. The window, `velum-batch`, scripts and tests drive a session alike; a
/// session knows of no widget. All calls come from one thread; a function that says GL thread needs a GL context that
/// is current in this thread.
///
/// A window lends its context, calls collect() when the waker has woken it and advance() while it draws. A caller
/// without a context calls settle(), picture() and film(), which take as long as they take; the session makes a context
/// when the first of these functions needs one.
class Session {
 public:
  /// @param scene  a scene that is there already, with its data
  explicit Session(scene::Scene scene = {});
  /// Cancels the work that is running, and waits for its end.
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// The scene that is saved, and the scene that is seen: at the playhead of its film, where there is one.
  const scene::Scene& scene() const { return mDocument.scene(); }
  const scene::Scene& shown() const { return mDocument.shown(); }
  Document& document() { return mDocument; }
  const Document& document() const { return mDocument; }
  WorkFile& file() { return mFile; }
  const WorkFile& file() const { return mFile; }

  /// Called after every change of the document, when workers and journal have taken the change in.
  void setListener(std::function<void()> listener) { mListener = std::move(listener); }
  /// Called when collect() has something to do. From any thread.
  void setWaker(std::function<void()> waker) { mWaker = std::move(waker); }

  // What goes on beside the document.
  MembraneMover& membranes() { return mMembranes; }
  const MembraneMover& membranes() const { return mMembranes; }
  GrowthWorker& growth() { return mGrowth; }
  const GrowthWorker& growth() const { return mGrowth; }
  const LevelWorker& levels() const { return mLevels; }
  /// The histograms that tools ask for when they measure materials.
  HistogramMemo& histograms() { return mHistograms; }
  /// Takes in what jobs have computed, writes into the document what has come to rest, begins the due work of workers
  /// that are no movers, and tells the end of the user's job. Needs no GL context.
  void collect();
  /// Lets the movers go on for about so many milliseconds, begins jobs for what they need computed, and writes into the
  /// document what has come to rest. GL thread.
  /// @return true when advance() has more to do at once
  bool advance(double budgetMs);
  /// True while what workers and movers show is not yet what the scene asks for; what is paused does not count.
  bool isOnItsWay() const;
  /// No worker or mover has anything left to do.
  bool isSettled() const;
  /// advance() has nothing left to do.
  bool isStill() const;
  /// A number that changes whenever movers show something else.
  std::uint64_t shownCount() const { return mMembranes.shownCount(); }
  /// A frame for a picture of the scene, with what the movers show in it. GL thread. @param size  pixels
  render::Frame frame(glm::ivec2 size);
  /// Gives up everything that the movers have on the GPU; sheets that were moving go on from there. GL thread.
  void releaseGpu() { mMembranes.releaseGpu(); }
  /// The GL context is the caller's from now on, and current wherever a function says GL thread. There are eyes and
  /// hands then: see MembraneMover::Purpose::Show.
  void borrowContext();

  // For callers that wait for the result. Where a GL context was needed, the session's own is current afterwards.
  /// Which kind of GL context the session makes for itself. @param kind  Auto unless told otherwise
  void setContextKind(gpu::ContextKind kind) { mContextKind = kind; }
  /// Waits until everything that is not paused has come to rest. @throw Cancelled, gpu::GpuError, InputError where
  /// forces cannot be made
  void settle(Progress& progress);
  /// Grows all regions that the scene asks for. Needs no GL context. @return notes for the user about the growth, one
  /// line each
  /// @throw Cancelled, and what growing throws
  std::vector<std::string> grow(Progress& progress);
  /// The scene with everything at rest and the shapes of its sheets in it. @throw as settle()
  scene::Scene settled(Progress& progress);
  /// A picture of the scene with everything at rest, drawn as by drawPicture(). @throw Cancelled, gpu::GpuError
  Image picture(const PictureOptions& options, Progress& progress);
  /// A picture of the scene with everything at rest as a drawing, see drawPlate(). @param section  none: the 3D picture
  /// @throw Cancelled, gpu::GpuError
  vector::Drawing plate(const PictureOptions& options, std::optional<scene::SectionKind> section, Progress& progress);
  /// Draws and writes a picture of what is shown, at rest, with its scene in it. @param path  "-": standard output
  /// @param section  none: the 3D picture  @return of a drawing for a page what journals refuse, see journalNotes()
  /// @throw Cancelled, gpu::GpuError, InputError when the disk refuses
  std::vector<std::string> savePicture(const PictureOptions& options, std::optional<scene::SectionKind> section,
                                       const std::filesystem::path& path, Progress& progress);
  /// Draws and writes the film of the scene's timeline, see makeFilm(): each frame at rest, with its scene in it, and
  /// drawn of all of its data. The rate is the timeline's.
  /// @throw gpu::GpuError, and as makeFilm()
  FilmReport film(FilmOutput output, Progress& progress);
  /// What became of the enabled membranes, at rest. @throw Cancelled, gpu::GpuError
  std::vector<MembraneReport> membraneReports(MembraneQuestions questions, Progress& progress);
  /// Makes a counter of what shows in pictures of so many pixels. The counter must end before the session does.
  /// @throw gpu::GpuError
  PictureCounter counter(glm::ivec2 size, Progress& progress);
  /// The renderer that draws the session's pictures. Not for a session that has borrowed its context.
  /// @throw gpu::GpuError
  render::Renderer& renderer();

  // The job whose end the user waits for, such as a load or a picture.
  /// @param progressed  called from the job's thread  @param ended  called from collect()
  /// @return false, and nothing is started, while another job runs
  bool startJob(Job::Work work, Progress::Listener progressed, Job::Ended ended);
  void cancelJob();
  /// Waits for the end of the job, but no longer than so many milliseconds. Where the job ends, `ended` is called
  /// before this returns.
  void awaitJob(double longestMs);
  /// Cancels the job and waits for its end, without calling `ended`.
  void dropJob();
  bool isBusy() const { return mJob != nullptr; }

 private:
  /// A worker and the job that computes for it.
  struct Working {
    Worker* worker;
    Mover* mover = nullptr;  ///< the same object as `worker`, where it is a mover
    std::unique_ptr<Job> job;
    Worker::Finish finish;
    JobOutcome outcome;
  };
  void changed();
  /// Makes the session's own GL context the current one; does nothing for a borrowed context.
  void bindContext();
  void collect(Working& working);
  void complete(Working& working);
  void startWork(Working& working);
  void bringToRest(Working& working, Progress& progress);
  void collectJob();
  void wake() const {
    if (mWaker) mWaker();
  }

  // Members that hold things on the GPU stand below the context, so that they are destroyed before it.
  gpu::ContextKind mContextKind = gpu::ContextKind::Auto;
  bool mOwnsContext = true;
  std::unique_ptr<gpu::Context> mContext;
  std::unique_ptr<render::Renderer> mRenderer;
  Document mDocument;
  WorkFile mFile{mDocument};
  GrowthWorker mGrowth;
  LevelWorker mLevels;
  MembraneMover mMembranes{MembraneMover::Purpose::Rest};
  HistogramMemo mHistograms;
  std::vector<Working> mWorking;  ///< Never grows while jobs run: each job holds a reference to its element.
  std::function<void()> mListener, mWaker;
  std::unique_ptr<Job> mJob;
  JobOutcome mJobOutcome;
  Job::Ended mJobEnded;
};

}  // namespace velum::session
