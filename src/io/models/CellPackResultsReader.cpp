#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "core/FileName.h"
#include "core/Parallel.h"
#include "core/SayCount.h"
#include "io/models/Completion.h"
#include "io/models/ModelReaders.h"
#include "io/models/RotationSense.h"
#include "io/models/Strands.h"
#include "io/models/StructureFiles.h"
#include "io/read/FileNames.h"
#include "io/read/JsonParts.h"

/// Results of cellPACK, as autoPACK and its successors to 2016 wrote them: JSON with a recipe and, for each ingredient,
/// where its copies stand and how they are turned. Positions are in angstrom and right-handed, quaternions w, x, y, z.
namespace velum::io {

namespace {

struct Ingredient {
  std::vector<std::string> path;
  std::string name;
  const Json* json;
  std::string structure;  ///< As the file names it; empty when it names none.
  bool isSurface = false, isCentred = false, hasCopies = false;
  std::vector<Instance> instances = {};
  std::vector<std::vector<glm::vec3>> curves = {};
};

/// A rotation as four numbers, or as a matrix of three or four rows.
glm::quat rotationOf(const Json& value, const Path& path, const std::string& what) {
  if (!value.is_array() || value.empty()) refuse(path, fmt::format("{} has no rotation", what));
  if (!value[0].is_array()) {
    std::vector<double> q = numbersOf(value, path, what);
    if (q.size() != 4) refuse(path, fmt::format("{} has a rotation of {} numbers", what, q.size()));
    return glm::quat(float(q[0]), float(q[1]), float(q[2]), float(q[3]));
  }
  if (value.size() < 3) refuse(path, fmt::format("{} has a rotation of {} rows", what, value.size()));
  glm::dmat3 matrix(1.0);
  for (int row = 0; row < 3; ++row) {
    std::vector<double> numbers = numbersOf(value[std::size_t(row)], path, what);
    if (numbers.size() < 3) refuse(path, fmt::format("{} has a rotation of {} columns", what, numbers.size()));
    for (int column = 0; column < 3; ++column) matrix[column][row] = numbers[std::size_t(column)];
  }
  auto pose = poseOf(matrix, glm::dvec3(0.0));
  if (!pose) refuse(path, fmt::format("{} has a matrix that is no rotation", what));
  return pose->rotation;
}

/// Balls at all levels of detail that the file has.
std::vector<std::vector<glm::vec4>> beadsOf(const Json& ingredient, const Path& path, const std::string& what) {
  std::vector<std::vector<glm::vec4>> levels;
  const Json &positions = memberOf(ingredient, "positions"), &radii = memberOf(ingredient, "radii");
  if (!positions.is_array() || !radii.is_array()) return levels;
  for (std::size_t i = 0; i < std::min(positions.size(), radii.size()); ++i) {
    std::vector<glm::vec3> places = pointsOf(positions[i], path, what);
    std::vector<double> sizes = numbersOf(radii[i], path, what);
    if (places.size() != sizes.size())
      refuse(path, fmt::format("{} has {} beads and {} radii", what, places.size(), sizes.size()));
    std::vector<glm::vec4> level;
    for (std::size_t b = 0; b < places.size(); ++b) level.emplace_back(places[b], float(std::abs(sizes[b])));
    levels.push_back(std::move(level));
  }
  // The finest first.
  std::stable_sort(levels.begin(), levels.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return levels;
}

/// Beads of another molecule, or in another frame, than the atoms in this sphere.
bool liesElsewhere(std::span<const glm::vec4> beads, glm::vec4 sphere) {
  return std::any_of(beads.begin(), beads.end(), [&](const glm::vec4& b) {
    return glm::length(glm::vec3(b) - glm::vec3(sphere)) > 1.25f * sphere.w;
  });
}

/// Half the distance of the two that are next to each other, up to 60 angstrom: they were packed without overlaps.
float halfLeastDistance(std::span<const Instance> instances) {
  constexpr float kMost = 60.0f, kLeast = 10.0f, kCell = 2.0f * kMost;
  std::unordered_map<std::int64_t, std::vector<glm::vec3>> cells;
  auto keyOf = [](glm::ivec3 c) {
    return (std::int64_t(c.x) * 73856093) ^ (std::int64_t(c.y) * 19349663) ^ (std::int64_t(c.z) * 83492791);
  };
  auto cellOf = [](glm::vec3 p) { return glm::ivec3(glm::floor(glm::clamp(p, -1e8f, 1e8f) / kCell)); };
  float least = 2.0f * kMost;
  for (const Instance& instance : instances) {
    glm::ivec3 cell = cellOf(instance.position);
    for (int i = 0; i < 27; ++i) {
      auto at = cells.find(keyOf(cell + glm::ivec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)));
      if (at == cells.end() || at->second.size() > 4096) continue;
      for (glm::vec3 other : at->second) least = std::min(least, glm::length(other - instance.position));
    }
    cells[keyOf(cell)].push_back(instance.position);
  }
  return std::max(0.5f * least, kLeast);
}

class ResultsReader {
 public:
  ResultsReader(const Path& path, Progress& progress, const ModelReading& reading)
      : mPath(path),
        mProgress(progress),
        mReading(reading),
        mRoot(parseJson(textOf(path), path)),
        mBuilder(titleOf(path)) {}

