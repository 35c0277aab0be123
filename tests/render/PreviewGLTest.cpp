// Previews are pictures at once: of a small copy while the volume is on its way, and in the light of the last picture.
#include "RenderFixture.h"
#include "render/RenderPicture.h"

namespace velum {
namespace {

constexpr glm::ivec3 kPreviewDims(200, 150, 120);

class PreviewGL : public RenderTest {
 protected:
  static scene::Scene ballScene() {
    scene::Scene scene = sceneOf(makeVolume(
        kPreviewDims, SampleType::UInt8,
        [](glm::ivec3 p) { return glm::length(glm::vec3(p - kPreviewDims / 2)) < 45.0f ? 200.0 : 0.0; },
        centredFrame(kPreviewDims)));
    scene.volume.transfer.colors = {{0, {1, 0.8f, 0.6f}}};
    scene.volume.transfer.opacities = {{90, 0}, {130, 0.9}};
    scene.lighting.shaded = true;
    scene.lighting.shadow = scene.lighting.occlusion = 0;
    lookAlong(scene, {0.3, -1, 0.4}, 400);
    return scene;
  }
  Image preview(const scene::Scene& scene) {
    render::Frame frame = frameOf(scene, {96, 96});
    frame.isPreview = true;
    Progress progress;
    return render::renderPicture(renderer(), frame, {}, 4096, progress);
  }
};

TEST_F(PreviewGL, ASmallCopyLooksLikeTheVolume) {
  Image small = preview(ballScene());
  EXPECT_TRUE(renderer().stats().reduction.empty()) << "a preview is no reduction to speak of";
  Image whole = draw(ballScene());
  EXPECT_GT(differenceOf(small, whole).mean, 0.0) << "the copy has fewer voxels";
  EXPECT_LT(differenceOf(small, whole).mean, 4.0);
}

TEST_F(PreviewGL, OnceTheVolumeIsThereAPreviewShowsIt) {
  scene::Scene scene = ballScene();
  Image whole = draw(scene);
  expectIdentical(preview(scene), whole, "preview after the whole");
}

TEST_F(PreviewGL, ThePictureDoesNotDependOnPreviewsBefore) {
  scene::Scene scene = ballScene();
  scene.lighting.shadow = scene.lighting.occlusion = 0.8;
  Image alone = draw(scene);
  renderer().clear();
  preview(scene);
  expectIdentical(draw(scene), alone, "after a preview of the small copy");
  scene::Scene turned = scene;
  lookAlong(turned, {1, -0.2, 0.1}, 400);
  preview(turned);
  expectIdentical(draw(scene), alone, "after a preview from elsewhere");
}

TEST_F(PreviewGL, ShadowsStayAndNoneAreMade) {
  scene::Scene scene = ballScene();
  scene.lighting.shadow = 1.0;
  preview(scene);
  EXPECT_FALSE(renderer().stats().passesMs.contains("Light"));
  draw(scene);
  EXPECT_TRUE(renderer().stats().passesMs.contains("Light"));
  Image still = draw(scene);
  expectIdentical(preview(scene), still, "the same camera in the same light");
  lookAlong(scene, {1, -0.2, 0.1}, 400);
  preview(scene);
  EXPECT_FALSE(renderer().stats().passesMs.contains("Light"));
}

}  // namespace
}  // namespace velum
