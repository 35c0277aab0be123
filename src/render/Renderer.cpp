#include "render/Renderer.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <optional>
#include <thread>

#include "core/Clock.h"
#include "render/FrameData.h"
#include "render/Gbuffer.h"
#include "render/WorkQueue.h"
#include "render/passes/CountPass.h"
#include "render/passes/FinishPass.h"
#include "render/passes/GhostPass.h"
#include "render/passes/InstancePass.h"
#include "render/passes/LightPass.h"
#include "render/passes/ModelPass.h"
#include "render/passes/RayCastPass.h"
#include "render/passes/ResolvePass.h"
#include "render/passes/SkipPass.h"
#include "render/passes/StatePass.h"
#include "render/passes/SurfacePass.h"
#include "render/passes/UploadPass.h"
#include "render/residency/Residency.h"

namespace velum::render {

namespace {

constexpr double kUploadShare = 0.05;                   // of a picture's progress
constexpr std::chrono::milliseconds kProgramsPause{1};  // between two questions whether programs are compiled
constexpr int kCoarseMarks = 8, kFineMarks = 3;         // rays leave marks on pages through one of so many pixels a side
constexpr std::chrono::milliseconds kBricksPause{1};    // and whether bricks have come

}  // namespace

/// The passes, what they hand on to each other, and the work that is left of the frame in hand.
struct Renderer::Impl {
  Impl(gpu::Context& c, const Stats& known)
      : limits(c.limits()),
        upload(limits),
        model(limits),
        states(model),
        instances(model, states, surfaces),
        rayCast(gbuffer, limits.isSoftware),
        counts(gbuffer, model, states),
        ghosts(gbuffer, model, instances.draw()),
        finish(gbuffer),
        stats(known) {}

  gpu::Limits limits;
  std::optional<Frame> wanted;  ///< As the caller gave it.
  FrameData coming;             ///< Of a frame whose data is on its way;
  FrameData data;               ///< of the one that is drawn, or was last.
  bool isDrawn = false;         ///< All passes are prepared for `data`.
  FrameInputs inputs;
  Gbuffer gbuffer;
  UploadPass upload;
  SkipPass skip;
  LightPass light;
  SurfacePass surfaces;
  ModelPass model;
  StatePass states;
  InstancePass instances;
  RayCastPass rayCast;
  CountPass counts;
  GhostPass ghosts;
  FinishPass finish;
  ResolvePass resolve;
  /// Whom the data's upload goes before,
  Pass* const lighting[6] = {&skip, &light, &surfaces, &model, &states, &instances};
  /// and those that need to know of their targets.
  Pass* const casting[4] = {&rayCast, &counts, &ghosts, &finish};
  WorkQueue queue;
  Stats stats;
  bool waits = false;                          ///< Nobody looks on: bricks are waited for before anything is drawn.
  Clock::time_point drawnAt = Clock::now();  ///< When there was something new to be seen.

