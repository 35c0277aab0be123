#include "io/models/PlainModel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "io/read/FileNames.h"

namespace velum::io {

namespace {

struct Cloud {
  glm::dvec3 sum{0.0};
  double squares = 0.0, count = 0.0;

  glm::dvec3 middle() const { return sum / count; }
  double spread() const { return std::sqrt(std::max(squares / count - glm::dot(middle(), middle()), 0.0)); }
};

/// Whether all models lie about where the first does.
bool areAlternatives(const PlainStructure& structure) {
  std::map<int, Cloud> clouds;
  for (const StructurePart& part : structure.parts)
    for (const Atom& atom : part.atoms) {
      Cloud& cloud = clouds[part.model];
      glm::dvec3 p(atom.position);
      cloud.sum += p;
      cloud.squares += glm::dot(p, p);
      cloud.count += 1.0;
    }
  const Cloud& first = clouds.begin()->second;
  return clouds.size() > 1 && std::all_of(clouds.begin(), clouds.end(), [&](const auto& cloud) {
           return glm::length(cloud.second.middle() - first.middle()) < 0.5 * first.spread();
         });
}

}  // namespace

Model buildPlainModel(PlainStructure structure, const Path& path) {
  std::erase_if(structure.parts, [](const StructurePart& part) { return part.atoms.empty(); });
  if (structure.parts.empty()) refuse(path, "has no atoms");
  ModelBuilder builder(structure.title.empty() ? titleOf(path) : structure.title);
  if (areAlternatives(structure)) {
    int first = structure.parts.front().model;
    std::set<int> models;
    for (const StructurePart& part : structure.parts) models.insert(part.model);
    builder.warn(fmt::format("has {} models in one place; the first is taken", models.size()));
    std::erase_if(structure.parts, [&](const StructurePart& part) { return part.model != first; });
  }
  if (structure.copies.empty()) structure.copies.push_back({{}, {Pose{}}});
  std::map<std::string, std::uint32_t> types;
  std::vector<std::pair<std::string, std::uint32_t>> all;
  for (StructurePart& part : structure.parts) {
    auto [type, isNew] = types.try_emplace(part.type, 0);
    if (isNew) type->second = builder.addType({.name = part.type, .kind = part.kind});
    std::uint32_t molecule = builder.addMolecule(type->second, std::move(part.atoms));
    all.emplace_back(part.chain, molecule);
  }
  for (const PdbCopies& copies : structure.copies) {
    std::set<std::string> chains(copies.chains.begin(), copies.chains.end());
    for (const auto& [chain, molecule] : all)
      if (chains.empty() || chains.count(chain))
        for (const Pose& pose : copies.poses) place(builder, path, molecule, pose);
  }
  Model model = builder.build();
  if (model.instances.empty()) refuse(path, "its assembly names no chain that is there");
  return model;
}

}  // namespace velum::io
