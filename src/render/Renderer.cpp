#include "render/Renderer.h"

#include <optional>

#include "gpu/Loss.h"
#include "render/RendererImpl.h"

namespace velum::render {

namespace {

constexpr double kUploadShare = 0.05;  // of a picture's progress

}  // namespace

Renderer::Renderer(gpu::Context& context)
    : mImpl(std::make_unique<Impl>(context, Stats{context.limits().renderer})),
      mNumber(gpu::contextNumber()),
      mContext(context) {}
Renderer::~Renderer() = default;

const Stats& Renderer::stats() const { return mImpl->stats; }
double Renderer::fractionDone() const {
  // How much there is to draw is known when all is uploaded.
  double done = mImpl->queue.fractionDone();
  return mImpl->isDrawn ? kUploadShare + (1.0 - kUploadShare) * done : kUploadShare * done;
}

void Renderer::clear() {
  mImpl = std::make_unique<Impl>(mContext, mImpl->stats);
  mNumber = gpu::contextNumber();
}

/// What was in a context that has been made anew since is made again.
void Renderer::keepUp() {
  if (mNumber != gpu::contextNumber()) clear();
}

bool Renderer::work(const Frame& frame, double budgetMs) {
  keepUp();
  Impl& m = *mImpl;
  if (!m.wanted || !(*m.wanted == frame)) m.begin(frame);
  if (m.queue.isEmpty()) return true;
  if (m.isDrawn) m.bind();
  bool isDone = false;
  try {
    isDone = m.queue.work(budgetMs);
  } catch (...) {
    m.wanted.reset();  // a frame that has failed half way begins anew
    gpu::throwIfLost();
    throw;
  }
  gpu::throwIfLost();
  // Where the processor draws nothing goes on meanwhile, and the last piece counts, too.
  if (isDone && m.limits.isSoftware) m.queue.finish();
  m.noteStats();
  return isDone;
}

void Renderer::render(const Frame& frame, Progress& progress) {
  if (!frame.sheets.empty()) return renderOnce(frame, progress);
  gpu::despiteLoss([&] { renderOnce(frame, progress); });
}

void Renderer::renderOnce(const Frame& frame, Progress& progress) {
  keepUp();
  // Who goes on with this renderer piece by piece looks on again, even where this picture is given up.
  struct Waiting {
    BrickPass& bricks;
    explicit Waiting(BrickPass& of) : bricks(of) { bricks.setWaits(true); }
    ~Waiting() { bricks.setWaits(false); }
  } waiting(mImpl->bricks);
  while (!work(frame, 100.0)) progress.report(fractionDone(), "rendering");
  mImpl->queue.finish();
  mImpl->noteStats();
  gpu::throwIfLost();
}

/// Asks something about the frame that is drawn; where it has been lost, about the same one, drawn again.
template <class Question>
auto Renderer::ask(Question question) {
  auto answer = [&] {
    auto given = question();
    gpu::throwIfLost();
    return given;
  };
  if (!mImpl->wanted || !mImpl->wanted->sheets.empty()) return answer();
  std::optional<Frame> lost;
  return gpu::despiteLoss([&] {
    if (mNumber != gpu::contextNumber()) {
      if (!lost) lost = mImpl->wanted;
      Progress quiet;
      renderOnce(*lost, quiet);
    }
    return answer();
  });
}

void Renderer::present(unsigned framebuffer, glm::ivec2 size) {
  if (mImpl->look(false)) mImpl->resolve.present(framebuffer, size);
}

Image Renderer::read(const Layers& layers) {
  return ask([&]() -> Image {
    if (!mImpl->look(layers.isFine)) return {};
    Image image = mImpl->resolve.read();
    mImpl->gbuffer.appendLayers(mImpl->data, layers, image);
    if (layers.ghosts) mImpl->ghosts.appendLayer(image);
    return image;
  });
}

Pick Renderer::pick(glm::ivec2 pixel) {
  return ask([&] { return mImpl->gbuffer ? mImpl->gbuffer.pick(mImpl->data, pixel) : Pick{}; });
}

std::optional<InstanceBits> Renderer::bits(bool waits) {
  return ask([&] { return mImpl->counts.take(waits); });
}

PixelIds Renderer::idsOfPixels(bool withDistances) {
  return ask([&] { return mImpl->gbuffer ? mImpl->gbuffer.idsOfPixels(mImpl->data, withDistances) : PixelIds(); });
}

}  // namespace velum::render
