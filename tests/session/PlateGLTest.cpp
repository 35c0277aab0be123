// Plates: drawings in layers, compared with the pictures of pixels that they stand for.
#include "session/plate/Plate.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "GlFixture.h"
#include "core/ImageChannels.h"
#include "makeModel.h"
#include "makeVolume.h"
#include "model/Levels.h"
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
  /// Molecules of two compartments, black lines, no light. @param away  how far the eye is
  static scene::Scene cluster(double away) {
    scene::Scene scene;
    scene.unit = LengthUnit::Angstrom;
    ModelMaker maker{4, 300, 120, 30.0f, 130.0f, 3};
    scene.model.data = Shared<Model>(maker.make());
    scene.model.levels = Shared<LevelSet>(model::computeLevels(*scene.model.data, sProgress));
    scene.lighting.shaded = false;
    scene.background.top = scene.background.bottom = glm::vec3(1.0f);
    scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, double(kPlateSize.x) / kPlateSize.y);
    scene.camera.eye = scene.camera.target + away * (scene.camera.eye - scene.camera.target);
    scene.finish.contours = 1.0;
    scene.finish.contourColor = glm::vec3(0.0f);
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

/// How dark lines make each pixel.
struct Darkness {
  explicit Darkness(glm::ivec2 area) : size(area), values(std::size_t(area.x) * std::size_t(area.y)) {}
  double sum() const { return std::accumulate(values.begin(), values.end(), 0.0); }
  float at(glm::ivec2 p) const {
    bool isInside = p.x >= 0 && p.y >= 0 && p.x < size.x && p.y < size.y;
    return isInside ? values[std::size_t(p.y) * std::size_t(size.x) + std::size_t(p.x)] : 0.0f;
  }
  /// Of the pixels that are dark those within 1.5 pixels of what the other has.
  double shareNear(const Darkness& other) const {
    double dark = 0.0, near = 0.0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        if (at({x, y}) < 0.5f) continue;
        ++dark;
        float most = 0.0f;
        for (int i = 0; i < 9; ++i) most = std::max(most, other.at({x + i % 3 - 1, y + i / 3 - 1}));
        near += most > 0.2f;
      }
    return near / std::max(dark, 1.0);
  }
  glm::ivec2 size;
  std::vector<float> values;
};

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

TEST_F(PlateGL, ContoursThatTheFinishLacksAreHiddenAndTheTransparentHaveNoPaper) {
  scene::Scene scene = twoBalls();
  vector::Drawing lined = plateOf(scene);
  scene.finish.contours = 0.0;
  vector::Drawing drawing = plateOf(scene);
  const vector::Layer* hidden = layer(drawing, "contours");
  ASSERT_TRUE(hidden && hidden->isHidden);
  EXPECT_FALSE(layer(lined, "contours")->isHidden);
  EXPECT_EQ(hidden->items.size(), layer(lined, "contours")->items.size());
  // Pictures, files' first look and what journals refuse are without them.
  vector::Drawing bare = drawing;
  std::erase_if(bare.layers, [](const vector::Layer& one) { return one.isHidden; });
  Image with{kPlateSize.x, kPlateSize.y, {"R", "G", "B"}, {}};
  with.pixels.assign(std::size_t(3 * kPlateSize.x * kPlateSize.y), 0.0f);
  Image without = with;
  vector::paint(std::span<const vector::Layer>(drawing.layers), with);
  vector::paint(std::span<const vector::Layer>(bare.layers), without);
  EXPECT_EQ(with.pixels, without.pixels);
  EXPECT_EQ(journalNotes(drawing), journalNotes(bare));
  scene.background.transparent = true;
  EXPECT_FALSE(layer(plateOf(scene), "paper"));
}

TEST_F(PlateGL, LinesOfModelsLieOnThoseThatTheFinishDraws) {
  for (double away : {1.0, 4.0}) {
    scene::Scene scene = cluster(away);
    PictureOptions large{{500, 500}, 4, false, false, 0};
    vector::Drawing drawing = drawPlate(*sRenderer, scene, large, context().limits(), sProgress);
    Darkness traced(large.size), drawn(large.size);
    Image lines{500, 500, {"R", "G", "B"}, std::vector<float>(std::size_t(3 * 500 * 500), 1.0f)};
    vector::paint(layer(drawing, "contours")->items, lines);
    Image with = drawPicture(*sRenderer, scene, large, context().limits(), sProgress);
    scene.finish.contours = 1e-6;
    Image without = drawPicture(*sRenderer, scene, large, context().limits(), sProgress);
    std::size_t n = with.channels.size();
    for (std::size_t i = 0; i < traced.values.size(); ++i) {
      traced.values[i] = 1.0f - lines.pixels[3 * i];
      drawn.values[i] = without.pixels[n * i] > 0.05f ? 1.0f - with.pixels[n * i] / without.pixels[n * i] : 0.0f;
    }
    EXPECT_GT(drawn.sum(), 1000.0) << "there are lines to compare";
    EXPECT_GT(drawn.shareNear(traced), 0.98) << away;
    EXPECT_GT(traced.shareNear(drawn), 0.98) << away;
    EXPECT_NEAR(traced.sum() / drawn.sum(), 1.0, 0.2) << away;
  }
}

TEST_F(PlateGL, LinesOfACompartmentAreAGroupWithItsTypes) {
  vector::Drawing drawing = plateOf(cluster(1.0));
  const vector::Layer* contours = layer(drawing, "contours");
  ASSERT_TRUE(contours);
  std::vector<std::string> groups;
  std::set<std::string> names;
  for (const vector::Item& item : contours->items) {
    const auto& shape = std::get<vector::Shape>(item);
    if (groups.empty() || groups.back() != shape.group) groups.push_back(shape.group);
    names.insert(shape.group + "/" + shape.name);
  }
  EXPECT_EQ(groups, (std::vector<std::string>{"a", "b"})) << "each once";
  EXPECT_EQ(names, (std::set<std::string>{"a/type0", "b/type1", "a/type2", "b/type3"}));
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
