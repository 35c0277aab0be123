#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/Parallel.h"
#include "render/kept/KeptInstances.h"
#include "render/upload/CutSheets.h"
#include "shared/instance.h"

namespace velum::render {

/// The instances of a scene, with the same parameters that the programs which draw them get.
struct Instances {
  const scene::Scene& scene;
  const Model& model;
  scene::ModelFrame frame;
  glm::dvec3 origin{0.0};
  double radius = 0.0;
  scene::CopyGrid copies;
  CpuSheets sheets;
  std::vector<shared::CutData> cuts;
  std::vector<shared::TypeSpareRow> spares;
  std::uint32_t whole = 0;
  std::vector<InstanceState> states;

  Instances(const scene::Scene& of, const SheetIndices& live);
  std::size_t count() const { return states.size(); }
  const Molecule& moleculeOf(std::size_t i) const {
    return model.molecules[model.instances[i % model.instances.size()].molecule];
  }
  float radiusOf(std::size_t i) const { return float(double(moleculeOf(i).radius) * frame.length); }
  glm::vec3 middleOf(std::size_t i) const;
  const shared::TypeSpareRow& spareOf(std::size_t i, std::size_t cut) const {
    return spares[moleculeOf(i).type * cuts.size() + cut];
  }
  float reachOf(std::size_t i, std::size_t cut) const {
    return cut < 32 && (whole >> cut & 1u) != 0 ? radiusOf(i) : 0.0f;
  }
  template <class Look>
  void forAll(const Look& look) const {
    parallelForRanges(std::size_t(0), count(), std::size_t(4096), [&](std::size_t first, std::size_t end) {
      for (std::size_t i = first; i < end; ++i) look(i);
    });
  }
};

}  // namespace velum::render
