#include "io/models/BeadDetails.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtx/quaternion.hpp>
#include <map>
#include <optional>

#include "core/FileName.h"
#include "core/Parallel.h"
#include "core/Text.h"
#include "io/models/StructureFiles.h"
#include "io/read/FileNames.h"

namespace velum::io {

namespace {

/// What a table of proteins says of one.
struct ProteinRow {
  double mass = 0.0;
  std::string function, label;
  glm::vec3 offset{0.0f};
  std::optional<glm::vec3> axis;  ///< Points out of the membrane.
};

/// The fields of a line of CSV; quotes hold commas together.
std::vector<std::string> fieldsOf(std::string_view line) {
  std::vector<std::string> fields(1);
  bool isQuoted = false;
  for (char c : line) {
    if (c == '"')
      isQuoted = !isQuoted;
    else if (c == ',' && !isQuoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  for (std::string& field : fields) field = std::string(trimmed(field));
  return fields;
}

std::optional<glm::vec3> vectorIn(std::string text) {
  std::replace(text.begin(), text.end(), ',', ' ');
  std::string_view rest(text);
  glm::vec3 v;
  for (int axis = 0; axis < 3; ++axis) {
    auto value = takeNumber(rest);
    if (!value || !(std::abs(*value) < 1e6)) return std::nullopt;
    v[axis] = float(*value);
  }
  return v;
}

std::map<std::string, ProteinRow> readProteinTable(const Path& path) {
  std::map<std::string, ProteinRow> rows;
  std::string text = textOf(path);
  std::string_view rest(text);
  std::map<std::string, std::size_t> columns;
  while (!rest.empty()) {
    std::size_t end = std::min(rest.find('\n'), rest.size());
    std::vector<std::string> fields = fieldsOf(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (columns.empty()) {
      for (std::size_t i = 0; i < fields.size(); ++i) columns.try_emplace(lowerCase(fields[i]), i);
      if (!columns.count("name") || !columns.count("molecular_weight")) return rows;
      continue;
    }
    auto field = [&](const char* name) {
      auto at = columns.find(name);
      return at != columns.end() && at->second < fields.size() ? fields[at->second] : std::string();
    };
    ProteinRow row{.function = field("function"), .label = field("label")};
    double mass = numberIn(field("molecular_weight")).value_or(0.0);
    if (mass > 0.0 && mass < 1e12) row.mass = mass;
    row.offset = vectorIn(field("offset")).value_or(glm::vec3(0.0f));
    row.axis = vectorIn(field("pcpalaxis"));
    rows.try_emplace(field("name"), std::move(row));
  }
  return rows;
}

/// Mean distance of the beads from the nearest atom; every seventh is looked at.
float misfit(std::span<const glm::vec4> beads, std::span<const Atom> atoms, const Pose& pose) {
  double sum = 0.0;
  for (const glm::vec4& bead : beads) {
    float least = 1e9f;
    for (std::size_t i = 0; i < atoms.size(); i += 7)
      least = std::min(least, glm::length(pose.rotation * atoms[i].position + pose.position - glm::vec3(bead)));
    sum += double(least);
  }
  return float(sum / double(beads.size()));
}

/// The rotation by which an axis comes to lie on z.
glm::quat toZ(glm::vec3 axis) {
  float length = glm::length(axis);
  if (!(length > 1e-6f)) return {1, 0, 0, 0};
  return glm::rotation(axis / length, glm::vec3(0, 0, 1));
}

/// Moves atoms, whose middle is at the origin, to where the beads are; false where nothing comes near. Files of beads
/// do not say how they were made of a structure: those inside were centred, those of membranes moved and turned.
bool fitToBeads(std::vector<Atom>& atoms, std::span<const glm::vec4> beads, const ProteinRow& row) {
  constexpr float kMost = 6.0f;  // of beads that stand for 20 angstrom and more
  glm::vec3 middle(0.0f);
  for (const glm::vec4& bead : beads) middle += glm::vec3(bead) / float(beads.size());
  glm::quat turn = toZ(row.axis.value_or(glm::vec3(0, 0, 1)));
  const Pose kWays[] = {{{1, 0, 0, 0}, glm::vec3(0)},
                        {turn, turn * row.offset},
                        {turn, turn * -row.offset},
                        {{1, 0, 0, 0}, middle},
                        {turn, middle},
                        {glm::conjugate(turn), middle}};
  const Pose* best = &kWays[0];
  float least = 1e9f;
  for (const Pose& way : kWays)
    if (float own = misfit(beads, atoms, way); own < least - 0.05f) least = own, best = &way;
  if (least > kMost) return false;
  for (Atom& atom : atoms) atom.position = best->rotation * atom.position + best->position;
  return true;
}

}  // namespace

void addBeadDetails(ModelBuilder& builder, const std::vector<BeadMolecule>& molecules, const Path& path,
                    Progress& progress) {
  std::map<std::string, ProteinRow> table;
  Path folder = std::filesystem::absolute(path).parent_path();
  for (const Path& file : filesInOrder(folder))
    if (lowerExtension(file) == ".csv" && table.empty()) table = readProteinTable(file);
  StructureFiles files(path);
  std::vector<std::vector<Atom>> atomsOf(molecules.size());
  std::vector<char> isUnlike(molecules.size(), 0);
  parallelFor(std::size_t(0), molecules.size(), [&](std::size_t i) {
    progress.throwIfCancelled();
    auto file = files.find(molecules[i].name);
    const auto& beads = builder.molecule(molecules[i].molecule).beads;
    if (!file || beads.empty()) return;
    std::vector<Atom> atoms = readStructure(*file, false).atoms;
    if (atoms.empty()) return;
    move(atoms, -meanOf(atoms));
    auto row = table.find(molecules[i].name);
    isUnlike[i] = !fitToBeads(atoms, beads.front(), row == table.end() ? ProteinRow() : row->second);
    if (!isUnlike[i]) atomsOf[i] = std::move(atoms);
  });
  for (std::size_t i = 0; i < molecules.size(); ++i) {
    MoleculeType& type = builder.type(molecules[i].type);
    if (auto row = table.find(molecules[i].name); row != table.end()) {
      if (type.function.empty()) type.function = row->second.function;
      if (type.description.empty()) type.description = row->second.label;
      if (row->second.mass > 0.0 && type.massSource == MassSource::Unknown)
        type.mass = row->second.mass, type.massSource = MassSource::File;
    }
    if (isUnlike[i])
      builder.warn(fmt::format("the structure of {} does not lie where its beads are, and is left out", type.name));
    if (!atomsOf[i].empty()) builder.setAtoms(molecules[i].molecule, std::move(atomsOf[i]));
  }
}

}  // namespace velum::io
