#include "session/picture/ModelPictures.h"

#include <algorithm>

#include "scene/ModelLooks.h"
#include "session/picture/SmallPictures.h"

namespace velum::session {

namespace {

/// Leaves the instances for which `keeps` is true, and counts those of molecules and types anew.
template <class Keeps>
Model withInstances(const Model& model, Keeps&& keeps) {
  Model out;
  out.compartments = model.compartments;
  out.types = model.types;
  out.molecules = model.molecules;
  out.name = model.name;
  out.low = glm::vec3(std::numeric_limits<float>::max()), out.high = -out.low;
  for (MoleculeType& type : out.types) {
    type.firstInstance = std::uint32_t(out.instances.size());
    for (std::uint32_t m = type.firstMolecule; m < type.firstMolecule + type.moleculeCount; ++m) {
      Molecule& molecule = out.molecules[m];
      std::uint32_t first = molecule.firstInstance, end = first + molecule.instanceCount;
      molecule.firstInstance = std::uint32_t(out.instances.size());
      for (std::uint32_t i = first; i < end; ++i) {
        const Instance& one = model.instances[i];
        if (!keeps(one)) continue;
        out.instances.push_back(one);
        glm::vec3 middle = one.rotation * molecule.centre + one.position;
        out.low = glm::min(out.low, middle - molecule.radius);
        out.high = glm::max(out.high, middle + molecule.radius);
      }
      molecule.instanceCount = std::uint32_t(out.instances.size()) - molecule.firstInstance;
    }
    type.instanceCount = std::uint32_t(out.instances.size()) - type.firstInstance;
  }
  return out;
}

}  // namespace

Shared<Model> middleOfModel(const Shared<Model>& model, std::size_t mostInstances) {
  if (model->instances.size() <= mostInstances || mostInstances == 0) return model;
  glm::vec3 middle = (model->low + model->high) * 0.5f;
  std::vector<float> distances;
  distances.reserve(model->instances.size());
  for (const Instance& one : model->instances) distances.push_back(glm::distance(one.position, middle));
  auto last = distances.begin() + std::ptrdiff_t(mostInstances);
  std::nth_element(distances.begin(), last, distances.end());
  float reach = *last;
  return Shared<Model>(
      withInstances(*model, [&](const Instance& one) { return glm::distance(one.position, middle) < reach; }));
}

scene::Scene modelLookScene(const scene::Scene& scene, const Shared<Model>& small, const std::string& look,
                            double aspect) {
  scene::Scene shown;
  shown.unit = scene.unit;
  shown.model = scene.model;
  shown.model.data = small;
  shown.model.copies = 1;
  shown.model.visible = true;
  shown.model.detail = kPreviewDetail;
  scene::applyModelLook(shown, look);
  shown.background.transparent = false;
  shown.rayCast.samplesPerPixel = 2;
  shown.camera = scene::frameCamera(shown, scene::defaultView(shown), aspect);
  return shown;
}

void drawModelPictures(const scene::Scene& scene, const std::vector<std::string>& looks, glm::ivec2 size,
                       const std::function<void(const std::string&, const Image&)>& done, Progress& progress) {
  if (!scene.model.data) return;
  Shared<Model> small = middleOfModel(scene.model.data, kPreviewInstances);
  auto sceneOf = [&](const std::string& look) { return modelLookScene(scene, small, look, double(size.x) / size.y); };
  drawSmallPictures(looks, size, sceneOf, done, progress);
}

}  // namespace velum::session
