#include "session/film/FilmDrawer.h"

#include <algorithm>

#include "core/Memory.h"
#include "gpu/CurrentLimits.h"
#include "render/RenderPicture.h"
#include "scene/SectionPlane.h"
#include "session/Session.h"
#include "session/lettering/SeenSection.h"
#include "session/membrane/Membranes.h"
#include "session/model/TrueLevels.h"
#include "session/picture/Picture.h"

namespace velum::session {

namespace {

constexpr int kNamesAcross = 400;  // pixels of the small pictures in which names look for what they name

int namesStep(glm::ivec2 size) { return std::max(1, std::max(size.x, size.y) / kNamesAcross); }

bool needsContext(const scene::Scene& scene, const FilmOutput& output) {
  return !output.section || hasMembranes(scene);
}

}  // namespace

FilmDrawer::FilmDrawer(const scene::Scene& scene, const FilmOutput& output, render::Renderer* renderer,
                       const gpu::Limits* limits)
    : mOutput(output), mRenderer(renderer), mLimits(limits), mFilm(scene) {
  // What a film changes of the lettering may be whether there are names.
  bool mayHaveNames = needsSeenNames(scene.lettering) ||
                      std::ranges::any_of(scene.timeline.tracks,
                                          [](const auto& track) { return track.path.starts_with("lettering."); });
  if (!mayHaveNames) return;
  mAhead = std::make_unique<Film>(scene);
  mNames.emplace(mFilm.frames(), output.picture.size, namesStep(output.picture.size), output.section,
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
  int step = namesStep(mOutput.picture.size);
  if (mOutput.section) {
    scene::SectionPlane plane = scene::makeSectionPlane(look.scene, *mOutput.section, glm::dvec2(mOutput.picture.size));
    plane = render::coarserPlane(plane, step);
    look.image = seenOfSection(render::drawSection(look.scene, plane), plane, look.scene.background.bottom);
    return look;
  }
  TrueLevels().give(drawn.scene.model, progress);
  drawn.pictureSize = (mOutput.picture.size + step - 1) / step;
  drawn.brickBytes = memoryBudget().gpuBrickBytes;
  render::Layers layers;
  layers.position = layers.structure = layers.instance = true;
  layers.type = bool(drawn.scene.model.data);
  layers.depth = needsSeenPlaces(look.scene.lettering);
  look.image = render::renderPicture(*mRenderer, drawn, layers, mLimits->texture2d, progress);
  return look;
}

/// Measured anew only where the film has changed what is measured: that may take seconds.
const std::map<int, Measured>& FilmDrawer::measured(const scene::Scene& scene, Progress& progress) {
  if (scene.lettering.marks.empty()) return mMeasured;
  scene::Scene of = measuredScene(scene);
  if (of == mMeasuredOf) return mMeasured;
  mMeasured = measuredMarks(scene, progress);
  mMeasuredOf = std::move(of);
  return mMeasured;
}

FilmFrame FilmDrawer::draw(int frame, double share, Progress& progress) {
  Film::Frame at = mFilm.at(frame, share, progress);
  Seen known;
  known.measured = measured(at.drawn, progress);
  std::optional<NamesBetween> names;
  if (mNames && needsSeenNames(at.drawn.lettering)) names = mNames->at(frame, share, at.drawn, progress);
  if (names) known.between = &*names;
  if (mOutput.section)
    return {drawSectionPicture(at.drawn, *mOutput.section, mOutput.picture, progress, &known), std::move(at.scene)};
  Image image = drawPicture(*mRenderer, at.drawn, mOutput.picture, *mLimits, progress, &known);
  return {std::move(image), std::move(at.scene)};
}

FrameSource framesOf(Session& session, const scene::Scene& scene, const FilmOutput& output) {
  expectBlur(output);
  bool draws = needsContext(scene, output);
  render::Renderer* renderer = draws ? &session.renderer() : nullptr;
  auto drawer = std::make_shared<FilmDrawer>(scene, output, renderer, draws ? &gpu::currentLimits() : nullptr);
  auto draw = [&session, drawer, draws](int frame, double share, Progress& progress) {
    if (draws) session.renderer();  // its context becomes current
    return drawer->draw(frame, share, progress);
  };
  return {drawer->count(), draw};
}

FilmReport drawFilm(Session& session, const scene::Scene& scene, FilmOutput output, Progress& progress) {
  output.framesPerSecond = scene.timeline.framesPerSecond;
  expectFilmOutput(output);
  bool draws = needsContext(scene, output);
  std::string driver = draws ? session.renderer().stats().renderer : "no graphics";
  return makeFilm(framesOf(session, scene, output), output, filmIdentity(scene, output, driver), progress);
}

}  // namespace velum::session
