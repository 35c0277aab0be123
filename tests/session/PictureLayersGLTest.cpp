// The illustrative section as a picture with layers: put together again they are the picture.
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "GlFixture.h"
#include "TempFolder.h"
#include "core/Mesh.h"
#include "io/images/ImageFile.h"
#include "io/phantoms/Sample.h"
#include "makeModel.h"
#include "scene/Navigate.h"
#include "scene/Presets.h"
#include "session/cut/CutEdit.h"
#include "session/membrane/MembraneEdit.h"
#include "session/membrane/Membranes.h"
#include "session/picture/Picture.h"

namespace velum::session {

namespace {

class PictureLayersGL : public GlTest {
 protected:
  static void SetUpTestSuite() {
    context().makeCurrent();
    sRenderer = new render::Renderer(context());
    sScene = new scene::Scene(makeInlaidVessels());
  }
  static void TearDownTestSuite() {
    context().makeCurrent();
    delete sRenderer;
    delete sScene;
  }
  /// Vessels beside a section across z, seen obliquely, the sheet at rest.
  static scene::Scene makeInlaidVessels() {
    scene::Scene scene;
    scene.volume.data = Shared<Volume>(io::makeSample("vessels", 48, sProgress).volume);
    scene::applyPreset(scene, scene::choosePreset(*scene.volume.data));
    scene.camera = scene::frameCamera(scene, scene::StandardView::Superior, 1.0);
    scene.cuts = {makeCut(scene, scene::CutShape::Membrane)};
    scene.cuts[0].centre = centreOf(*scene.volume.data);
    auto& membrane = *scene.cuts[0].membrane;
    protectValues(membrane, 700, 4000);
    membrane.use = scene::MembraneUse::Inlay;
    membrane.inlayOpacity = 0.6;
    scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, 1.0);
    settleMembranes(scene, {}, sProgress);
    return scene;
  }
  static Image draw(const scene::Scene& scene) {
    return drawPicture(*sRenderer, scene, {{64, 64}, 1, true, true, 0}, context().limits(), sProgress);
  }
  static std::size_t column(const Image& image, const std::string& name) {
    return std::size_t(std::find(image.channels.begin(), image.channels.end(), name) - image.channels.begin());
  }
  /// Premultiplied.
  static glm::vec4 colorAt(const Image& image, std::size_t pixel, const std::string& layer) {
    const float* at = &image.pixels[pixel * image.channels.size()];
    float a = at[column(image, layer + "A")];
    return {at[column(image, layer + "R")] * a, at[column(image, layer + "G")] * a, at[column(image, layer + "B")] * a,
            a};
  }
  /// Largest difference between the picture and front over inlay over behind.
  static float differenceFromLayers(const Image& image) {
    float largest = 0;
    for (std::size_t i = 0; i < std::size_t(image.width) * std::size_t(image.height); ++i) {
      glm::vec4 front = colorAt(image, i, "front."), inlay = colorAt(image, i, "inlay."),
                behind = colorAt(image, i, "behind.");
      glm::vec4 together = front + (1.0f - front.a) * (inlay + (1.0f - inlay.a) * behind);
      glm::vec4 away = glm::abs(together - colorAt(image, i, ""));
      largest = std::max({largest, away.r, away.g, away.b, away.a});
    }
    return largest;
  }
  static double coverOf(const Image& image, const std::string& layer) {
    double sum = 0;
    for (std::size_t i = 0; i < std::size_t(image.width) * std::size_t(image.height); ++i)
      sum += double(colorAt(image, i, layer).a);
    return sum;
  }
  inline static Progress sProgress;
  inline static render::Renderer* sRenderer = nullptr;
  inline static scene::Scene* sScene = nullptr;
};

TEST_F(PictureLayersGL, FrontOverInlayOverBehindIsThePicture) {
  scene::Scene scene = *sScene;
  Image image = draw(scene);
  for (const char* layer : {"front.", "inlay.", "behind."}) {
    ASSERT_LT(column(image, std::string(layer) + "A"), image.channels.size()) << layer;
    EXPECT_GT(coverOf(image, layer), 20.0) << layer;
  }
  // Rays end early where they are nearly opaque.
  EXPECT_LT(differenceFromLayers(image), 2.5f / 255.0f);
}

TEST_F(PictureLayersGL, OfAFinishedPictureTheyAreNotFinished) {
  // They are finished when they have been put together, once.
  scene::Scene scene = *sScene;
  Image plain = draw(scene);
  scene.finish.contours = 1.5;
  Image finished = draw(scene);
  float most[2] = {0.0f, 0.0f};  // of the layers, of the picture
  for (std::size_t i = 0; i < std::size_t(plain.width) * std::size_t(plain.height); ++i)
    for (const char* layer : {"front.", "inlay.", "behind.", ""}) {
      glm::vec4 away = glm::abs(colorAt(finished, i, layer) - colorAt(plain, i, layer));
      float& sofar = most[*layer == 0];
      sofar = std::max({sofar, away.r, away.g, away.b, away.a});
    }
  EXPECT_EQ(most[0], 0.0f);
  EXPECT_GT(most[1], 0.1f);
}

TEST_F(PictureLayersGL, SheetsAndSurfacesHaveTheirPlaceInThem) {
  scene::Scene scene = *sScene;
  scene.cuts[0].membrane->look = scene::SheetLook::Surface;
  Mesh mesh;
  glm::vec3 middle(scene.cuts[0].centre);
  mesh.positions = {middle + glm::vec3(-9, -9, -9), middle + glm::vec3(9, -9, -9), middle + glm::vec3(0, 9, 9)};
  mesh.normals.assign(3, glm::vec3(0, 0, 1));
  mesh.indices = {0, 1, 2};
  scene.surfaces.emplace_back().data = Shared<Mesh>(std::move(mesh));
  EXPECT_LT(differenceFromLayers(draw(scene)), 2.5f / 255.0f);
}

TEST_F(PictureLayersGL, WithoutAnInlayThereAreNone) {
  scene::Scene scene = *sScene;
  scene.cuts[0].membrane->use = scene::MembraneUse::Clip;
  Image image = draw(scene);
  EXPECT_EQ(column(image, "inlay.R"), image.channels.size());
  scene.cuts[0].membrane->use = scene::MembraneUse::Inlay;
  scene.rayCast.mode = scene::RenderMode::Mip;
  image = draw(scene);
  EXPECT_EQ(column(image, "inlay.R"), image.channels.size());
}

TEST_F(PictureLayersGL, OfAModelTheyHaveItsTypes) {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(ModelMaker{.types = 3, .instances = 60, .halfEdge = 80.0f}.make());
  scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, 1.0);
  Image image = draw(scene);
  ASSERT_LT(column(image, "type"), image.channels.size());
  const Model& model = *scene.model.data;
  std::set<int> seen;
  for (std::size_t i = 0; i < std::size_t(image.width) * std::size_t(image.height); ++i) {
    const float* at = &image.pixels[i * image.channels.size()];
    int type = int(at[column(image, "type")]);
    seen.insert(type);
    if (type < 0) continue;
    auto instance = std::size_t(at[column(image, "instance")]) - 1;
    ASSERT_EQ(model.molecules[model.instances.at(instance).molecule].type, std::uint32_t(type));
  }
  EXPECT_EQ(seen, (std::set<int>{-1, 0, 1, 2}));
}

