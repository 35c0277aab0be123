#include "session/film/FilmDrawer.h"

#include <algorithm>

#include "core/Memory.h"
#include "render/RenderPicture.h"
#include "session/model/TrueLevels.h"
#include "session/picture/Picture.h"

namespace velum::session {

namespace {

constexpr int kNamesAcross = 400;  // pixels of the small pictures in which names look for what they name

int namesStep(glm::ivec2 size) { return std::max(1, std::max(size.x, size.y) / kNamesAcross); }

}  // namespace

FilmDrawer::FilmDrawer(const scene::Scene& scene, const FilmOutput& output, render::Renderer* renderer,
                       const gpu::Limits* limits)
    : mOutput(output), mRenderer(renderer), mLimits(limits), mFilm(scene) {
  if (output.section || !needsSeenNames(scene.lettering)) return;
  mAhead = std::make_unique<Film>(scene);
  mNames.emplace(mFilm.frames(), output.picture.size, namesStep(output.picture.size),
                 [this](int frame, Progress& progress) { return lookAt(frame, progress); });
}

/// Without all that changes nothing of what is where.
FilmNames::Look FilmDrawer::lookAt(int frame, Progress& progress) {
  render::Frame drawn;
  drawn.scene = mAhead->at(frame, 0.0, progress).drawn;
  FilmNames::Look look{{}, drawn.scene};
  drawn.scene.finish = {};
  drawn.scene.lettering = {};
  drawn.scene.rayCast.samplesPerPixel = 1;
  TrueLevels().give(drawn.scene.model, progress);
  int step = namesStep(mOutput.picture.size);
  drawn.pictureSize = (mOutput.picture.size + step - 1) / step;
  drawn.brickBytes = memoryBudget().gpuBrickBytes;
  render::Layers layers;
  layers.position = layers.structure = layers.instance = true;
  layers.type = bool(drawn.scene.model.data);
  look.image = render::renderPicture(*mRenderer, drawn, layers, mLimits->texture2d, progress);
  return look;
}

FilmFrame FilmDrawer::draw(int frame, double share, Progress& progress) {
  Film::Frame at = mFilm.at(frame, share, progress);
  if (mOutput.section)
    return {drawSectionPicture(at.drawn, *mOutput.section, mOutput.picture, progress), std::move(at.scene)};
  std::optional<NamesBetween> names;
  if (mNames) names = mNames->at(frame, share, at.drawn, progress);
  Image image = drawPicture(*mRenderer, at.drawn, mOutput.picture, *mLimits, progress, names ? &*names : nullptr);
  return {std::move(image), std::move(at.scene)};
}

}  // namespace velum::session
