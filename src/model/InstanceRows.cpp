#include "model/InstanceRows.h"

#include <algorithm>
#include <unordered_map>

#include "scene/Scene.h"
#include "scene/Shown.h"
#include "shared/instance.h"

namespace velum::model {

namespace {

/// True of a path and of those that it leads to.
bool leadsTo(std::string_view path, std::string_view to) {
  return to.starts_with(path) && (to.size() == path.size() || to[path.size()] == '.');
}

bool isInFocus(const scene::Cut& cut, std::string_view path) {
  auto leads = [&](const scene::FocusType& type) { return leadsTo(type.type, path); };
  return cut.model.focus && std::any_of(cut.model.focus->types.begin(), cut.model.focus->types.end(), leads);
}

bool isInRange(const scene::Cut& cut, const MoleculeType& type) {
  return type.mass >= cut.model.leastMass && type.mass <= cut.model.mostMass &&
         type.instanceCount >= cut.model.leastCopies && type.instanceCount <= cut.model.mostCopies;
}

shared::TypeSpareRow toShared(const scene::TypeSpare& spare) {
  shared::TypeSpareRow row{};
  row.share = float(spare.share);
  row.distance = spare.distance < double(shared::kCutFar) ? float(spare.distance) : shared::kCutFar;
  row.falloff = float(spare.falloff);
  row.amount = float(spare.amount);
  row.exponent = float(spare.exponent);
  row.viewShare = float(spare.viewShare);
  row.aperture = float(spare.aperture);
  return row;
}

}  // namespace

std::vector<shared::TypeRow> makeTypeRows(const scene::ModelLayer& layer) {
  std::vector<shared::TypeRow> rows;
  for (const glm::vec3& color : scene::typeColors(layer)) rows.push_back({glm::vec4(color, shared::kTypeShown)});
  if (layer.types.empty() && layer.ghosts == scene::Ghosts::None) return rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    scene::TypeLook look = scene::typeLook(layer, pathOf(*layer.data, layer.data->types[i]));
    scene::Ghosts ghosts = scene::ghostsOf(layer, look);
    if (ghosts != scene::Ghosts::None)
      rows[i].color.a = ghosts == scene::Ghosts::Filled ? shared::kTypeFilled : shared::kTypeContour;
    if (!look.visible) rows[i].color.a = shared::kTypeHidden;
  }
  return rows;
}

namespace {

/// The rows of a cut by their paths: thousands of types may have one each.
class RowsByPath {
 public:
  explicit RowsByPath(const scene::Cut& cut) : mCut(cut) {
    for (const scene::TypeSpare& spare : cut.model.spares) mRows.try_emplace(spare.type, &spare);
  }
  const scene::Cut& cut() const { return mCut; }
  /// That of the longest path that leads to a type's.
  scene::TypeSpare of(const MoleculeType& type, std::string_view path) const {
    scene::TypeSpare none;
    none.share = 0.0;
    if (!isInRange(mCut, type)) return none;
    for (std::string_view at = path; !at.empty();) {
      if (auto found = mRows.find(at); found != mRows.end()) return *found->second;
      std::size_t dot = at.rfind('.');
      at = dot == std::string_view::npos ? std::string_view() : at.substr(0, dot);
    }
    return none;
  }

 private:
  const scene::Cut& mCut;
  std::unordered_map<std::string_view, const scene::TypeSpare*> mRows;
};

}  // namespace

scene::TypeSpare typeSpareOf(const scene::Cut& cut, const Model&, const MoleculeType& type, std::string_view path) {
  return RowsByPath(cut).of(type, path);
}

std::vector<shared::TypeSpareRow> makeTypeSpareRows(const scene::Scene& scene) {
  std::vector<shared::TypeSpareRow> rows;
  if (!scene.model.data) return rows;
  const Model& model = *scene.model.data;
  std::vector<RowsByPath> cuts;
  for (const scene::Cut& cut : scene::enabledOf(scene.cuts)) cuts.emplace_back(cut);
  for (const MoleculeType& type : model.types) {
    std::string path = pathOf(model, type);
    for (const RowsByPath& cut : cuts) {
      rows.push_back(toShared(cut.of(type, path)));
      rows.back().isFocus = isInFocus(cut.cut(), path) ? 1.0f : 0.0f;
    }
  }
  return rows;
}

std::uint32_t wholeInstanceBits(const scene::Scene& scene) {
  std::uint32_t bits = 0;
  int place = 0;
  for (const scene::Cut& cut : scene::enabledOf(scene.cuts)) {
    if (cut.model.wholeInstances && place < 32) bits |= 1u << place;
    ++place;
  }
  return bits;
}

}  // namespace velum::model
