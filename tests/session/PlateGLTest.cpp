// Plates: drawings in layers, compared with the pictures of pixels that they stand for.
#include "session/plate/Plate.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "GlFixture.h"
#include "core/ImageChannels.h"
#include "makeVolume.h"
#include "scene/Finishes.h"
#include "scene/Scene.h"
#include "session/picture/Picture.h"
#include "vector/Paint.h"

namespace velum::session {

namespace {

constexpr glm::ivec2 kPlateSize(240, 180);

class PlateGL : public GlTest {
 protected:
  static void SetUpTestSuite() {
    context().makeCurrent();
    sRenderer = new render::Renderer(context());
  }
  static void TearDownTestSuite() {
    context().makeCurrent();
    delete sRenderer;
  }
  /// Two balls that meet, each a structure, seen from the front on paper of one colour.
  static scene::Scene twoBalls() {
    scene::Scene scene;
    glm::ivec3 dims(48);
    auto ball = [](glm::ivec3 v, double x) { return glm::distance(glm::dvec3(v), glm::dvec3(x, 24, 24)) < 11.0; };
    scene.labels.data = Shared<LabelVolume>(makeLabels(dims, [&](glm::ivec3 v) {
      return ball(v, 15) ? 1 : ball(v, 33) ? 2 : 0;
    }));
    scene.labels.structures = {{1, "left"}, {2, "right"}};
    scene.labels.structures[0].color = {0.8f, 0.5f, 0.4f};
    scene.labels.structures[1].color = {0.5f, 0.6f, 0.8f};
    scene.lighting.shaded = false;
    scene.background.top = scene.background.bottom = glm::vec3(1.0f);
    scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, double(kPlateSize.x) / kPlateSize.y);
    scene.finish.contours = 1.0;
    scene.finish.contourWidth = 12.0;
    return scene;
  }
  static PictureOptions options() { return {kPlateSize, 4, false, false, 0}; }
  static vector::Drawing plateOf(const scene::Scene& scene) {
    return drawPlate(*sRenderer, scene, options(), context().limits(), sProgress);
  }
  static const vector::Layer* layer(const vector::Drawing& drawing, const std::string& name) {
    auto found = std::ranges::find(drawing.layers, name, &vector::Layer::name);
    return found == drawing.layers.end() ? nullptr : &*found;
  }
  static std::vector<std::string> wordsOf(const vector::Layer& layer) {
    std::vector<std::string> words;
    for (const vector::Item& item : layer.items)
      if (const auto* text = std::get_if<vector::Words>(&item)) words.push_back(text->text);
    return words;
  }
  static inline render::Renderer* sRenderer = nullptr;
  static inline Progress sProgress;
};

/// The mean difference of two pictures' colours, 0..1.
double meanDifference(const Image& a, const Image& b) {
  double sum = 0.0;
  std::size_t n = a.channels.size(), m = b.channels.size(), count = a.pixels.size() / n;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < 3; ++c) sum += std::abs(a.pixels[i * n + c] - b.pixels[i * m + c]);
  return sum / double(3 * count);
}

}  // namespace

TEST_F(PlateGL, ItsLayersAreNamedAndTogetherTheyAreThePicture) {
  scene::Scene scene = twoBalls();
  scene.lettering.scaleBar = scene.lettering.names = true;
  vector::Drawing drawing = plateOf(scene);
  std::vector<std::string> names;
  for (const vector::Layer& one : drawing.layers) names.push_back(one.name);
  EXPECT_EQ(names, (std::vector<std::string>{"paper", "plate", "contours", "leaders", "labels", "scale bar"}));
  Image painted{kPlateSize.x, kPlateSize.y, {"R", "G", "B"}, {}};
  painted.pixels.assign(std::size_t(3 * kPlateSize.x * kPlateSize.y), 0.0f);
  vector::paint(std::span<const vector::Layer>(drawing.layers), painted);
  Image picture = drawPicture(*sRenderer, scene, options(), context().limits(), sProgress);
  EXPECT_LT(meanDifference(painted, picture), 0.02);
  scene::Scene without = scene;
  without.finish.contours = 0.0;
  Image bare = drawPicture(*sRenderer, without, options(), context().limits(), sProgress);
  EXPECT_GT(meanDifference(bare, picture), 2.0 * meanDifference(painted, picture)) << "lines are what is compared";
}