/// Bits a sample and pixels a metre, as the header of a PNG says them.
glm::ivec2 bitsAndResolutionOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  std::size_t at = bytes.find("pHYs");
  EXPECT_NE(at, std::string::npos) << path;
  if (at == std::string::npos) return {bytes[24], 0};
  int perMetre = 0;
  for (std::size_t i = 0; i < 4; ++i) perMetre = perMetre << 8 | int(static_cast<unsigned char>(bytes[at + 4 + i]));
  return {bytes[24], perMetre};
}

TEST_F(PictureLayersGL, BesideAPngTheyHave16BitsAndItsResolution) {
  TempFolder folder;
  PictureOptions options{{64, 64}, 1, true, true, 254};
  Image image = draw(*sScene);
  savePicture(image, *sScene, options, folder / "x.png");
  EXPECT_EQ(bitsAndResolutionOf(folder / "x.png"), glm::ivec2(8, 10000));
  for (const char* layer : {"alpha", "depth", "id", "normal", "position", "front", "inlay", "behind"})
    EXPECT_EQ(bitsAndResolutionOf(folder / (std::string("x.") + layer + ".png")), glm::ivec2(16, 10000)) << layer;
  // All depths that differ by a ten thousandth of the whole are told apart.
  Image depth = io::readImage(folder / "x.depth.png");
  std::size_t z = column(image, "Z"), n = image.channels.size();
  float nearest = INFINITY, farthest = 0;
  for (std::size_t i = z; i < image.pixels.size(); i += n)
    if (std::isfinite(image.pixels[i]))
      nearest = std::min(nearest, image.pixels[i]), farthest = std::max(farthest, image.pixels[i]);
  std::set<float> grey;
  for (std::size_t i = 0; i < depth.pixels.size(); ++i) {
    float mm = image.pixels[i * n + z];
    float expected = std::isfinite(mm) ? 1.0f - 0.9f * (mm - nearest) / (farthest - nearest) : 0.0f;
    ASSERT_NEAR(depth.pixels[i], expected, 1e-4f) << i;
    grey.insert(depth.pixels[i]);
  }
  EXPECT_GT(grey.size(), 256u);
}

