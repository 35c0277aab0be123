#include "session/model/HiddenInside.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/Model.h"
#include "scene/Scene.h"
#include "session/model/ModelEdit.h"

namespace velum::session {

namespace {

constexpr std::uint64_t kNextToNothing = 100;  ///< of so many instances one may be seen
constexpr std::uint64_t kFew = 20;             ///< instances that may well be hidden: nobody looks for them
constexpr std::size_t kMostNames = 3;

}  // namespace

std::vector<std::uint32_t> hiddenInside(const scene::Scene& scene, const std::vector<Counts>& counts) {
  const Shared<Model>& model = scene.model.data;
  bool isCut = std::any_of(scene.cuts.begin(), scene.cuts.end(), [](const auto& cut) { return cut.enabled; });
  if (!model || isCut || counts.size() != model->compartments.size() || counts.empty()) return {};
  if (counts[0].visible() == 0) return {};
  auto isHidden = [&](std::uint32_t c) {
    return counts[c].left() > kFew && counts[c].visible() * kNextToNothing < counts[c].left();
  };
  std::vector<std::uint32_t> hidden;
  for (std::uint32_t c = 1; c < counts.size(); ++c) {
    std::int32_t parent = model->compartments[c].parent;
    if (isHidden(c) && !(parent > 0 && isHidden(std::uint32_t(parent)))) hidden.push_back(c);
  }
  return hidden;
}

std::string hiddenWords(const scene::Scene& scene, const std::vector<std::uint32_t>& compartments) {
  if (compartments.empty()) return {};
  const Model& model = *scene.model.data;
  std::string names;
  std::size_t told = std::min(compartments.size(), kMostNames);
  for (std::size_t i = 0; i < told; ++i) {
    std::string path = compartmentPath(model, compartments[i]);
    bool isLast = i + 1 == compartments.size();
    names += (i == 0   ? ""
              : isLast ? " and "
                       : ", ") +
             scene::shownName(scene.model, path, model.compartments[compartments[i]].name);
  }
  if (compartments.size() > told) names += fmt::format(" and {} more", compartments.size() - told);
  return fmt::format("Next to nothing is seen of {}: what is around {} hides {}.", names,
                     compartments.size() == 1 ? "it" : "them", compartments.size() == 1 ? "it" : "them");
}

}  // namespace velum::session
