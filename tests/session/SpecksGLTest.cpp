// Pictures of labelled data, cut and pulled out of the cut: single pixels that differ from all that is around them are
// no anatomy.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>

#include "RenderFixture.h"
#include "TempFolder.h"
#include "scene/Finishes.h"
#include "scene/VisibleFrame.h"
#include "session/document/Open.h"
#include "session/picture/Picture.h"

namespace velum::session {
namespace {

/// What is opened, where it is cut, and what stands out of the cut.
struct SpecksCase {
  const char* name;
  const char* data;            ///< a file of the test data, or a phantom
  const char* labels;          ///< a file; of a phantom none
  glm::dvec3 axis;             ///< of the cut
  double at;                   ///< where along the axis of the data's box, 0..1
  std::set<std::string> soft;  ///< structures that do not stand out
  /// Specks in a hundred thousand pixels, a third more than there are: at 160 voxels vessels of hand and foot are
  /// thinner than one, and dotted.
  double most;
};

void PrintTo(const SpecksCase& one, std::ostream* out) { *out << one.name; }

const SpecksCase kSpecksCases[] = {
    {"trunk", "torso", "", {0, 0, 1}, 0.45, {"skin", "subcutaneous fat", "muscle"}, 620},
    {"heart", "ct_heart_aorta_cta.nii.gz", "ct_heart_aorta_cta_labels.nii.gz", {0, -1, 0}, 0.5, {}, 220},
    {"abdomen", "ct_abdomen_3mm_crop.nii.gz", "ct_abdomen_3mm_crop_organs.nii.gz", {0, -1, 0}, 0.5, {}, 390},
    {"hand", "hand", "", {0, -1, 0}, 0.5, {"skin", "subcutaneous fat", "muscle"}, 1100},
    {"foot", "foot", "", {0, -1, 0}, 0.5, {"skin", "subcutaneous fat", "muscle"}, 820},
};

constexpr int kSpecksSize = 320;
constexpr int kFar = 32;    ///< grey levels from the median that make a speck,
constexpr int kAlike = 16;  ///< unless
constexpr int kFew = 4;     ///< so many around it are as near to it: an edge, or a line

/// Pixels that no edge explains: of the 5 x 5 around one the median is far off, and hardly any is like it.
int specksIn(const Image& image) {
  std::vector<int> grey;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      auto of = [&](const char* channel) { return 255.0 * double(sampleOf(image, {x, y}, channel)); };
      grey.push_back(int(0.2126 * of("R") + 0.7152 * of("G") + 0.0722 * of("B") + 0.5));
    }
  int specks = 0;
  std::array<int, 25> around{};
  for (int y = 2; y + 2 < image.height; ++y)
    for (int x = 2; x + 2 < image.width; ++x) {
      int own = grey[std::size_t(y * image.width + x)], alike = -1;  // itself
      for (int n = 0; n < 25; ++n) {
        int there = grey[std::size_t((y + n / 5 - 2) * image.width + x + n % 5 - 2)];
        around[std::size_t(n)] = there;
        alike += std::abs(there - own) <= kAlike;
      }
      if (alike >= kFew) continue;
      std::nth_element(around.begin(), around.begin() + 12, around.end());
      specks += std::abs(own - around[12]) > kFar;
    }
  return specks;
}

class SpecksGL : public RenderTest, public testing::WithParamInterface<SpecksCase> {
 protected:
  void SetUp() override {
    RenderTest::SetUp();
    if (std::getenv("VELUM_TEST_DRIVER")) GTEST_SKIP() << "pictures are judged on the driver that is there";
    const SpecksCase& one = GetParam();
    Progress progress;
    if (!*one.labels) {
      mScene = openSample(one.data, 160, mFolder.path(), progress);
    } else {
      const char* folder = std::getenv("VELUM_TEST_DATA");
      if (!folder) GTEST_SKIP() << "VELUM_TEST_DATA names no folder of data";
      std::string at = std::string(folder) + "/volumes/";
      std::vector<std::string> notes;
      mScene = openAll(sourcesOf({at + one.data, at + one.labels}), progress, {}, &notes).scene;
    }
    scene::Cut cut;
    cut.axis = one.axis;
    scene::Bounds box = scene::computeBounds(mScene);
    cut.centre = box.min + one.at * (box.max - box.min);
    for (const scene::Structure& structure : mScene.labels.structures)
      if (!one.soft.count(structure.name)) cut.spares.push_back({structure.id});
    scene::addCut(mScene, cut);
    mScene.camera = scene::frameVisible(mScene, scene::StandardView::Oblique, 1.0);
    mScene.rayCast.samplesPerPixel = 4;
  }
  void expectFew(const char* way) {
    PictureOptions options;
    options.size = {kSpecksSize, kSpecksSize};
    Progress progress;
    Image image = drawPicture(renderer(), mScene, options, context().limits(), progress);
    double specks = specksIn(image) * 1e5 / (kSpecksSize * kSpecksSize);
    std::printf("%s, %s: %.1f specks in a hundred thousand pixels\n", GetParam().name, way, specks);
    EXPECT_LE(specks, GetParam().most) << way;
    if (const char* shots = std::getenv("VELUM_SHOTS"))
      savePicture(image, mScene, options, fmt::format("{}/{}-{}.png", shots, GetParam().name, way));
  }
  TempFolder mFolder;
  scene::Scene mScene;
};

TEST_P(SpecksGL, NoPixelStandsAlone) {
  expectFew("plain");
  scene::applyFinish(mScene, "plate");
  mScene.finish.contours = 0.0;  // lines are as thin as specks
  expectFew("plate");
}

INSTANTIATE_TEST_SUITE_P(Data, SpecksGL, testing::ValuesIn(kSpecksCases),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace velum::session
