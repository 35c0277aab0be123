#include "render/FrameWork.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <thread>

#include "gpu/Allocation.h"
#include "render/passes/Patches.h"

namespace velum::render {

namespace {

constexpr std::chrono::milliseconds kProgramsPause{1};  // between two questions whether programs are compiled

}  // namespace

bool FrameWork::work(const Frame& frame, double budgetMs) {
  bool isDone = false;
  try {
    if (!wanted || !(*wanted == frame)) {
      ++begun;
      gpu::forgetExhaustion();  // others', such as the window's
      begin(frame);
    }
    if (queue.isEmpty()) return true;
    if (isDrawn) bind();
    isDone = queue.work(budgetMs);
    if (isDone) gpu::throwIfExhausted();  // of what is small, too
  } catch (...) {
    wanted.reset();  // a frame that has failed half way begins anew
    throw;
  }
  // Where the processor draws nothing goes on meanwhile, and the last piece counts, too.
  if (isDone && limits.isSoftware) queue.finish();
  noteStats();
  return isDone;
}

void FrameWork::takePrograms(FrameWork& other) {
  light.takePrograms(other.light);
  surfaces.takePrograms(other.surfaces);
  model.takePrograms(other.model);
  instances.takePrograms(other.instances);
  rayCast.takePrograms(other.rayCast);
  ghosts.takePrograms(other.ghosts);
  finish.takePrograms(other.finish);
  resolve.takePrograms(other.resolve);
}

/// The frame, first half: what is not on the GPU yet, piece by piece; then everything else can be known.
void FrameWork::begin(const Frame& frame) {
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
void FrameWork::setUp() {
  data = std::move(coming);
  upload.complete(data);
  completeFrameData(data);
  for (Pass* pass : lighting) pass->prepare(data);
  if (!rayCast.isKnown(data)) queue.rest();
}

void FrameWork::askForPrograms() {
  for (Pass* pass : lighting) pass->compile(data);
  for (Pass* pass : casting) pass->prepare(data);
}

/// What drivers compile beside this thread is waited for without holding it up.
bool FrameWork::hasPrograms() {
  auto isReady = [](Pass* pass) { return pass->isReady(); };
  if (std::all_of(std::begin(lighting), std::end(lighting), isReady) &&
      std::all_of(std::begin(casting), std::end(casting), isReady))
    return true;
  std::this_thread::sleep_for(kProgramsPause);
  queue.rest();
  return false;
}

/// The frame, second half, in its order.
void FrameWork::addSamples() {
  inputs.write(data);
  isDrawn = true;
  bind();
  // What all samples of the picture share.
  skip.addSteps(data, 0, queue);
  light.addSteps(data, 0, queue);
  states.addSteps(data, 0, queue);
  if (waitsForBricks())
    bricks.addSteps(
        data, [this] { bind(); }, [this] { addCasting(); }, [this] { begin(Frame(*wanted)); });
  else
    addCasting();
  queue.countAll();
}

/// Bricks have come that a sample met. Where rays are all that makes the picture, those are cast again that come
/// through them; else all of it begins again with the first sample.
void FrameWork::redraw(int sample) {
  if (canPatch(data)) {
    rayCast.addPatches(data, sample, changedRects(data), queue);
    finishSample(sample);
    addSamplesFrom(sample + 1);
    return;
  }
  rayCast.redo();
  finish.restart();
  ghosts.restart();
  bricks.addStepsAgain();
}

void FrameWork::addCasting() {
  if (data.residency)
    queue.add("Bricks", [this] {
      bricks.beginCasting(data);
      bind();
    });
  addSamplesFrom(0);
}

/// Each sample: its rays, what is rasterised, what is cast up to there, what an illustrator makes of it.
void FrameWork::addSamplesFrom(int first) {
  for (int sample = first; sample < samplesOf(data.frame); ++sample) {
    queue.add("Setup", [this, sample] {
      inputs.writeParams(data, sample);
      if (waitsForBricks() && sample > 0 && (sample == 1 || canPatch(data))) gbuffer.keepColor();
    });
    surfaces.addSteps(data, sample, queue);
    instances.addSteps(data, sample, queue);
    rayCast.addSteps(data, sample, queue);
    counts.addSteps(data, sample, queue);
    ghosts.addSteps(data, sample, queue);
    finish.addSteps(data, sample, queue);
    finishSample(sample);
  }
}

/// Asks whether a sample met bricks that are not there: each, or, where all would begin again, the first and the last.
void FrameWork::finishSample(int sample) {
  bool isAsked = sample == 0 || sample + 1 == samplesOf(data.frame) || canPatch(data);
  if (waitsForBricks() && isAsked) bricks.addCheck(data, [this, sample] { redraw(sample); });
}

/// For all steps that follow. Other GL work that comes in between binds things of its own.
void FrameWork::bind() const {
  inputs.bind();
  upload.bind(data);
  for (const Pass* pass : lighting) pass->bind(data);
  for (const Pass* pass : casting) pass->bind(data);
}

void FrameWork::noteStats() {
  stats.frameMs = queue.totalMs() - upload.frameMs();
  stats.uploadMs = upload.ms();
  stats.longestStepMs = queue.longestMs();
  stats.samples = rayCast.progress().samples;
  stats.pixelsCast = rayCast.pixelsCast();
  stats.labelBytes = upload.labelBytes();
  stats.reduction = isDrawn && data.residency                           ? data.residency->shortfall()
                    : isDrawn && data.volume && !data.volumeKey.isQuick ? data.volume->reduction
                                                                        : "";
  if (std::string words = isDrawn ? upload.labelShortfall(data) : ""; !words.empty())
    stats.reduction += (stats.reduction.empty() ? "" : "; ") + words;
  stats.streaming = isDrawn && data.residency ? data.residency->streaming() : Streaming{};
  if (queue.isEmpty()) stats.passesMs = queue.timesMs();
}

bool FrameWork::look(bool fine) {
  if (!gbuffer) return false;
  inputs.bind();
  const PictureProgress& done = rayCast.progress();
  if (isDrawn && (done.rowsDone > 0 || done.columnsDone > 0)) finish.catchUp(data);
  resolve.draw(data, gbuffer, finish, ghosts, done, fine);
  return true;
}

}  // namespace velum::render