  void begin(const Frame& frame);
  void setUp();
  void askForPrograms();
  bool hasPrograms();
  void addSamples();
  void addBricks(int pixelStep);
  bool takeBricks();
  void addCasting();
  void checkBricks();
  bool isPatient() const;
  Residency::MayShow whatShows() const;
  void bind() const;
  void noteStats();
  bool look();
};

/// The frame, first half: what is not on the GPU yet, piece by piece; then everything else can be known.
void Renderer::Impl::begin(const Frame& frame) {
  wanted = frame;
  isDrawn = false;
  queue.restart();
  rayCast.restart();
  finish.restart();
  ghosts.restart();
  coming = {.frame = withSizes(frame), .isSoftware = limits.isSoftware};
  upload.prepare(coming);
  upload.addSteps(coming, 0, queue);
  queue.add("Setup", [this] { setUp(); });
  queue.add("Programs", [this] { askForPrograms(); });
  queue.addUntilDone("Programs", [this] { return hasPrograms(); });
  queue.add("Setup", [this] { addSamples(); });
  queue.countAll();
}

/// What the frame is made of. Before its program is compiled, whoever works by a budget may say so.
void Renderer::Impl::setUp() {
  data = std::move(coming);
  upload.complete(data);
  completeFrameData(data);
  for (Pass* pass : lighting) pass->prepare(data);
  if (!rayCast.isKnown(data)) queue.rest();
}

void Renderer::Impl::askForPrograms() {
  for (Pass* pass : lighting) pass->compile(data);
  for (Pass* pass : casting) pass->prepare(data);
}

/// What drivers compile beside this thread is waited for without holding it up.
bool Renderer::Impl::hasPrograms() {
  auto isReady = [](Pass* pass) { return pass->isReady(); };
  if (std::all_of(std::begin(lighting), std::end(lighting), isReady) &&
      std::all_of(std::begin(casting), std::end(casting), isReady))
    return true;
  std::this_thread::sleep_for(kProgramsPause);
  queue.rest();
  return false;
}

/// The frame, second half, in its order.
void Renderer::Impl::addSamples() {
  inputs.write(data);
  isDrawn = true;
  bind();
  // What all samples of the picture share.
  skip.addSteps(data, 0, queue);
  light.addSteps(data, 0, queue);
  states.addSteps(data, 0, queue);
  if (data.residency && !data.frame.isPreview)
    addBricks(kCoarseMarks);
  else
    addCasting();
  queue.countAll();
}

/// Of a streamed volume: which bricks rays meet, and what is not there of them. First those of few pixels; when these
/// have what they want, those of more pixels, in each of their samples.
void Renderer::Impl::addBricks(int pixelStep) {
  queue.add("Setup", [this] {
    bind();
    data.residency->clearSeen();
  });
  int samples = pixelStep == kCoarseMarks ? 1 : std::max(1, data.frame.scene.rayCast.samplesPerPixel);
  for (int sample = samples - 1; sample >= 0; --sample)
    queue.add(rayCast, [this, sample, pixelStep] {
      inputs.writeParams(data, sample);
      rayCast.markPages(data, pixelStep);
    });
  queue.add("Bricks", [this] { data.residency->gather(whatShows()); });
  queue.addUntilDone("Bricks", [this] { return takeBricks(); });
  queue.add("Bricks", [this, pixelStep] {
    bool hasNews = data.residency->hasNews();
    if (hasNews) data.residency->updateCells();
    skip.addSteps(data, 0, queue);
    // What has come may have let rays through to others.
    if (!isPatient() || (!hasNews && pixelStep == kFineMarks))
      addCasting();
    else
      addBricks(hasNews ? pixelStep : kFineMarks);
  });
}

/// Waits for bricks, but not longer than somebody who looks on likes to see nothing new.
bool Renderer::Impl::takeBricks() {
  constexpr double kPieceMs = 8.0;
  std::size_t missing = data.residency->receive(kPieceMs, whatShows());
  if (missing == 0 || !isPatient()) return true;
  std::this_thread::sleep_for(kBricksPause);
  queue.rest();
  return false;
}

/// Rays stop for all values where they leap over nothing, look for the largest, or a cut shows the data on its face.
Residency::MayShow Renderer::Impl::whatShows() const {
  bool isAll = data.frame.scene.rayCast.mode == scene::RenderMode::Mip || (data.params.flags & shared::kFlagFaces) ||
               !(data.params.flags & shared::kFlagSkipEmpty) || (data.params.flags & shared::kFlagInlays);
  if (isAll) return [](glm::vec2) { return true; };
  return skip.whatShows();
}

bool Renderer::Impl::isPatient() const {
  constexpr double kMostMs = 500.0;
  return waits || msSince(drawnAt) < (rayCast.progress().samples > 0 ? kMostMs : 0.0);
}

/// A sample may have met what the marks of a few pixels had not told.
void Renderer::Impl::checkBricks() {
  drawnAt = Clock::now();
  std::size_t missing = data.residency->gather(whatShows());
  if (missing == 0 && !data.residency->hasNews()) return;
  queue.dropRest();
  queue.addUntilDone("Bricks", [this] { return takeBricks(); });
  queue.add("Bricks", [this] {
    if (data.residency->hasNews()) data.residency->updateCells();
    skip.addSteps(data, 0, queue);
    addBricks(kFineMarks);
  });
  rayCast.redo();
  finish.restart();
  ghosts.restart();
}

/// Each sample: its rays, what is rasterised, what is cast up to there, what an illustrator makes of it.
void Renderer::Impl::addCasting() {
  if (data.residency) queue.add("Bricks", [this] { bind(); data.residency->clearSeen(); });
  int samples = std::max(1, data.frame.scene.rayCast.samplesPerPixel);
  for (int sample = 0; sample < samples; ++sample) {
    queue.add("Setup", [this, sample] { inputs.writeParams(data, sample); });
    surfaces.addSteps(data, sample, queue);
    instances.addSteps(data, sample, queue);
    rayCast.addSteps(data, sample, queue);
    counts.addSteps(data, sample, queue);
    ghosts.addSteps(data, sample, queue);
    finish.addSteps(data, sample, queue);
    if (data.residency && !data.frame.isPreview && (sample == 0 || sample + 1 == samples))
      queue.add("Bricks", [this] { checkBricks(); });
  }
}

/// For all steps that follow. Other GL work that comes in between binds things of its own.
void Renderer::Impl::bind() const {
  inputs.bind();
  upload.bind(data);
  for (const Pass* pass : lighting) pass->bind(data);
  for (const Pass* pass : casting) pass->bind(data);
}

void Renderer::Impl::noteStats() {
  stats.frameMs = queue.totalMs() - upload.frameMs();
  stats.uploadMs = upload.ms();
  stats.longestStepMs = queue.longestMs();
  stats.samples = rayCast.progress().samples;
  stats.labelBytes = upload.labelBytes();
  stats.reduction = isDrawn && data.residency ? data.residency->shortfall() : isDrawn && data.volume && !data.volumeKey.isQuick ? data.volume->reduction : "";
  if (queue.isEmpty()) stats.passesMs = queue.timesMs();
}

/// The frame, as far as it is. @return false when there was none yet
bool Renderer::Impl::look() {
  if (!gbuffer) return false;
  inputs.bind();
  const PictureProgress& done = rayCast.progress();
  if (isDrawn && (done.rowsDone > 0 || done.columnsDone > 0)) finish.catchUp(data);
  resolve.draw(data, gbuffer, finish, ghosts, done);
  return true;
}

Renderer::Renderer(gpu::Context& context)
    : mImpl(std::make_unique<Impl>(context, Stats{context.limits().renderer})), mContext(context) {}
Renderer::~Renderer() = default;

const Stats& Renderer::stats() const { return mImpl->stats; }
double Renderer::fractionDone() const {
  // How much there is to draw is known when all is uploaded.
  double done = mImpl->queue.fractionDone();
  return mImpl->isDrawn ? kUploadShare + (1.0 - kUploadShare) * done : kUploadShare * done;
}

void Renderer::clear() { mImpl = std::make_unique<Impl>(mContext, mImpl->stats); }

bool Renderer::work(const Frame& frame, double budgetMs) {
  Impl& m = *mImpl;
  if (!m.wanted || !(*m.wanted == frame)) m.begin(frame);
  if (m.queue.isEmpty()) return true;
  if (m.isDrawn) m.bind();
  bool isDone = false;
  try {
    isDone = m.queue.work(budgetMs);
  } catch (...) {
    m.wanted.reset();  // a frame that has failed half way begins anew
    throw;
  }
  // Where the processor draws nothing goes on meanwhile, and the last piece counts, too.
  if (isDone && m.limits.isSoftware) m.queue.finish();
  m.noteStats();
  return isDone;
}

void Renderer::render(const Frame& frame, Progress& progress) {
  mImpl->waits = true;
  while (!work(frame, 100.0)) progress.report(fractionDone(), "rendering");
  mImpl->queue.finish();
  mImpl->noteStats();
}

void Renderer::present(unsigned framebuffer, glm::ivec2 size) {
  if (mImpl->look()) mImpl->resolve.present(framebuffer, size);
}

Image Renderer::read(const Layers& layers) {
  if (!mImpl->look()) return {};
  Image image = mImpl->resolve.read();
  mImpl->gbuffer.appendLayers(mImpl->data, layers, image);
  if (layers.ghosts) mImpl->ghosts.appendLayer(image);
  return image;
}

Pick Renderer::pick(glm::ivec2 pixel) const {
  return mImpl->gbuffer ? mImpl->gbuffer.pick(mImpl->data, pixel) : Pick{};
}

std::optional<InstanceBits> Renderer::bits(bool waits) { return mImpl->counts.take(waits); }

std::vector<std::int32_t> Renderer::typesOfPixels() const {
  return mImpl->gbuffer ? mImpl->gbuffer.typesOfPixels(mImpl->data) : std::vector<std::int32_t>();
}

}  // namespace velum::render
