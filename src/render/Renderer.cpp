#include "render/Renderer.h"

#include "gpu/GpuError.h"
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

  void beginAnew();
};

/// What is on the GPU goes before anything new comes.
void Renderer::Impl::beginAnew() {
  auto next = std::make_unique<FrameWork>(driver, shortage.limits(), work->stats);
  next->takePrograms(*work);
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
  Stats known = stats();
  mImpl = std::make_unique<Impl>(mContext.limits());
  mImpl->work->stats = known;
}

/// Where the driver has no memory all that was there is given up, and the frame begins anew: first as it is, then with
/// less and less of its data.
bool Renderer::work(const Frame& frame, double budgetMs) {
  if (mImpl->shortage.endsFor(frame)) mImpl->beginAnew();
  for (;;) {
    try {
      return mImpl->work->work(frame, budgetMs);
    } catch (const gpu::GpuError& error) {
      auto* refusal = dynamic_cast<const gpu::NoMemory*>(&error);
      bool goesOn = refusal && mImpl->shortage.yield(frame, mImpl->work->framesBegun(), *refusal);
      // With less than the driver has something else may have no room: what was refused at first says it best.
      auto first = goesOn ? std::nullopt : mImpl->shortage.takeRefusal();
      mImpl->beginAnew();
      if (first) throw gpu::NoMemory(*first);
      if (!goesOn) throw;
    }
  }
}

void Renderer::render(const Frame& frame, Progress& progress) {
  // Who goes on with this renderer piece by piece looks on again, even where this picture is given up.
  struct Waiting {
    Impl& impl;
    explicit Waiting(Impl& of) : impl(of) { set(true); }
    ~Waiting() { set(false); }
    void set(bool waits) const {
      impl.waits = waits;
      impl.work->bricks.setWaits(waits);
    }
  } waiting(*mImpl);
  while (!work(frame, 100.0)) progress.report(fractionDone(), "rendering");
  mImpl->work->queue.finish();
  mImpl->work->noteStats();
}

void Renderer::present(unsigned framebuffer, glm::ivec2 size) {
  if (mImpl->work->look(false)) mImpl->work->resolve.present(framebuffer, size);
}

Image Renderer::read(const Layers& layers) {
  if (!mImpl->work->look(layers.isFine)) return {};
  Image image = mImpl->work->resolve.read();
  mImpl->work->gbuffer.appendLayers(mImpl->work->data, layers, image);
  if (layers.ghosts) mImpl->work->ghosts.appendLayer(image);
  return image;
}

Pick Renderer::pick(glm::ivec2 pixel) const {
  return mImpl->work->gbuffer ? mImpl->work->gbuffer.pick(mImpl->work->data, pixel) : Pick{};
}

std::optional<InstanceBits> Renderer::bits(bool waits) { return mImpl->work->counts.take(waits); }

PixelIds Renderer::idsOfPixels(bool withDistances) const {
  return mImpl->work->gbuffer ? mImpl->work->gbuffer.idsOfPixels(mImpl->work->data, withDistances) : PixelIds();
}

}  // namespace velum::render
