// A model whose levels of detail are not there yet is drawn, and what lasts is drawn as if they had been there.
#include <cmath>

#include "GlFixture.h"
#include "makeModel.h"
#include "model/Levels.h"
#include "render/RenderPicture.h"
#include "render/Renderer.h"
#include "scene/VisibleFrame.h"
#include "session/Session.h"
#include "session/picture/Picture.h"

namespace velum::session {
namespace {

class QuickLevelsGL : public GlTest {
 protected:
  scene::Scene with(LevelSet levels) {
    scene::Scene scene;
    scene.unit = LengthUnit::Angstrom;
    scene.model.data = mModel;
    scene.model.levels = Shared<LevelSet>(std::move(levels));
    scene.model.detail = 4.0;  // coarse levels, in which the two differ most
    scene.rayCast.samplesPerPixel = 1;
    scene.camera = scene::firstCamera(scene, 1.0);
    return scene;
  }
  scene::Scene quick() { return with(model::makeQuickLevels(*mModel, mProgress)); }
  scene::Scene whole() { return with(model::computeLevels(*mModel, mProgress)); }
  Image drawn(const scene::Scene& scene) {
    render::Renderer renderer(context());
    render::Frame frame;
    frame.scene = scene;
    frame.pictureSize = {kEdge, kEdge};
    return render::renderPicture(renderer, frame, {}, kEdge, mProgress);
  }
  static constexpr int kEdge = 200;
  Progress mProgress;
  Shared<Model> mModel{ModelMaker{.types = 4, .atoms = 900, .instances = 120, .moleculeRadius = 24.0f}.make()};
};

/// The share of pixels that differ by more than a quarter of the range.
double shareThatDiffers(const Image& a, const Image& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); i += 4) {
    float most = 0.0f;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(a.pixels[i + c] - b.pixels[i + c]));
    count += most > 0.25f ? 1 : 0;
  }
  return double(count) / (double(a.pixels.size()) / 4.0);
}

TEST_F(QuickLevelsGL, ThePictureLooksLikeThatOfAllAtomsIfLessThanTheOneThatTakesItsPlace) {
  scene::Scene fine = whole();
  fine.model.detail = 0.1;
  Image first = drawn(quick()), last = drawn(whole()), atoms = drawn(fine);
  ASSERT_EQ(first.pixels.size(), last.pixels.size());
  EXPECT_NE(first.pixels, last.pixels);
  EXPECT_GT(shareThatDiffers(last, atoms), 0.0);
  // Levels that are four pixels off, of which a window shows none at rest: 6.8 % of the pixels where it was 2.9.
  EXPECT_LT(shareThatDiffers(first, atoms), 3.0 * shareThatDiffers(last, atoms));
}

TEST_F(QuickLevelsGL, WhenTheLevelsHaveArrivedThePictureIsTheOneDrawnWithThemFromTheStart) {
  Session session(quick());
  session.borrowContext();
  session.settle(mProgress);
  EXPECT_EQ(drawn(session.scene()).pixels, drawn(whole()).pixels);
}

TEST_F(QuickLevelsGL, APictureToKeepIsDrawnWithAllLevels) {
  render::Renderer renderer(context());
  PictureOptions options;
  options.size = {kEdge, kEdge};
  Image kept = drawPicture(renderer, quick(), options, context().limits(), mProgress);
  EXPECT_EQ(kept.pixels, drawPicture(renderer, whole(), options, context().limits(), mProgress).pixels);
}

TEST_F(QuickLevelsGL, CountsAreThoseOfAllLevels) {
  render::Renderer renderer(context());
  PictureCounter counter(renderer, {kEdge, kEdge}, context().limits(), mProgress);
  std::vector<std::uint32_t> shown = counter.count(quick()).shown;
  EXPECT_EQ(shown, counter.count(whole()).shown);
}

}  // namespace
}  // namespace velum::session