TEST_F(PlateGL, EachStructureHasClosedContoursOfItsName) {
  vector::Drawing drawing = plateOf(twoBalls());
  const vector::Layer* contours = layer(drawing, "contours");
  ASSERT_TRUE(contours);
  std::set<std::string> closed;
  for (const vector::Item& item : contours->items) {
    const auto& shape = std::get<vector::Shape>(item);
    ASSERT_TRUE(shape.pen);
    if (!shape.outlines.empty() && std::ranges::all_of(shape.outlines, &vector::Outline::isClosed))
      closed.insert(shape.name);
  }
  EXPECT_TRUE(closed.contains("left") && closed.contains("right"));
}

TEST_F(PlateGL, WithoutLinesOfTheFinishThereAreNoneAndTheTransparentHaveNoPaper) {
  scene::Scene scene = twoBalls();
  scene.finish.contours = 0.0;
  EXPECT_FALSE(layer(plateOf(scene), "contours"));
  scene.background.transparent = true;
  EXPECT_FALSE(layer(plateOf(scene), "paper"));
}

TEST_F(PlateGL, NamesArePointedAtWhatIsSeen) {
  scene::Scene scene = twoBalls();
  scene.lettering.names = true;
  vector::Drawing drawing = plateOf(scene);
  std::vector<std::string> words = wordsOf(*layer(drawing, "labels"));
  std::ranges::sort(words);
  EXPECT_EQ(words, (std::vector<std::string>{"left", "right"}));
  // Each leader ends at its structure: of the two balls the left one is on the right, the patient's left.
  Image picture = drawPicture(*sRenderer, scene, {kPlateSize, 1, false, true, 0}, context().limits(), sProgress);
  int id = channelIndex(picture, "id");
  for (const vector::Item& item : layer(drawing, "leaders")->items) {
    const auto* shape = std::get_if<vector::Shape>(&item);
    if (!shape || !shape->fill) continue;
    glm::dvec2 end = 0.5 * (shape->outlines[0].start + shape->outlines[0].curves[1].end);
    std::size_t pixel = std::size_t(int(end.y)) * std::size_t(kPlateSize.x) + std::size_t(int(end.x));
    EXPECT_EQ(picture.pixels[pixel * picture.channels.size() + std::size_t(id)], shape->name == "left" ? 1.0f : 2.0f);
  }
  scene.labels.structures[0].visible = false;
  EXPECT_EQ(wordsOf(*layer(plateOf(scene), "labels")), std::vector<std::string>{"right"})
      << "of what is hidden there is none";
}

TEST_F(PlateGL, OnAPageLettersAndLinesHaveTheirPointsWhateverThePixels) {
  scene::Scene scene = twoBalls();
  scene.lettering.scaleBar = true;
  scene.lettering.pageWidth = 85.0;
  for (int factor : {2, 5}) {
    PictureOptions large = options();
    large.size *= factor;
    large.samples = 1;
    vector::Drawing drawing = drawPlate(*sRenderer, scene, large, context().limits(), sProgress);
    EXPECT_NEAR(drawing.size.x / drawing.dpi * 25.4, 85.0, 1e-6);
    for (const vector::Item& item : layer(drawing, "scale bar")->items)
      if (const auto* words = std::get_if<vector::Words>(&item)) {
        EXPECT_NEAR(words->em / drawing.dpi * 72.0, 7.0, 1e-6);
      }
    EXPECT_EQ(journalNotes(drawing).empty(), drawing.dpi >= 300.0) << drawing.dpi;
  }
  scene.lettering.textPoints = 4.0;
  scene.lettering.pageWidth = 20.0;
  std::vector<std::string> notes = journalNotes(plateOf(scene));
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("4 pt"), std::string::npos) << notes[0];
}

}  // namespace velum::session