  Model read() {
    mProgress.report(0.1, "reading model");
    gather();
    chooseSense();
    readStructures();
    mProgress.report(0.6, "reading model");
    for (Ingredient& ingredient : mIngredients) add(ingredient);
    if (!mMissing.empty())
      mBuilder.sayAdded(sayCount(mMissing.size(), "balls stand for {} type whose structure is not to be found, {}",
                                 "balls stand for {} types whose structures are not to be found, such as {}",
                                 mMissing.front()));
    if (mReading.completes) completeVirus(mBuilder, mPath);
    Model model = mBuilder.build();
    if (model.instances.empty()) refuse(mPath, "has a recipe but no instances");
    mProgress.report(1.0, "reading model");
    return model;
  }

 private:
  void gather() {
    for (const char* name : {"cytoplasme", "cytoplasm"}) gatherFrom(memberOf(mRoot, name), {name}, false);
    const Json& compartments = memberOf(mRoot, "compartments");
    if (compartments.is_object())
      for (const auto& [name, compartment] : compartments.items())
        for (const char* part : {"surface", "interior"})
          gatherFrom(memberOf(compartment, part), {name, part}, std::string_view(part) == "surface");
  }

  void gatherFrom(const Json& part, const std::vector<std::string>& path, bool isSurface) {
    const Json& ingredients = memberOf(part, "ingredients");
    if (!ingredients.is_object()) return;
    for (const auto& [key, json] : ingredients.items()) {
      std::string given = wordOf(memberOf(json, "name"));
      Ingredient ingredient{.path = path, .name = given.empty() ? key : given, .json = &json};
      const Json& source = memberOf(json, "source");
      ingredient.isSurface = isSurface;
      ingredient.structure = wordOf(memberOf(source, "pdb"));
      ingredient.isCentred = isTrue(memberOf(memberOf(source, "transform"), "center"));
      ingredient.hasCopies = isTrue(memberOf(source, "biomt"));
      if (!memberOf(json, "principalAxis").is_null() || !memberOf(json, "principalVector").is_null())
        refuse(mPath, "is of a newer cellPACK, whose JSON is left-handed in its own way; open the mmCIF of the model");
      readPlaces(ingredient);
      mIngredients.push_back(std::move(ingredient));
    }
  }

  void readPlaces(Ingredient& ingredient) {
    const Json& results = memberOf(*ingredient.json, "results");
    if (results.is_array())
      for (const Json& result : results) {
        if (!result.is_array() || result.size() < 2)
          refuse(mPath, ingredient.name + " has an instance without a place");
        ingredient.instances.push_back({.position = glm::vec3(vectorOf(result[0], mPath, ingredient.name)),
                                        .rotation = rotationOf(result[1], mPath, ingredient.name)});
      }
    const Json& count = memberOf(*ingredient.json, "nbCurve");
    if (!count.is_number()) return;
    // Counted until one is missing: the number itself may be anything.
    for (std::int64_t i = 0; i < count.get<std::int64_t>(); ++i) {
      const Json& curve = memberOf(*ingredient.json, fmt::format("curve{}", i));
      if (curve.is_null()) refuse(mPath, fmt::format("{} lacks its curve {}", ingredient.name, i));
      ingredient.curves.push_back(pointsOf(curve, mPath, ingredient.name));
    }
  }

