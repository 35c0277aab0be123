// What a printed plate of a cell promises.
#include <algorithm>
#include <map>

#include "GlFixture.h"
#include "io/phantoms/Virion.h"
#include "model/Levels.h"
#include "render/RenderPicture.h"
#include "scene/Finishes.h"
#include "scene/ModelLooks.h"
#include "scene/Scene.h"

namespace velum {
namespace {

constexpr int kReduced = 500;          // rows at which pictures are compared
constexpr double kMostApart = 4.0;     // of 255, root of the mean square
constexpr double kDark = 0.7;          // of an instance's median tone
constexpr std::size_t kLeastMark = 6;  // pixels
constexpr double kLeastLight = 0.55;   // mean of a dense interior, of the paper's
constexpr double kMostToneApart = 0.02;

class PlateGL : public GlTest {
 protected:
  /// The virion cut in two, as a window opens it and files have it.
  static scene::Scene plate() {
    Progress progress;
    scene::Scene scene;
    scene.unit = LengthUnit::Angstrom;
    scene.model.data = Shared<Model>(io::makeVirion(progress));
    scene.model.levels = Shared<LevelSet>(model::computeLevels(*scene.model.data, progress));
    scene::applyModelLook(scene, "plate");
    scene.rayCast.samplesPerPixel = scene::kModelSamples;
    scene::Cut cut;
    cut.shape = scene::CutShape::Plane;
    cut.axis = {0, -1, 0};
    scene.cuts = {cut};
    scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, 1.0);
    return scene;
  }
  Image draw(const scene::Scene& scene, glm::ivec2 size, const render::Layers& layers = {}) {
    Progress progress;
    render::Frame frame;
    frame.pictureSize = size;
    frame.scene = scene;
    render::Renderer renderer(context());
    return render::renderPicture(renderer, frame, layers, 4096, progress);
  }
  /// Means of squares of pixels, R, G and B.
  static std::vector<float> reduced(const Image& image, int rows) {
    int edge = image.height / rows, width = image.width / edge;
    std::size_t channels = image.channels.size();
    std::vector<float> out(std::size_t(width) * std::size_t(rows) * 3);
    for (int y = 0; y < rows * edge; ++y)
      for (int x = 0; x < width * edge; ++x)
        for (std::size_t c = 0; c < 3; ++c)
          out[(std::size_t(y / edge) * std::size_t(width) + std::size_t(x / edge)) * 3 + c] +=
              image.pixels[(std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * channels + c] /
              float(edge * edge);
    return out;
  }
  /// The virion cut in two, in a finish, of few samples.
  static scene::Scene asWindow(const char* finish) {
    scene::Scene scene = plate();
    scene.rayCast.samplesPerPixel = 2;
    scene::applyFinish(scene, finish);
    return scene;
  }
  static double toneOf(glm::vec3 color) { return double(glm::dot(color, glm::vec3(0.30f, 0.59f, 0.11f))); }
  /// The mean tone of the middle of a picture.
  static double toneOf(const Image& image) {
    double sum = 0.0, count = 0.0;
    std::size_t channels = image.channels.size();
    for (int y = image.height / 4; y < 3 * image.height / 4; ++y)
      for (int x = 0; x < image.width; ++x, ++count) {
        const float* pixel = &image.pixels[(std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * channels];
        sum += toneOf(glm::vec3(pixel[0], pixel[1], pixel[2]));
      }
    return sum / count;
  }
  static double apart(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += double(a[i] - b[i]) * double(a[i] - b[i]);
    return 255.0 * std::sqrt(sum / double(a.size()));
  }
};

TEST_F(PlateGL, APlateLooksAlikeHoweverManyRowsItHas) {
  scene::Scene scene = plate();
  std::map<int, std::vector<float>> seen;
  for (int rows : {1000, 2000, 4000}) seen[rows] = reduced(draw(scene, {rows / 4, rows}), kReduced);
  EXPECT_LT(apart(seen[1000], seen[2000]), kMostApart);
  EXPECT_LT(apart(seen[1000], seen[4000]), kMostApart);
  EXPECT_LT(apart(seen[2000], seen[4000]), kMostApart);
}

/// Strokes and lines of all that lies in a cell would be black.
TEST_F(PlateGL, DenseInteriorsStayLightInEveryFinish) {
  for (const char* finish : {"plate", "pencil", "ink", "engraving", "cartoon"}) {
    scene::Scene scene = asWindow(finish);
    double paper = toneOf(scene.finish.paperColor);
    double tone = toneOf(draw(scene, {250, 1000}));
    EXPECT_GT(tone, kLeastLight * paper) << finish;
  }
}

TEST_F(PlateGL, HatchingIsAsDarkHoweverManyRowsItHas) {
  scene::Scene scene = asWindow("ink");
  EXPECT_NEAR(toneOf(draw(scene, {250, 1000})), toneOf(draw(scene, {1000, 4000})), kMostToneApart);
}

TEST_F(PlateGL, NoDarkMarkInsideAnInstanceIsASpeck) {
  constexpr int kEdge = 1000;
  render::Layers layers;
  layers.instance = true;
  Image image = draw(plate(), {kEdge, kEdge}, layers);
  std::size_t channels = image.channels.size();
  auto id = std::size_t(std::find(image.channels.begin(), image.channels.end(), "instance") - image.channels.begin());
  ASSERT_LT(id, channels);
  auto at = [&](int x, int y) { return &image.pixels[(std::size_t(y) * kEdge + std::size_t(x)) * channels]; };
  auto tone = [&](int x, int y) { return 0.30f * at(x, y)[0] + 0.59f * at(x, y)[1] + 0.11f * at(x, y)[2]; };
  std::map<int, std::vector<float>> tones;
  for (int y = 0; y < kEdge; ++y)
    for (int x = 0; x < kEdge; ++x)
      if (int instance = int(at(x, y)[id])) tones[instance].push_back(tone(x, y));
  std::map<int, float> middle;
  for (auto& [instance, all] : tones) {
    std::nth_element(all.begin(), all.begin() + std::ptrdiff_t(all.size() / 2), all.end());
    middle[instance] = all[all.size() / 2];
  }
  std::vector<char> isDark(std::size_t(kEdge) * kEdge);
  for (int y = 0; y < kEdge; ++y)
    for (int x = 0; x < kEdge; ++x)
      if (int instance = int(at(x, y)[id]))
        isDark[std::size_t(y) * kEdge + std::size_t(x)] = double(tone(x, y)) < kDark * double(middle[instance]);
  int specks = 0;
  std::size_t dark = 0;
  for (int y = 1; y < kEdge - 1; ++y)
    for (int x = 1; x < kEdge - 1; ++x) {
      if (!isDark[std::size_t(y) * kEdge + std::size_t(x)]) continue;
      std::vector<glm::ivec2> mark = {{x, y}};
      isDark[std::size_t(y) * kEdge + std::size_t(x)] = 0;
      bool isInside = true;
      for (std::size_t next = 0; next < mark.size(); ++next)
        for (int i = 0; i < 9; ++i) {
          glm::ivec2 p = glm::clamp(mark[next] + glm::ivec2(i % 3 - 1, i / 3 - 1), 0, kEdge - 1);
          isInside = isInside && at(p.x, p.y)[id] == at(x, y)[id];
          char& flag = isDark[std::size_t(p.y) * kEdge + std::size_t(p.x)];
          if (flag) mark.push_back(p);
          flag = 0;
        }
      dark += mark.size();
      if (isInside && mark.size() < kLeastMark && ++specks < 10)
        ADD_FAILURE() << mark.size() << " dark pixels at " << x << ", " << y;
    }
  EXPECT_EQ(specks, 0);
  EXPECT_GT(dark, std::size_t(kEdge)) << "there are lines";
}

}  // namespace
}  // namespace velum
