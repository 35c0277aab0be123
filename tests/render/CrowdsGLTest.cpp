// Copies that are too many for numbers of all their instances: far ones are drawn as wholes.
#include "InstancesFixture.h"
#include "core/Error.h"
#include "render/kept/KeptInstances.h"
#include "scene/Crowd.h"

namespace velum {
namespace {

class CrowdsGL : public InstancesGL {
 protected:
  static constexpr int kCopies = 4913;  // 17 along each edge

  static Model cell() {
    ModelMaker maker;
    maker.instances = 60;
    maker.halfEdge = 40;
    return maker.make();
  }
  static scene::Scene crowd() {
    scene::Scene scene = sceneOfModel(cell());
    scene.model.copies = kCopies;
    EXPECT_TRUE(scene::isCrowd(scene.model));
    scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, 1.0);
    return scene;
  }
  /// The same instances as one model, each by itself.
  static scene::Scene oneByOne() {
    scene::Scene copies = crowd();
    scene::CopyGrid grid = scene::copyGrid(copies.model);
    Model one = cell(), all = one;
    all.instances.clear();
    for (const MoleculeType& type : one.types)
      for (int copy = 0; copy < kCopies; ++copy) {
        int line = copy / grid.counts.x;
        glm::vec3 shift(glm::dvec3(copy % grid.counts.x, line % grid.counts.y, line / grid.counts.y) * grid.step);
        for (std::uint32_t i = type.firstInstance; i < type.firstInstance + type.instanceCount; ++i) {
          all.instances.push_back(one.instances[i]);
          all.instances.back().position += shift;
        }
      }
    scene::ModelBox box = scene::modelBox(copies.model);
    all.low = glm::vec3(box.low), all.high = glm::vec3(box.high);
    scene::Scene scene = sceneOfModel(std::move(all));
    scene.camera = copies.camera;
    return scene;
  }
  /// A colour, premultiplied, of a square of pixels.
  static glm::vec4 meanOf(const Image& image, glm::ivec2 from, int edge) {
    glm::vec4 sum(0.0f);
    for (int y = from.y; y < from.y + edge; ++y)
      for (int x = from.x; x < from.x + edge; ++x)
        sum += glm::vec4(sampleOf(image, {x, y}, "R"), sampleOf(image, {x, y}, "G"), sampleOf(image, {x, y}, "B"),
                         sampleOf(image, {x, y}, "A"));
    return sum / float(edge * edge);
  }
  static void addPlane(scene::Scene& scene) {
    scene::ModelBox box = scene::modelBox(scene.model);
    scene::Cut cut;
    cut.shape = scene::CutShape::Plane;
    cut.centre = 0.5 * (box.low + box.high);
    cut.axis = {0, -1, 0};
    scene.cuts.push_back(cut);
  }
};

TEST_F(CrowdsGL, LookLikeTheSameInstancesOneByOne) {
  scene::Scene far = crowd(), every = oneByOne();
  Image image = draw(far, {240, 240}, kLayers), wanted = draw(every, {240, 240}, kLayers);
  double off = 0.0, most = 0.0;
  int squares = 0;
  for (int y = 0; y + 16 <= 240; y += 16)
    for (int x = 0; x + 16 <= 240; x += 16) {
      glm::vec4 d = glm::abs(meanOf(image, {x, y}, 16) - meanOf(wanted, {x, y}, 16));
      double largest = std::max({d.x, d.y, d.z, d.w});
      most = std::max(most, largest);
      off += largest;
      ++squares;
    }
  EXPECT_LT(off / squares, 0.02);
  EXPECT_LT(most, 0.12) << "at its outline";
}

TEST_F(CrowdsGL, DoNotDependOnWhatWasSeenBefore) {
  scene::Scene scene = crowd(), near = scene;
  near.camera.eye = glm::mix(scene.camera.eye, scene.camera.target, 0.55);
  Image first = draw(scene, {160, 160}, kLayers), close = draw(near, {160, 160}, kLayers);
  expectIdentical(draw(scene, {160, 160}, kLayers), first, "after another view");
  expectIdentical(draw(near, {160, 160}, kLayers), close, "and that one again");
  renderer().clear();
  expectIdentical(draw(near, {160, 160}, kLayers), close, "nothing known");
}

TEST_F(CrowdsGL, CutsHoldNearAndFar) {
  scene::Scene scene = crowd();
  addPlane(scene);
  for (double share : {0.0, 0.6}) {
    scene::Scene seen = scene;
    seen.camera.eye = glm::mix(scene.camera.eye, scene.camera.target, share);
    Image image = draw(seen, {160, 160}, kLayers);
    Image whole = [&] {
      scene::Scene uncut = seen;
      uncut.cuts.clear();
      return draw(uncut, {160, 160}, kLayers);
    }();
    scene::ModelBox box = scene::modelBox(scene.model);
    double middle = 0.5 * (box.low.y + box.high.y);
    auto deepest = [&](const Image& of) {
      double deep = 0.0;
      eachShown(of, [&](glm::ivec2 pixel, glm::vec3) {
        deep = std::max(deep, middle - double(vectorOf(of, pixel, "position").y));
      });
      return deep;
    };
    double cell = 90.0;
    EXPECT_LT(deepest(image), 0.5 * cell) << "nothing but what reaches over the plane";
    EXPECT_GT(deepest(whole), 3.0 * cell);
  }
}

TEST_F(CrowdsGL, HiddenTypesStayHidden) {
  scene::Scene scene = crowd();
  scene.model.types.push_back({.type = pathOf(*scene.model.data, scene.model.data->types[1]), .visible = false});
  Image image = draw(scene, {160, 160}, kLayers);
  int shown = 0;
  eachShown(image, [&](glm::ivec2 pixel, glm::vec3) {
    ++shown;
    EXPECT_NE(sampleOf(image, pixel, "type"), 1.0f);
  });
  EXPECT_GT(shown, 3000);
}

TEST_F(CrowdsGL, PixelsKnowTheirCopy) {
  scene::Scene scene = crowd();
  scene.camera.eye = glm::mix(scene.camera.eye, scene.camera.target, 0.5);
  Image image = draw(scene, {160, 160}, kLayers);
  scene::CopyGrid grid = scene::copyGrid(scene.model);
  int shown = 0;
  eachShown(image, [&](glm::ivec2 pixel, glm::vec3) {
    int copy = int(sampleOf(image, pixel, "instance")) - 1;
    ASSERT_GE(copy, 0);
    ASSERT_LT(copy, kCopies);
    glm::dvec3 at(copy % grid.counts.x, copy / grid.counts.x % grid.counts.y, copy / (grid.counts.x * grid.counts.y));
    glm::dvec3 middle = grid.step * at + 0.5 * (glm::dvec3(scene.model.data->low) + glm::dvec3(scene.model.data->high));
    glm::dvec3 off = glm::abs(glm::dvec3(vectorOf(image, pixel, "position")) - middle);
    EXPECT_LT(std::max({off.x, off.y, off.z}), 0.9 * std::max({grid.step.x, grid.step.y, grid.step.z}));
    ++shown;
  });
  EXPECT_GT(shown, 3000);
}

TEST_F(CrowdsGL, RefuseToBeCountedInWords) {
  scene::Scene scene = crowd();
  EXPECT_THROW(render::keptInstances(scene), InputError);
  scene.model.copies = scene::numberedCopies(scene.model);
  EXPECT_FALSE(scene::isCrowd(scene.model));
  EXPECT_EQ(render::keptInstances(scene).size(), std::size_t(scene::instanceCount(scene.model)));
}

}  // namespace
}  // namespace velum
