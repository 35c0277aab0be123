#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "TestFiles.h"
#include "core/Error.h"
#include "io/models/ReadModel.h"

namespace velum::io {

inline Model readModelOf(const std::filesystem::path& path, bool completes = false) {
  Progress progress;
  return readModel(path, progress, {.completes = completes});
}

/// What the files themselves hold of a model.
struct ModelCounts {
  std::size_t types = 0, instances = 0;
  std::uint64_t atoms = 0, beads = 0;
};
inline ModelCounts countsOf(const Model& model) {
  ModelCounts counts;
  for (const MoleculeType& type : model.types) {
    if (type.origin != Origin::File) continue;
    ++counts.types;
    counts.instances += type.instanceCount;
    counts.atoms += atomCount(model, type);
    counts.beads += beadCount(model, type);
  }
  return counts;
}

/// The only type whose path ends so.
inline const MoleculeType& typeOf(const Model& model, const std::string& end) {
  static const MoleculeType kNone;
  const MoleculeType* found = nullptr;
  for (const MoleculeType& type : model.types)
    if (pathOf(model, type).ends_with(end)) {
      EXPECT_EQ(found, nullptr) << end << " names several types";
      found = &type;
    }
  EXPECT_NE(found, nullptr) << "no type " << end;
  return found ? *found : kNone;
}
inline std::span<const Instance> instancesOf(const Model& model, const MoleculeType& type) {
  return std::span(model.instances).subspan(type.firstInstance, type.instanceCount);
}
/// Where the middle of an instance's atoms is.
inline glm::vec3 middleOf(const Model& model, const Instance& instance) {
  glm::dvec3 sum(0.0);
  const auto& atoms = model.molecules[instance.molecule].atoms;
  for (const Atom& atom : atoms) sum += glm::dvec3(atom.position);
  return instance.position + instance.rotation * glm::vec3(sum / double(std::max<std::size_t>(atoms.size(), 1)));
}

/// The law of errors for models: one line that names the file.
inline void expectClearRefusal(const std::filesystem::path& path) {
  try {
    Model model = readModelOf(path);
    FAIL() << path << " opened with " << model.instances.size() << " instances";
  } catch (const InputError& error) {
    std::string message = error.what();
    EXPECT_NE(message.find(path.filename().string()), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

/// Atoms as a PDB file has them.
inline std::string pdbAtom(const char* record, const char* name, const char* residue, char chain, int number,
                           glm::vec3 p, const char* element) {
  return fmt::format("{:<6}{:>5} {:<4} {:>3} {}{:>4}    {:8.3f}{:8.3f}{:8.3f}  1.00  0.00          {:>2}\n", record, 1,
                     name, residue, chain, number, p.x, p.y, p.z, element);
}

}  // namespace velum::io
