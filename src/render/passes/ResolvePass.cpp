#include "render/passes/ResolvePass.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "scene/Finishes.h"

namespace velum::render {

namespace {

ResolveVariant variantOf(const scene::Finish& finish, bool hasGhosts) {
  return {scene::addsAnything(finish), finish.hatching > 0, finish.paper != scene::Paper::None, hasGhosts};
}

}  // namespace

void ResolvePass::draw(const FrameData& data, const Gbuffer& gbuffer, const FinishPass& finish, const GhostPass& ghosts,
                       const PictureProgress& progress, bool fine) {
  ResolveVariant variant = variantOf(data.frame.scene.finish, ghosts.samples() > 0);
  const gpu::Program& program =
      mPrograms.find(variant, [&] { return gpu::Program({"render/resolve.comp"}, definesOf(variant)); });
  glm::ivec2 size = gbuffer.size();
  if (!mPicture || glm::ivec2(mPicture.size()) != size || fine != mIsFine) {
    mPicture = {};  // first, so that there is room; and nothing is half made where there is none
    gpu::Texture made =
        gpu::Texture::make2d("picture", fine ? gpu::Format::Rgba32f : gpu::Format::Rgba8, size, gpu::Filter::Linear);
    mTarget = gpu::Framebuffer("picture", {&made});
    mPicture = std::move(made);
    mIsFine = fine;
  }
  gbuffer.color().bindImage(shared::kColorImage, gpu::Access::Read);
  mPicture.bindImage(shared::kPictureImage, gpu::Access::Write);
  const auto& background = data.frame.scene.background;
  float backdrop = background.transparent ? 0.0f : 1.0f;
  program.set(0, data.frame.windowOrigin);
  program.set(1, progress.samples);
  program.set(2, progress.rowsDone);
  program.set(3, progress.strip);
  program.set(4, progress.columnsDone);
  program.set(5, glm::vec4(background.top, backdrop));
  program.set(6, glm::vec4(background.bottom, fine ? 0.0f : 1.0f));
  if (variant.hasFinish) {
    finish.bindResults();
    gbuffer.bindSample();
    program.set(7, finish.samples());
    program.set(8, finish.rowsDone());
  }
  if (variant.hasGhosts) {
    ghosts.bindResults();
    program.set(9, ghosts.samples());
  }
  gpu::dispatch(program, {(size.x + 7) / 8, (size.y + 7) / 8, 1});
  gpu::barrier();
}

Image ResolvePass::read() const {
  Image image{mPicture.size().x, mPicture.size().y, {"R", "G", "B", "A"}, {}};
  auto take = [&](auto pixels, float most) {
    mPicture.read(pixels.data(), pixels.size() * sizeof(pixels[0]));
    image.pixels.reserve(pixels.size() * 4);
    for (const auto& color : pixels) {
      float alpha = std::min(1.0f, float(color.a) / most);
      for (int c = 0; c < 3; ++c)
        image.pixels.push_back(alpha > 0.0f ? std::min(1.0f, float(color[c]) / most / alpha) : 0.0f);
      image.pixels.push_back(alpha);
    }
  };
  std::size_t count = std::size_t(image.width) * std::size_t(image.height);
  if (mIsFine)
    take(std::vector<glm::vec4>(count), 1.0f);
  else
    take(std::vector<glm::u8vec4>(count), 255.0f);
  return image;
}

}  // namespace velum::render