  /// Some models have their rotations the other way round (Mycoplasma 1.5): what stands on a surface tells.
  void chooseSense() {
    std::map<std::vector<std::string>, std::pair<glm::dvec3, double>> middles;
    for (const Ingredient& i : mIngredients)
      if (i.isSurface)
        for (const Instance& instance : i.instances) {
          middles[i.path].first += glm::dvec3(instance.position);
          middles[i.path].second += 1.0;
        }
    double direct = 0.0, inverse = 0.0, count = 0.0;
    for (const Ingredient& i : mIngredients) {
      if (!i.isSurface || i.instances.size() < 4) continue;
      const auto& [sum, ofSum] = middles[i.path];
      glm::vec3 middle(sum / ofSum);
      double weight = double(i.instances.size());
      direct += weight * outwardAgreement(i.instances, middle, false);
      inverse += weight * outwardAgreement(i.instances, middle, true);
      count += weight;
    }
    // In between nothing is told, and the usual way is taken.
    if (count == 0.0 || inverse < direct + 0.2 * count) return;
    mBuilder.warn(
        fmt::format("rotations are read the other way round: so {:.0f} % instead of {:.0f} % of the directions "
                    "on surfaces agree",
                    100 * inverse / count, 100 * direct / count));
    for (Ingredient& i : mIngredients)
      for (Instance& instance : i.instances) instance.rotation = glm::conjugate(instance.rotation);
  }

  void readStructures() {
    StructureFiles files(mPath);
    struct Wanted {
      Path path;
      bool hasCopies;
    };
    std::vector<Wanted> wanted;
    mFileOf.assign(mIngredients.size(), kNone);
    for (std::size_t i = 0; i < mIngredients.size(); ++i) {
      const Ingredient& ingredient = mIngredients[i];
      auto file = files.find(ingredient.structure);
      if (!file) file = files.find(ingredient.name);
      if (!file && !ingredient.curves.empty()) file = files.find(baseOf(ingredient));
      if (!file) continue;
      auto same = std::find_if(wanted.begin(), wanted.end(),
                               [&](const Wanted& w) { return w.path == *file && w.hasCopies == ingredient.hasCopies; });
      mFileOf[i] = std::size_t(same - wanted.begin());
      if (same == wanted.end()) wanted.push_back({*file, ingredient.hasCopies});
    }
    mStructures.resize(wanted.size());
    parallelFor(std::size_t(0), wanted.size(), [&](std::size_t i) {
      mProgress.throwIfCancelled();
      mStructures[i] = readStructure(wanted[i].path, wanted[i].hasCopies);
    });
  }

  /// The file of the unit of a strand of nucleic acid, as readers of cellPACK name it.
  static std::string baseOf(const Ingredient& ingredient) {
    std::string name = lowerCase(ingredient.name);
    return name.ends_with("dna") ? "b-basepair" : name.ends_with("rna") ? "RNA_G_Base" : std::string();
  }

