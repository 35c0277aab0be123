#include "SpareTable.h"

#include <algorithm>
#include <bit>

#include "velum/core/Assert.h"

namespace velum::render {

namespace {

shared::CutSpare toShared(const scene::Spare& spare) {
  return {spare.distance < double(shared::kCutFar) ? float(spare.distance) : shared::kCutFar, float(spare.share)};
}

}  // namespace

shared::CutSpare SpareTable::of(std::uint32_t structure, std::size_t cut) const {
  VELUM_ASSERT(cut < cuts, "rows have a place for each enabled cut, and for no other");
  std::uint32_t row = structure < rowOf.size() ? rowOf[structure] : 0;
  return row == 0 ? shared::CutSpare{0.0f, 0.0f} : rows[(row - 1) * cuts + cut];
}

SpareTable makeSpareTable(const scene::Scene& scene) {
  SpareTable table;
  table.cuts =
      std::size_t(std::count_if(scene.cuts.begin(), scene.cuts.end(), [](const auto& c) { return c.enabled; }));
  std::size_t place = 0;
  std::vector<bool> isKnown;  // of the rows, for the cut at hand
  for (const auto& cut : scene.cuts) {
    if (!cut.enabled) continue;
    isKnown.assign(isKnown.size(), false);
    for (const auto& spare : cut.spares) {
      auto structure = std::size_t(spare.structure);
      if (structure >= table.rowOf.size()) table.rowOf.resize(structure + 1, 0);
      std::uint32_t& row = table.rowOf[structure];
      if (row == 0) {
        table.rows.resize(table.rows.size() + table.cuts, {0.0f, 0.0f});
        row = std::uint32_t(table.rows.size() / table.cuts);
        isKnown.push_back(false);
      }
      if (isKnown[row - 1]) continue;
      isKnown[row - 1] = true;
      table.rows[(row - 1) * table.cuts + place] = toShared(spare);
      table.hasDepths = table.hasDepths || (spare.distance > 0.0 && spare.distance < double(shared::kCutFar));
    }
    ++place;
  }
  return table;
}

std::vector<glm::uvec2> spareTexels(const SpareTable& table) {
  std::vector<glm::uvec2> texels{{std::uint32_t(table.rowOf.size()), 0}};
  auto first = std::uint32_t(1 + table.rowOf.size());
  for (std::uint32_t row : table.rowOf)
    texels.emplace_back(row == 0 ? 0 : first + (row - 1) * std::uint32_t(table.cuts) + 1, 0);
  for (const shared::CutSpare& spare : table.rows)
    texels.emplace_back(std::bit_cast<std::uint32_t>(spare.distance), std::bit_cast<std::uint32_t>(spare.share));
  return texels;
}

}  // namespace velum::render