TEST_F(PictureLayersGL, PlacesBesideAPngAreRedByXGreenByYAndBlueByZ) {
  TempFolder folder;
  Image image = draw(*sScene);
  savePicture(image, *sScene, {{64, 64}, 1, true, true, 254}, folder / "x.png");
  Image places = io::readImage(folder / "x.position.png");
  std::size_t z = column(image, "Z"), n = image.channels.size(), there = 0;
  glm::vec3 low(INFINITY), high(-INFINITY);
  auto placeOf = [&](std::size_t i) {
    const float* at = &image.pixels[i * n];
    return glm::vec3(at[column(image, "position.X")], at[column(image, "position.Y")], at[column(image, "position.Z")]);
  };
  for (std::size_t i = 0; i * n < image.pixels.size(); ++i)
    if (std::isfinite(image.pixels[i * n + z])) low = glm::min(low, placeOf(i)), high = glm::max(high, placeOf(i));
  for (std::size_t i = 0; i * n < image.pixels.size(); ++i) {
    if (!std::isfinite(image.pixels[i * n + z])) continue;
    glm::vec3 expected = (placeOf(i) - low) / (high - low);
    for (int axis = 0; axis < 3; ++axis) ASSERT_NEAR(places.pixels[i * 3 + std::size_t(axis)], expected[axis], 1e-4f);
    ++there;
  }
  EXPECT_GT(there, 200u);
}

TEST_F(PictureLayersGL, IdsOfAModelTellItsInstancesApart) {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(ModelMaker{.types = 3, .instances = 60, .halfEdge = 80.0f}.make());
  scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, 1.0);
  TempFolder folder;
  Image image = draw(scene);
  savePicture(image, scene, {{64, 64}, 1, false, true, 300}, folder / "x.png");
  Image ids = io::readImage(folder / "x.id.png");
  std::map<int, std::array<float, 3>> colors;
  std::set<std::array<float, 3>> different;
  for (std::size_t i = 0; i < std::size_t(image.width) * std::size_t(image.height); ++i) {
    int instance = int(image.pixels[i * image.channels.size() + column(image, "instance")]);
    std::array<float, 3> color{ids.pixels[i * 3], ids.pixels[i * 3 + 1], ids.pixels[i * 3 + 2]};
    auto [known, isNew] = colors.try_emplace(instance, color);
    ASSERT_EQ(known->second, color) << "instance " << instance;
    different.insert(color);
  }
  EXPECT_GT(colors.size(), 20u);
  EXPECT_EQ(different.size(), colors.size());
  EXPECT_EQ(colors.at(-1), (std::array<float, 3>{0, 0, 0})) << "where nothing is";
}

TEST_F(PictureLayersGL, AnExrHoldsThemAsItHoldsThePicture) {
  Image image = draw(*sScene);
  TempFolder folder;
  io::writeImage(image, folder / "x.exr");
  Image back = io::readImage(folder / "x.exr");
  EXPECT_LT(differenceFromLayers(back), 3.0f / 255.0f);
  EXPECT_NEAR(coverOf(back, "inlay."), coverOf(image, "inlay."), 1.0);
}

}  // namespace
}  // namespace velum::session
