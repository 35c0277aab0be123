#include "render/kept/KeptInstances.h"

#include <algorithm>

#include "core/ModelBuilder.h"
#include "core/Parallel.h"
#include "model/FocusRows.h"
#include "render/FrameSetup.h"
#include "render/kept/Instances.h"

namespace velum::render {

namespace {

/// @param isAsked  by type
void clip(Instances& all, const std::vector<std::uint8_t>& isAsked) {
  all.forAll([&](std::size_t i) {
    if (!isAsked[all.moleculeOf(i).type]) return;
    float u = randomOf(std::uint32_t(i));
    glm::vec3 p = all.middleOf(i);
    shared::CutFold fold = shared::emptyFold();
    for (std::size_t c = 0; c < all.cuts.size(); ++c) {
      int answer = shared::instanceAnswer(all.cuts[c], shared::typeSpareDepth(all.spareOf(i, c), u), all.reachOf(i, c),
                                          p, all.sheets.view());
      fold = shared::foldAnswer(fold, shared::cutPart(all.cuts[c]), answer);
    }
    if (!shared::foldKeeps(fold)) all.states[i] = InstanceState::Removed;
  });
}

/// What is drawn of a focus, and how far each of its pixels lies from its edge.
struct Mask {
  std::vector<float> depths;  ///< Below 0: none of it.
  std::vector<std::uint32_t> seeds;
  float longest = 0.0f;
};

template <class Visit>
void forPixels(glm::ivec4 rect, const Visit& visit) {
  for (int y = rect.y; y <= rect.w; ++y)
    for (int x = rect.x; x <= rect.z; ++x)
      if (!visit(glm::ivec2(x, y))) return;
}

void flood(Mask& mask, glm::ivec2 size) {
  std::vector<std::uint32_t> next(mask.depths.size());
  mask.seeds.resize(mask.depths.size());
  for (int step : model::floodSteps(size)) {
    parallelForRanges(0, size.y, 16, [&](int from, int to) {
      forPixels({0, from, size.x - 1, to - 1}, [&](glm::ivec2 pixel) {
        std::size_t at = std::size_t(pixel.y) * std::size_t(size.x) + std::size_t(pixel.x);
        bool isInMask = mask.depths[at] >= 0.0f;
        std::uint32_t seed = mask.seeds[at];
        if (step == 0) seed = isInMask ? shared::kNoSeed : std::uint32_t(pixel.x) | std::uint32_t(pixel.y) << 16;
        for (int i = 0; i < 9 && step > 0 && isInMask; ++i) {
          glm::ivec2 near = pixel + step * glm::ivec2(i % 3 - 1, i / 3 - 1);
          if (near.x < 0 || near.y < 0 || near.x >= size.x || near.y >= size.y) continue;
          seed = shared::nearerSeed(pixel, seed,
                                    mask.seeds[std::size_t(near.y) * std::size_t(size.x) + std::size_t(near.x)]);
        }
        next[at] = seed;
        return true;
      });
    });
    mask.seeds.swap(next);
  }
  forPixels({0, 0, size - 1}, [&](glm::ivec2 pixel) {
    std::size_t at = std::size_t(pixel.y) * std::size_t(size.x) + std::size_t(pixel.x);
    if (mask.depths[at] >= 0.0f) mask.longest = std::max(mask.longest, shared::focusDistance(pixel, mask.seeds[at]));
    return true;
  });
}

Mask drawMask(const Instances& all, const std::vector<std::uint8_t>& isShown, const shared::FocusView& view) {
  Mask mask;
  mask.depths.assign(std::size_t(view.size.x) * std::size_t(view.size.y), -1.0f);
  for (std::size_t i = 0; i < all.count(); ++i) {
    if (all.states[i] != InstanceState::Kept || all.spareOf(i, std::size_t(view.cut)).isFocus == 0.0f) continue;
    if (!isShown[all.moleculeOf(i).type]) continue;
    glm::vec3 q = all.middleOf(i) - glm::vec3(view.eye);
    float radius = all.radiusOf(i);
    forPixels(shared::focusRect(view, q, radius), [&](glm::ivec2 pixel) {
      glm::vec2 depths = shared::focusDepths(view, pixel, q, radius);
      float& there = mask.depths[std::size_t(pixel.y) * std::size_t(view.size.x) + std::size_t(pixel.x)];
      if (depths.x <= 0.0f) return true;
      if (view.guidesDepth == 0)
        there = std::max(there, depths.y);
      else
        there = there < 0.0f ? depths.x : std::min(there, depths.x);
      return true;
    });
  }
  if (view.hasAperture != 0) flood(mask, view.size);
  return mask;
}

bool hides(const Instances& all, std::size_t i, const Mask& mask, const shared::FocusView& view) {
  auto cut = std::size_t(view.cut);
  const shared::TypeSpareRow& spare = all.spareOf(i, cut);
  if (spare.isFocus != 0.0f || spare.aperture <= 0.0f || randomOf(std::uint32_t(i), 1) < spare.viewShare) return false;
  glm::vec3 middle = all.middleOf(i), q = middle - glm::vec3(view.eye);
  float radius = all.radiusOf(i);
  glm::ivec4 rect = shared::focusRect(view, q, radius);
  if (rect.z < rect.x || rect.w < rect.y) return false;
  if (shared::instanceAnswer(all.cuts[cut], 0.0f, all.reachOf(i, cut), middle, all.sheets.view()) !=
      shared::kCutRemoves)
    return false;
  bool isFound = false, isOpenAll = spare.aperture >= 1.0f || view.hasAperture == 0;
  forPixels(rect, [&](glm::ivec2 pixel) {
    std::size_t at = std::size_t(pixel.y) * std::size_t(view.size.x) + std::size_t(pixel.x);
    if (mask.depths[at] >= 0.0f && shared::hidesFocus(shared::focusDepths(view, pixel, q, radius), mask.depths[at]))
      isFound = isOpenAll ||
                shared::apertureOpens(spare.aperture, shared::focusDistance(pixel, mask.seeds[at]), mask.longest);
    return !isFound;
  });
  return isFound;
}

/// By type: whether its instances are asked about.
std::vector<std::uint8_t> askedTypes(const Model& model, const std::vector<std::uint32_t>& types) {
  std::vector<std::uint8_t> isAsked(model.types.size(), types.empty() ? 1 : 0);
  for (std::uint32_t type : types) isAsked[type] = 1;
  return isAsked;
}

/// The types that are asked about, and those of the focuses, which are to be known to tell what hides them.
std::vector<std::uint8_t> clippedTypes(const Instances& all, const std::vector<model::FocusRow>& rows,
                                       std::vector<std::uint8_t> isAsked) {
  for (std::size_t type = 0; type < isAsked.size(); ++type)
    for (const model::FocusRow& row : rows)
      if (all.spares[type * all.cuts.size() + std::size_t(row.cut)].isFocus != 0.0f) isAsked[type] = 1;
  return isAsked;
}

}  // namespace

std::vector<InstanceState> instanceStates(const scene::Scene& scene, const SheetIndices& sheets, double aspect,
                                          const std::vector<std::uint32_t>& types) {
  if (!scene.model.data) return {};
  Instances all(scene, sheets);
  if (all.cuts.empty()) return all.states;
  std::vector<model::FocusRow> rows = model::focusRows(scene);
  std::vector<std::uint8_t> isAsked = askedTypes(all.model, types);
  clip(all, clippedTypes(all, rows, isAsked));
  if (rows.empty()) return all.states;
  std::vector<std::uint8_t> isShown;
  for (const MoleculeType& type : all.model.types)
    isShown.push_back(scene::typeLook(scene.model, pathOf(all.model, type)).visible ? 1 : 0);
  std::vector<std::uint8_t> isCleared(all.count(), 0);
  for (const model::FocusRow& row : rows) {
    shared::FocusView view = makeFocusView(scene, row, aspect, all.origin, all.radius);
    Mask mask = drawMask(all, isShown, view);
    all.forAll([&](std::size_t i) {
      std::uint32_t type = all.moleculeOf(i).type;
      bool asks = isAsked[type] && all.states[i] == InstanceState::Kept && isShown[type];
      if (asks && hides(all, i, mask, view)) isCleared[i] = 1;
    });
  }
  for (std::size_t i = 0; i < isCleared.size(); ++i)
    if (isCleared[i]) all.states[i] = InstanceState::Cleared;
  return all.states;
}

std::vector<std::uint8_t> keptInstances(const scene::Scene& scene, const SheetIndices& sheets, double aspect,
                                        const std::vector<std::uint32_t>& types) {
  std::vector<InstanceState> states = instanceStates(scene, sheets, aspect, types);
  std::vector<std::uint8_t> kept(states.size());
  std::transform(states.begin(), states.end(), kept.begin(),
                 [](InstanceState state) { return state == InstanceState::Kept ? 1 : 0; });
  return kept;
}

Model shownModel(const scene::Scene& scene, const std::vector<std::uint8_t>& kept) {
  const Model& model = *scene.model.data;
  ModelBuilder builder(model.name);
  // Compartments by their paths, types and molecules one by one: what is left empty goes when the model is built.
  std::vector<std::uint32_t> compartmentOf(model.compartments.size());
  for (std::size_t c = 0; c < model.compartments.size(); ++c) {
    std::vector<std::string> path;
    for (auto at = std::int32_t(c); model.compartments[std::size_t(at)].parent >= 0;
         at = model.compartments[std::size_t(at)].parent)
      path.insert(path.begin(), model.compartments[std::size_t(at)].name);
    compartmentOf[c] = builder.compartment(path);
  }
  std::vector<std::uint32_t> moleculeOf(model.molecules.size());
  for (const MoleculeType& type : model.types) {
    MoleculeType copy = type;
    copy.compartment = compartmentOf[type.compartment];
    std::uint32_t number = builder.addType(copy);
    for (std::uint32_t m = type.firstMolecule; m < type.firstMolecule + type.moleculeCount; ++m)
      moleculeOf[m] = builder.addMolecule(number, model.molecules[m].atoms, model.molecules[m].beads);
  }
  for (std::size_t t = 0; t < model.types.size(); ++t) {
    const MoleculeType& type = model.types[t];
    if (!scene::typeLook(scene.model, pathOf(model, type)).visible) continue;
    for (std::uint32_t i = type.firstInstance; i < type.firstInstance + type.instanceCount; ++i)
      if (kept[i])
        builder.addInstance(moleculeOf[model.instances[i].molecule], model.instances[i].position,
                            model.instances[i].rotation);
  }
  return builder.build();
}

}  // namespace velum::render
