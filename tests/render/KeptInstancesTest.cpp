// What cuts leave of instances, as the processor finds it.
#include "render/kept/KeptInstances.h"

#include <gtest/gtest.h>

#include "makeModel.h"
#include "scene/Scene.h"

namespace velum::render {
namespace {

/// A handle asks about its own types alone.
TEST(KeptInstances, OfFewTypesIsKnownWhatIsKnownOfAll) {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(ModelMaker{.types = 5, .instances = 2000}.make());
  scene.model.copies = 2;
  scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, 1.5);
  scene::Cut focus, plane;
  focus.shape = scene::CutShape::Everywhere;
  focus.model.spares = {{.type = "root", .aperture = 0.7}};
  focus.model.focus.emplace().types = {{"root.a.type2"}};
  scene::addCut(scene, focus);
  plane.axis = {1, 1, 0};
  plane.model.spares = {{"root.b", 0.5}};
  scene::addCut(scene, plane);
  const Model& model = *scene.model.data;
  auto all = instanceStates(scene);
  std::size_t counts[3] = {};
  for (std::uint32_t type = 0; type < model.types.size(); ++type) {
    auto some = instanceStates(scene, {}, kUsualAspect, {type});
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (model.molecules[model.instances[i % model.instances.size()].molecule].type != type) continue;
      EXPECT_EQ(some[i], all[i]) << i;
      ++counts[int(some[i])];
    }
  }
  for (std::size_t count : counts) EXPECT_GT(count, 100u) << "each state is met";
}

}  // namespace
}  // namespace velum::render
