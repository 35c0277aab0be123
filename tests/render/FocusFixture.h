#pragma once
#include <set>

#include "RenderFixture.h"
#include "makeModel.h"

namespace velum {

/// Models of which cuts keep some in view.
class FocusGL : public RenderTest {
 protected:
  static constexpr glm::ivec2 kSize{200, 160};
  static constexpr render::Layers kLayers{true, true, true, true, true, true, true};

  /// Three types at random, of which the first is the focus of a cut that is everywhere.
  static scene::Scene focusScene(unsigned seed, int instances = 240) {
    ModelMaker maker;
    maker.types = 3;
    maker.instances = instances;
    maker.seed = seed;
    maker.halfEdge = 120.0f;
    scene::Scene scene;
    scene.unit = LengthUnit::Angstrom;
    scene.model.data = Shared<Model>(maker.make());
    scene.lighting.shaded = false;
    scene.rayCast.samplesPerPixel = 1;
    scene.background.transparent = true;
    scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, double(kSize.x) / kSize.y);
    scene::Cut cut;
    cut.shape = scene::CutShape::Everywhere;
    cut.model.spares = {{}};
    cut.model.spares[0].type = "root";
    cut.model.focus.emplace().types = {{"root.a.type0"}};
    scene::addCut(scene, cut);
    return scene;
  }
  render::InstanceBits bitsOf(const scene::Scene& scene, glm::ivec2 size = kSize) {
    render::Frame frame;
    frame.scene = scene;
    frame.pictureSize = size;
    frame.countsInstances = true;
    Progress progress;
    renderer().render(frame, progress);
    auto bits = renderer().bits(true);
    EXPECT_TRUE(bits.has_value());
    return bits.value_or(render::InstanceBits{});
  }
  std::set<std::size_t> removedIn(const scene::Scene& scene, glm::ivec2 size = kSize) {
    render::InstanceBits bits = bitsOf(scene, size);
    std::set<std::size_t> removed;
    for (std::size_t i = 0; i < bits.count; ++i)
      if (bits.isRemoved(i)) removed.insert(i);
    return removed;
  }
  static std::uint32_t typeOf(const scene::Scene& scene, std::size_t i) {
    const Model& model = *scene.model.data;
    return model.molecules[model.instances[i].molecule].type;
  }
};

/// A sphere around an instance, and where a ray meets it: a text of its own, in doubles.
struct Sphere {
  glm::dvec3 centre{0.0};
  double radius = 0.0;
};
inline Sphere sphereOf(const Model& model, std::size_t i) {
  const Instance& instance = model.instances[i];
  const Molecule& molecule = model.molecules[instance.molecule];
  return {glm::dvec3(instance.position) + glm::dvec3(instance.rotation * molecule.centre), double(molecule.radius)};
}
struct Meeting {
  double enters = 0.0, leaves = 0.0;
  bool isThere = false;
};
inline Meeting meet(const TestRay& ray, const Sphere& sphere, double grown) {
  glm::dvec3 q = sphere.centre - ray.origin;
  double radius = sphere.radius + grown, along = glm::dot(q, ray.direction);
  double left = radius * radius - (glm::dot(q, q) - along * along);
  if (left < 0.0) return {};
  return {along - std::sqrt(left), along + std::sqrt(left), true};
}

}  // namespace velum
