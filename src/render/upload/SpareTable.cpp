#include "render/upload/SpareTable.h"

#include <algorithm>
#include <bit>

#include "core/Assert.h"
#include "scene/Scene.h"
#include "scene/Shown.h"

namespace velum::render {

namespace {

float depthOf(const scene::Spare& spare) {
  return spare.distance < double(shared::kCutFar) ? float(spare.distance) : shared::kCutFar;
}

}  // namespace

float SpareTable::depthOf(std::uint32_t structure, std::size_t cut) const {
  VELUM_ASSERT(cut < cuts, "rows have a place for each enabled cut, and for no other");
  std::uint32_t row = structure < rowOf.size() ? rowOf[structure] : 0;
  return row == 0 ? 0.0f : depths[(row - 1) * cuts + cut];
}

SpareTable makeSpareTable(const scene::Scene& scene) {
  SpareTable table;
  table.cuts = std::size_t(std::ranges::distance(scene::enabledOf(scene.cuts)));
  std::size_t place = 0;
  std::vector<bool> isKnown;  // of the rows, for the cut at hand
  for (const auto& cut : scene::enabledOf(scene.cuts)) {
    isKnown.assign(isKnown.size(), false);
    for (const auto& spare : cut.spares) {
      auto structure = std::size_t(spare.structure);
      if (structure >= table.rowOf.size()) table.rowOf.resize(structure + 1, 0);
      std::uint32_t& row = table.rowOf[structure];
      if (row == 0) {
        table.depths.resize(table.depths.size() + table.cuts, 0.0f);
        row = std::uint32_t(table.depths.size() / table.cuts);
        isKnown.push_back(false);
      }
      if (isKnown[row - 1]) continue;
      isKnown[row - 1] = true;
      table.depths[(row - 1) * table.cuts + place] = depthOf(spare);
      table.hasDepths = table.hasDepths || (spare.distance > 0.0 && spare.distance < double(shared::kCutFar));
    }
    ++place;
  }
  return table;
}

std::vector<std::uint32_t> spareTexels(const SpareTable& table) {
  std::vector<std::uint32_t> texels{std::uint32_t(table.rowOf.size())};
  auto first = std::uint32_t(1 + table.rowOf.size());
  for (std::uint32_t row : table.rowOf)
    texels.push_back(row == 0 ? 0 : first + (row - 1) * std::uint32_t(table.cuts) + 1);
  for (float depth : table.depths) texels.push_back(std::bit_cast<std::uint32_t>(depth));
  return texels;
}

}  // namespace velum::render
