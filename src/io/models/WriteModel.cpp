#include "io/models/WriteModel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

#include "core/Assert.h"
#include "core/FileName.h"
#include "core/SayCount.h"
#include "io/models/ModelWriters.h"
#include "io/read/Losses.h"
#include "io/read/Refuse.h"

namespace velum::io {

namespace {

constexpr glm::vec3 kGrey(0.7f);

struct Row {
  ModelWriteFormat format;
  void (*write)(const Model&, const ModelWriting&, ReplaceFile&, Progress&);
  bool keepsAtoms, keepsColors;
  std::string_view without;  ///< What is left out of every model, in words.
};
// A new format is one row.
constexpr Row kWriters[] = {
    {{"mmCIF (cellPACK)", ".cif .cif.gz"}, writeCif, true, false, ""},
    {{"glTF with instances", ".glb"},
     writeModelGltf,
     false,
     true,
     "molecules are shapes of balls, atoms and chains are left out; a unit is a nanometre, where glTF means a metre"},
    {{"list of instances", ".csv"}, writeModelCsv, false, true, "atoms and beads are left out: places alone"},
    {{"PLY points", ".ply"}, writeModelPly, false, true, "atoms and beads are left out: places alone, in angstrom"},
};

constexpr auto kFormats = [] {
  std::array<ModelWriteFormat, std::size(kWriters)> formats{};
  for (std::size_t i = 0; i < formats.size(); ++i) formats[i] = kWriters[i].format;
  return formats;
}();

const Row* rowOf(const std::filesystem::path& path) {
  std::string extension = lowerExtension(path);
  for (const Row& row : kWriters) {
    std::string_view rest = row.format.extensions;
    while (!rest.empty()) {
      std::size_t end = std::min(rest.find(' '), rest.size());
      if (rest.substr(0, end) == extension) return &row;
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  return nullptr;
}

/// Elements that mmCIF is written with; see symbolOf() in CifWriter.cpp.
bool hasOtherElements(const Model& model) {
  static const std::set<int> kWritten{kResidue, 1, 6, 7, 8, 15, 16};
  return std::any_of(model.molecules.begin(), model.molecules.end(), [](const Molecule& molecule) {
    return std::any_of(molecule.atoms.begin(), molecule.atoms.end(),
                       [](const Atom& atom) { return !kWritten.contains(atom.element); });
  });
}

std::vector<std::string> lossesOf(const Model& model, const ModelWriting& how, const Row& row) {
  Losses losses;
  losses.say(!row.without.empty(), "{}", row.without);
  losses.say(!how.colors.empty() && !row.keepsColors, "colours are left out: {} is written without", row.format.name);
  std::size_t ofBeads = 0, levels = 0;
  for (const Molecule& molecule : model.molecules) {
    if (molecule.atoms.empty()) ++ofBeads;
    levels = std::max(levels, molecule.beads.size());
  }
  losses.say(row.keepsAtoms && ofBeads > 0, "{}",
             sayCount(ofBeads, "the balls of 1 molecule become atoms without an element and a radius",
                      "the balls of {} molecules become atoms without an element and a radius"));
  losses.say(row.keepsAtoms && levels > (ofBeads > 0 ? 1u : 0u), "coarser balls of molecules are left out");
  losses.say(row.keepsAtoms && hasOtherElements(model), "atoms of rarer elements are written as carbon");
  losses.say(!model.fibres.empty(), "{}",
             sayCount(model.fibres.size(), "1 strand is written as its instances, without its curve",
                      "{} strands are written as their instances, without their curves"));
  return losses.take();
}

}  // namespace

std::span<const ModelWriteFormat> modelWriteFormats() { return kFormats; }

bool isModelWritten(const std::filesystem::path& path) { return rowOf(path) != nullptr; }

std::vector<std::string> writeModel(const Model& model, const std::filesystem::path& path, Progress& progress,
                                    const ModelWriting& how) {
  const Row* row = rowOf(path);
  if (!row) refuse(path, "models are written as .cif, .cif.gz, .glb, .csv or .ply");
  if (model.instances.empty()) refuse(path, "an empty model cannot be written");
  VELUM_ASSERT(how.colors.empty() || how.colors.size() == model.types.size(), "each type has its colour");
  VELUM_ASSERT(how.numbers.empty() || how.numbers.size() == model.instances.size(), "each instance has its number");
  VELUM_ASSERT(!how.levels || how.levels->firstLevel.size() == model.molecules.size() + 1, "levels are the model's");
  ModelWriting whole = how;
  if (whole.colors.empty())
    for (const MoleculeType& type : model.types) whole.colors.push_back(type.color.value_or(kGrey));
  whole.mostBalls = std::clamp(how.mostBalls, 1u, 1500u);
  ReplaceFile file(path);
  row->write(model, whole, file, progress);
  progress.throwIfCancelled();
  file.commit();
  return lossesOf(model, how, *row);
}

}  // namespace velum::io