  void add(Ingredient& ingredient) {
    mProgress.throwIfCancelled();
    MoleculeType type{.name = ingredient.name, .compartment = mBuilder.compartment(ingredient.path)};
    type.structure = ingredient.structure == "None" ? std::string() : ingredient.structure;
    std::size_t index = std::size_t(&ingredient - mIngredients.data());
    StructureParts parts;
    if (mFileOf[index] != kNone) parts = mStructures[mFileOf[index]];
    if (parts.isNucleic) type.kind = MoleculeKind::NucleicAcid;
    if (!ingredient.curves.empty()) {
      addCurves(ingredient, std::move(type), std::move(parts));
      return;
    }
    if (ingredient.instances.empty()) return;
    std::vector<std::vector<glm::vec4>> beads = beadsOf(*ingredient.json, mPath, ingredient.name);
    if (!parts.beads.empty()) beads.insert(beads.begin(), std::move(parts.beads));
    if (ingredient.isCentred) centre(parts.atoms, beads);
    if (!parts.atoms.empty() && std::any_of(beads.begin(), beads.end(), [&](const auto& level) {
          return liesElsewhere(level, sphereAround(parts.atoms, {}));
        })) {
      mBuilder.warn(fmt::format("the beads of {} are not where its atoms are, and are left out", ingredient.name));
      beads.clear();
    }
    if (parts.atoms.empty() && beads.empty()) {
      beads.push_back({glm::vec4(0, 0, 0, halfLeastDistance(ingredient.instances))});
      mMissing.push_back(ingredient.name);
    }
    std::uint32_t molecule =
        mBuilder.addMolecule(mBuilder.addType(std::move(type)), std::move(parts.atoms), std::move(beads));
    for (const Instance& instance : ingredient.instances)
      place(mBuilder, mPath, molecule, {instance.rotation, instance.position});
  }

  /// To the mean of the atoms; beads without atoms to their own.
  static void centre(std::vector<Atom>& atoms, std::vector<std::vector<glm::vec4>>& beads) {
    if (!atoms.empty()) return move(atoms, -meanOf(atoms));
    if (beads.empty()) return;
    glm::dvec3 sum(0.0);
    for (const glm::vec4& b : beads.front()) sum += glm::dvec3(b);
    glm::vec4 mean(glm::vec3(sum / double(beads.front().size())), 0.0f);
    for (auto& level : beads)
      for (glm::vec4& b : level) b -= mean;
  }

  /// Units as cellVIEW draws them: nucleotides, or balls that overlap by half.
  void addCurves(const Ingredient& ingredient, MoleculeType type, StructureParts parts) {
    StrandUnit unit = kNucleotide;
    std::vector<std::vector<glm::vec4>> beads;
    if (parts.atoms.empty()) {
      bool isSugar = lowerCase(ingredient.name).find("glyc") != std::string::npos;
      bool isNucleic = !baseOf(ingredient).empty();
      float radius = isSugar ? 8.0f : isNucleic ? 10.0f : 3.0f;
      unit = {radius, 0.0f};
      beads.push_back({glm::vec4(0, 0, 0, radius)});
      if (isNucleic || isSugar) type.kind = isSugar ? MoleculeKind::Other : MoleculeKind::NucleicAcid;
    }
    type.origin = Origin::Curves;
    std::uint32_t index = mBuilder.addType(std::move(type));
    std::uint32_t molecule = mBuilder.addMolecule(index, std::move(parts.atoms), std::move(beads));
    for (const auto& curve : ingredient.curves) {
      // Before they are made: two points may be any distance apart.
      double length = 0.0;
      for (std::size_t i = 1; i < curve.size(); ++i) length += double(glm::length(curve[i] - curve[i - 1]));
      if (length / double(unit.step) > double(kMostInstances - mBuilder.instanceCount()))
        refuse(mPath, fmt::format("{} has a curve of {:.0f} angstrom", ingredient.name, length));
      mBuilder.beginFibre();
      walkAlong(curve, unit, [&](const Pose& pose) { place(mBuilder, mPath, molecule, pose); });
      mBuilder.addFibre(index, curve);
    }
  }

  static constexpr std::size_t kNone = ~std::size_t(0);

  const Path& mPath;
  Progress& mProgress;
  const ModelReading& mReading;
  Json mRoot;
  ModelBuilder mBuilder;
  std::vector<Ingredient> mIngredients;
  std::vector<StructureParts> mStructures;
  std::vector<std::size_t> mFileOf;  ///< of each ingredient, in mStructures
  std::vector<std::string> mMissing;
};

}  // namespace

Model readCellPackResults(const Path& path, Progress& progress, const ModelReading& reading) {
  return ResultsReader(path, progress, reading).read();
}

}  // namespace velum::io
