#include "render/kept/Instances.h"

#include <algorithm>

#include "model/InstanceRows.h"
#include "render/FrameSetup.h"
#include "scene/Crowd.h"

namespace velum::render {

namespace {

/// @throw InputError where there are too many
std::size_t numberedCount(const scene::ModelLayer& layer) {
  scene::refuseCrowd(layer, "what becomes of each instance");
  return std::size_t(scene::instanceCount(layer));
}

}  // namespace

Instances::Instances(const scene::Scene& of, const SheetIndices& live)
    : scene(of),
      model(*of.model.data),
      copies(scene::copyGrid(of.model)),
      sheets(makeCpuSheets(of, live)),
      spares(model::makeTypeSpareRows(of)),
      whole(model::wholeInstanceBits(of)),
      states(numberedCount(of.model), InstanceState::Kept) {
  scene::ModelBox box = scene::worldBoxOfModel(of);
  frame = scene::modelFrame(of);
  origin = 0.5 * (box.low + box.high);
  radius = 0.5 * glm::length(box.high - box.low);
  cuts = makeCutData(of, origin, sheets.plans);
}

glm::vec3 Instances::middleOf(std::size_t i) const {
  std::size_t count = model.instances.size();
  const Instance& instance = model.instances[i % count];
  int copy = int(i / count);
  glm::ivec3 at(copy % copies.counts.x, copy / copies.counts.x % copies.counts.y,
                copy / (copies.counts.x * copies.counts.y));
  glm::dvec3 middle = glm::dvec3(instance.position) + glm::dvec3(instance.rotation * moleculeOf(i).centre) +
                      copies.step * glm::dvec3(at);
  return glm::vec3(frame.worldOf(middle) - origin);
}

}  // namespace velum::render
