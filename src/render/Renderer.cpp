#include "render/Renderer.h"

#include "gpu/Allocation.h"
#include "gpu/Loss.h"
#include "render/FrameWork.h"
#include "render/Shortage.h"

namespace velum::render {

namespace {

constexpr double kUploadShare = 0.05;  // of a picture's progress

}  // namespace

struct Renderer::Impl {
  explicit Impl(const gpu::Limits& limits)
      : driver(limits), shortage(limits), work(std::make_unique<FrameWork>(limits, limits, Stats{limits.renderer})) {}

  gpu::Limits driver;
  Shortage shortage;
  bool waits = false;  ///< For bricks, see BrickPass::setWaits().
  std::unique_ptr<FrameWork> work;
  unsigned context = gpu::contextNumber();  ///< in which all of it is

  void beginAnew(bool keepsPrograms = true);
  void setWaits(bool now) {
    waits = now;
    work->bricks.setWaits(now);
  }
};

/// What is on the GPU goes before anything new comes.
void Renderer::Impl::beginAnew(bool keepsPrograms) {
  auto next = std::make_unique<FrameWork>(driver, shortage.limits(), work->stats);
  if (keepsPrograms) next->takePrograms(*work);
  next->bricks.setWaits(waits);
  work = std::move(next);
}

Renderer::Renderer(gpu::Context& context) : mImpl(std::make_unique<Impl>(context.limits())), mContext(context) {}
Renderer::~Renderer() = default;

const Stats& Renderer::stats() const { return mImpl->work->stats; }
double Renderer::fractionDone() const {
  // How much there is to draw is known when all is uploaded.
  double done = mImpl->work->queue.fractionDone();
  return mImpl->work->isDrawn ? kUploadShare + (1.0 - kUploadShare) * done : kUploadShare * done;
}

void Renderer::clear() {
  auto next = std::make_unique<Impl>(mContext.limits());
  next->work->stats = stats();
  next->setWaits(mImpl->waits);
  mImpl = std::move(next);
}

/// What was in a context that has been made anew since is made again.
void Renderer::keepUp() {
  if (mImpl->context != gpu::contextNumber()) clear();
}

/// Where the driver has no memory all that was there is given up, and the frame begins anew: first as it is, then with
/// less and less of its data.
bool Renderer::work(const Frame& frame, double budgetMs) {
  keepUp();
  if (mImpl->shortage.endsFor(frame)) mImpl->beginAnew();
  for (;;) {
    try {
      bool isDone = mImpl->work->work(frame, budgetMs);
      gpu::throwIfLost();
      return isDone;
    } catch (const gpu::GpuError& error) {
      gpu::throwIfLost();  // a lost context has no memory either
      auto* refusal = dynamic_cast<const gpu::NoMemory*>(&error);
      bool goesOn = refusal && mImpl->shortage.yield(frame, mImpl->work->framesBegun(), *refusal);
      // With less than the driver has something else may have no room: what was refused at first says it best.
      auto first = goesOn ? std::nullopt : mImpl->shortage.takeRefusal();
      mImpl->beginAnew(refusal != nullptr);  // else a program may be what has failed
      if (first) throw gpu::NoMemory(*first);
      if (!goesOn) throw;
    }
  }
}

void Renderer::render(const Frame& frame, Progress& progress) {
  if (!frame.sheets.empty()) return renderOnce(frame, progress);
  gpu::despiteLoss([&] { renderOnce(frame, progress); });
}

void Renderer::renderOnce(const Frame& frame, Progress& progress) {
  // Who goes on with this renderer piece by piece looks on again, even where this picture is given up.
  struct Waiting {
    std::unique_ptr<Impl>& impl;
    explicit Waiting(std::unique_ptr<Impl>& of) : impl(of) { impl->setWaits(true); }
    ~Waiting() { impl->setWaits(false); }
  } waiting(mImpl);
  while (!work(frame, 100.0)) progress.report(fractionDone(), "rendering");
  mImpl->work->queue.finish();
  mImpl->work->noteStats();
  gpu::throwIfLost();
}

/// Asks something about the frame that is drawn; where it has been lost, about the same one, drawn again.
template <class Question>
auto Renderer::ask(Question question) {
  auto answer = [&] {
    try {
      auto given = question(*mImpl->work);
      gpu::throwIfLost();
      return given;
    } catch (const gpu::NoMemory&) {
      gpu::throwIfLost();
      mImpl->beginAnew();  // what was made for the answer may be half made
      throw;
    }
  };
  if (!mImpl->work->wanted) keepUp();
  const auto& asked = mImpl->work->wanted;
  if (!asked || !asked->sheets.empty()) return answer();
  std::optional<Frame> lost;
  return gpu::despiteLoss([&] {
    if (mImpl->context != gpu::contextNumber()) {
      if (!lost) lost = mImpl->work->wanted;
      Progress quiet;
      renderOnce(*lost, quiet);
    }
    return answer();
  });
}

void Renderer::present(unsigned framebuffer, glm::ivec2 size) {
  keepUp();
  if (mImpl->work->look(false)) mImpl->work->resolve.present(framebuffer, size);
}

Image Renderer::read(const Layers& layers) {
  return ask([&](FrameWork& work) -> Image {
    if (!work.look(layers.isFine)) return {};
    Image image = work.resolve.read();
    work.gbuffer.appendLayers(work.data, layers, image);
    if (layers.ghosts) work.ghosts.appendLayer(image);
    gpu::throwIfExhausted();
    return image;
  });
}

Pick Renderer::pick(glm::ivec2 pixel) {
  return ask([&](FrameWork& work) { return work.gbuffer ? work.gbuffer.pick(work.data, pixel) : Pick{}; });
}

std::optional<InstanceBits> Renderer::bits(bool waits) {
  return ask([&](FrameWork& work) { return work.counts.take(waits); });
}

PixelIds Renderer::idsOfPixels(bool withDistances) {
  return ask(
      [&](FrameWork& work) { return work.gbuffer ? work.gbuffer.idsOfPixels(work.data, withDistances) : PixelIds(); });
}

}  // namespace velum::render
