// Copies of a model: what of them is left out, and lists with room for some of them only.
#include <cstdlib>
#include <utility>

#include "InstancesFixture.h"

namespace velum {
namespace {

TEST_F(InstancesGL, ListsOfDrawsThatAreFilledManyTimesGiveTheSamePicture) {
  ModelMaker maker;
  maker.instances = 700;
  scene::Scene scene = sceneOfModel(maker.make());
  scene.model.copies = 100;  // 70,000 instances; a list has room for 32,768
  scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, 1.0);
  Image whole = draw(scene, {200, 200}, kLayers);
  ::setenv("VELUM_MAX_TEXTURE_BUFFER", "65536", 1);
  auto small = gpu::Context::create(gpu::ContextKind::Auto);
  ::unsetenv("VELUM_MAX_TEXTURE_BUFFER");
  render::Renderer other(*small);
  for (int i = 0; i < 2; ++i)
    expectIdentical(drawWith(other, scene, {200, 200}, kLayers), whole, "nothing seen, then all");
}

TEST_F(InstancesGL, CopiesThatAreHiddenChangeNoPixel) {
  // Blocks of molecules behind each other: those behind, beside and beyond the window are not looked at. Each copy by
  // itself, all of them laid over each other by depth, is the picture of all.
  ModelMaker maker;
  maker.instances = 600;
  maker.halfEdge = 40;
  Model one = maker.make();
  scene::Scene copies = sceneOfModel(one);
  copies.model.copies = 27;
  // The same instances as one model: there are no copies to be left out.
  scene::CopyGrid grid = scene::copyGrid(copies.model);
  Model all = one;
  all.instances.clear();
  for (int copy = 0; copy < 27; ++copy) {
    int line = copy / grid.counts.x;
    glm::vec3 shift(glm::dvec3(copy % grid.counts.x, line % grid.counts.y, line / grid.counts.y) * grid.step);
    for (Instance instance : one.instances) {
      instance.position += shift;
      all.instances.push_back(instance);
    }
  }
  scene::ModelBox box = scene::modelBox(copies.model);
  all.low = glm::vec3(box.low);
  all.high = glm::vec3(box.high);
  scene::Scene whole = sceneOfModel(std::move(all));
  for (scene::StandardView view : {scene::StandardView::Anterior, scene::StandardView::Oblique})
    for (bool isNear : {false, true}) {
      copies.camera = scene::frameCamera(copies, view, 1.0);
      if (isNear) copies.camera.eye = glm::mix(copies.camera.eye, copies.camera.target, 0.8);
      whole.camera = copies.camera;
      renderer().clear();
      Image wanted = draw(whole, {160, 160}, kLayers);
      renderer().clear();
      for (int i = 0; i < 2; ++i) {
        Image image = draw(copies, {160, 160}, kLayers);
        int shown = 0, wrong = 0;
        eachShown(wanted, [&](glm::ivec2 pixel, glm::vec3) {
          ++shown;
          wrong += sampleOf(image, pixel, "instance") != sampleOf(wanted, pixel, "instance");
        });
        EXPECT_GT(shown, 2000);
        EXPECT_LE(wrong, shown / 500) << "spheres that are as near by a rounding";
      }
    }
}

}  // namespace
}  // namespace velum
