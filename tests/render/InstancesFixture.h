#pragma once
#include <limits>
#include <set>
#include <vector>

#include "RenderFixture.h"
#include "makeModel.h"

namespace velum {

/// Pictures of models, and who is seen in them.
class InstancesGL : public RenderTest {
 protected:
  static constexpr render::Layers kLayers{true, true, true, true, true, true};

  /// A model seen from the front: no light, one sample, no background.
  static scene::Scene sceneOfModel(Model model) {
    scene::Scene scene;
    scene.unit = LengthUnit::Angstrom;
    scene.model.data = Shared<Model>(std::move(model));
    scene.lighting.shaded = false;
    scene.rayCast.samplesPerPixel = 1;
    scene.background.transparent = true;
    scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, 1.0);
    return scene;
  }
  /// Atoms of and over a floor across y, lit, orthographic from the front.
  static scene::Scene floorScene(const std::vector<glm::vec3>& places) {
    scene::Scene scene = sceneOfModel(modelOfAtoms(places, kResidue));
    scene.camera.target = {0, 0, 0};
    scene.camera.projection = scene::Projection::Orthographic;
    scene.camera.height = 90;
    lookAlong(scene, {0, -1, 0}, 300);
    scene.lighting.shaded = true;
    return scene;
  }
  /// Instances of the model that a picture shows.
  static std::set<int> shownIn(const Image& image, int first = 1) {
    std::set<int> shown;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        if (float instance = sampleOf(image, {x, y}, "instance"); instance >= float(first))
          shown.insert(int(instance) - first);
    return shown;
  }
  /// Atoms on a square lattice before the eye, so far apart that none hides another.
  static Model lattice(int edge, float apart) {
    std::vector<glm::vec3> places;
    for (int z = 0; z < edge; ++z)
      for (int x = 0; x < edge; ++x)
        places.emplace_back((float(x) - 0.5f * float(edge - 1)) * apart, 3.0f * float((7 * x + 3 * z) % 11),
                            (float(z) - 0.5f * float(edge - 1)) * apart);
    return modelOfAtoms(places, kResidue);
  }
};

/// Where a ray first meets one of some spheres; infinity: nowhere.
inline double firstSphere(const TestRay& ray, const std::vector<glm::dvec4>& spheres) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& s : spheres) {
    glm::dvec3 q = glm::dvec3(s) - ray.origin;
    double b = glm::dot(q, ray.direction), left = s.w * s.w - (glm::dot(q, q) - b * b);
    if (left < 0) continue;
    double t = b - std::sqrt(left);
    if (t > 0) nearest = std::min(nearest, t);
  }
  return nearest;
}

}  // namespace velum
