// What is laid over the picture that stands while a hand pulls, against rays through the labels.
#include "session/extrusion/PulledPicture.h"

#include <gtest/gtest.h>

#include "makeVolume.h"
#include "scene/Project.h"
#include "session/cut/CutEdit.h"
#include "session/extrusion/Extrusion.h"

namespace velum::session {
namespace {

constexpr int kPictureEdge = 64;
constexpr glm::ivec2 kPulledPictureSize(240, 200);
const glm::dvec3 kPulledPictureMiddle(31.5);

bool isBall(glm::dvec3 p) { return glm::distance(p, kPulledPictureMiddle) < 20.0; }

class PulledPictures : public testing::Test {
 protected:
  void SetUp() override {
    glm::ivec3 dims(kPictureEdge);
    mScene.volume.data = Shared<Volume>(
        makeVolume(dims, SampleType::Int16, [](glm::ivec3 v) { return isBall(glm::dvec3(v)) ? 900.0 : -900.0; }));
    mScene.volume.transfer.opacities = {{0, 0}, {500, 1}};
    mScene.volume.transfer.colors = {{-1000, glm::vec3(0, 0, 1)}, {800, glm::vec3(1, 0, 0)}};
    mScene.labels.data =
        Shared<LabelVolume>(makeLabels(dims, [](glm::ivec3 v) { return isBall(glm::dvec3(v)) ? 3 : 0; }));
    scene::Structure row;
    row.id = 3;
    row.color = {0, 1, 0};
    row.tint = 0.0;
    mScene.labels.structures = {row};
    scene::Cut cut;
    cut.axis = {0, -1, 0};
    cut.centre = kPulledPictureMiddle;
    mCut = scene::addCut(mScene, cut);
    mScene.camera =
        scene::frameCamera(mScene, scene::StandardView::Oblique, double(kPulledPictureSize.x) / kPulledPictureSize.y);
  }
  PulledPicture draw(double distance, double before = 0.0) const {
    Progress progress;
    return drawPulled(mScene, {{mCut, 3, distance, before}}, kPulledPictureSize, progress);
  }
  static std::uint32_t at(const PulledPicture& picture, glm::ivec2 p) {
    return picture.pixels[std::size_t(p.y * picture.width + p.x)];
  }
  /// Whether a ray meets the ball between two depths, shrunk or swollen by some voxels.
  bool meets(glm::ivec2 pixel, double from, double to, double swollen) const {
    scene::PictureRay ray = scene::rayFromPixel(mScene.camera, glm::dvec2(kPulledPictureSize), glm::dvec2(pixel) + 0.5);
    for (double t = 0.0; t < 600.0; t += 0.25) {
      glm::dvec3 p = ray.origin + t * ray.direction;
      double depth = kPulledPictureMiddle.y - p.y;
      if (glm::distance(p, kPulledPictureMiddle) < 20.0 + swollen && depth > from - swollen && depth < to + swollen)
        return true;
    }
    return false;
  }
  scene::Scene mScene;
  int mCut = 0;
};

TEST_F(PulledPictures, CoverWhatStandsOutAndNothingElse) {
  for (auto projection : {scene::Projection::Perspective, scene::Projection::Orthographic})
    for (double distance : {4.0, 11.0, 30.0}) {
      mScene.camera.projection = projection;
      PulledPicture picture = draw(distance);
      ASSERT_EQ(picture.pixels.size(), std::size_t(kPulledPictureSize.x * kPulledPictureSize.y));
      int seen = 0;
      for (glm::ivec2 p(2); p.y < kPulledPictureSize.y; p.y += 5)
        for (p.x = 2; p.x < kPulledPictureSize.x; p.x += 5) {
          SCOPED_TRACE(testing::Message() << p.x << " " << p.y << " at " << distance);
          // A voxel is drawn as a square a little larger than itself.
          if (meets(p, 0.0, distance, -1.5)) {
            EXPECT_NE(at(picture, p), 0u);
            ++seen;
          } else if (!meets(p, 0.0, distance, 2.0)) {
            EXPECT_EQ(at(picture, p), 0u);
          }
        }
      EXPECT_GT(seen, 50);
    }
}

TEST_F(PulledPictures, HaveTheCurvesColoursUntilTheStructureHasItsOwn) {
  glm::dvec2 middle = *scene::pixelFromWorld(mScene.camera, glm::dvec2(kPulledPictureSize),
                                             kPulledPictureMiddle + glm::dvec3(0, -10, 0));
  glm::ivec2 place(glm::floor(middle));
  std::uint32_t byValue = at(draw(10.0), place);
  EXPECT_GT(byValue >> 16 & 255, 60u);
  EXPECT_EQ(byValue >> 8 & 255, 0u);
  mScene.labels.structures[0].tint = 1.0;
  std::uint32_t own = at(draw(10.0), place);
  EXPECT_EQ(own >> 16 & 255, 0u);
  EXPECT_GT(own >> 8 & 255, 60u);
}

TEST_F(PulledPictures, DimWhatHasGoneBack) {
  PulledPicture farther = draw(12.0), back = draw(5.0, 12.0), never = draw(5.0);
  int dimmed = 0;
  for (std::size_t i = 0; i < back.pixels.size(); ++i) {
    if (never.pixels[i] != 0) {
      EXPECT_EQ(back.pixels[i], never.pixels[i]) << "what is there is drawn as it is";
    } else {
      EXPECT_EQ(back.pixels[i] != 0, farther.pixels[i] != 0);
      dimmed += back.pixels[i] != 0;
      EXPECT_LT(back.pixels[i] >> 24, 255u) << "what stands is seen through it";
    }
  }
  EXPECT_GT(dimmed, 100);
}

TEST_F(PulledPictures, OfAWedgeShowWhatBothOfItsPlanesRemove) {
  scene::Cut second;
  second.axis = {1, 0, 0};
  second.centre = kPulledPictureMiddle;
  second.joined = true;
  scene::addCut(mScene, second);
  mScene.camera =
      scene::frameCamera(mScene, scene::StandardView::Anterior, double(kPulledPictureSize.x) / kPulledPictureSize.y);
  auto seen = [&] {
    PulledPicture picture = draw(30.0);
    int left = 0, right = 0;
    for (glm::ivec2 p(0); p.y < kPulledPictureSize.y; ++p.y)
      for (p.x = 0; p.x < kPulledPictureSize.x; ++p.x)
        (p.x < kPulledPictureSize.x / 2 ? left : right) += at(picture, p) != 0;
    return glm::ivec2(left, right);
  };
  glm::ivec2 wedge = seen();
  mScene.cuts[1].enabled = false;
  glm::ivec2 whole = seen();
  EXPECT_GT(glm::min(whole.x, whole.y), 1000);
  EXPECT_NEAR(whole.x, whole.y, 0.05 * whole.x);
  EXPECT_LT(glm::min(wedge.x, wedge.y), 0.05 * whole.x) << "what the second plane keeps is in the picture that stands";
  EXPECT_GT(glm::max(wedge.x, wedge.y), 0.95 * whole.x);
}

TEST_F(PulledPictures, AreLitAsSurfacesAndNotVoxelByVoxel) {
  // Noise in the values; the end of what is pulled is flat.
  std::uint32_t state = 1;
  mScene.volume.data = Shared<Volume>(makeVolume(glm::ivec3(kPictureEdge), SampleType::Int16, [&](glm::ivec3 v) {
    state = state * 1664525u + 1013904223u;
    return (isBall(glm::dvec3(v)) ? 900.0 : -900.0) + double(state >> 24) - 128.0;
  }));
  mScene.camera =
      scene::frameCamera(mScene, scene::StandardView::Anterior, double(kPulledPictureSize.x) / kPulledPictureSize.y);
  PulledPicture picture = draw(4.0);
  glm::ivec2 middle(
      glm::floor(*scene::pixelFromWorld(mScene.camera, glm::dvec2(kPulledPictureSize), kPulledPictureMiddle)));
  int least = 255, most = 0;
  for (int y = -10; y <= 10; ++y)
    for (int x = -10; x <= 10; ++x) {
      int red = at(picture, middle + glm::ivec2(x, y)) >> 16 & 255;
      least = std::min(least, red), most = std::max(most, red);
    }
  EXPECT_GT(least, 150);
  EXPECT_LT(most - least, 12);
}

TEST_F(PulledPictures, ShowNothingOfAFaceThatIsSeenFromBehind) {
  mScene.cuts[0].invert = true;
  for (auto projection : {scene::Projection::Perspective, scene::Projection::Orthographic}) {
    mScene.camera.projection = projection;
    PulledPicture picture = draw(10.0);
    EXPECT_TRUE(std::all_of(picture.pixels.begin(), picture.pixels.end(), [](auto pixel) { return pixel == 0; }));
  }
}

TEST_F(PulledPictures, CanBeGivenUp) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(drawPulled(mScene, {{mCut, 3, 10.0, 0.0}}, kPulledPictureSize, progress), Cancelled);
}

}  // namespace
}  // namespace velum::session
