#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/FileName.h"
#include "io/models/Assembly.h"
#include "io/models/BeadDetails.h"
#include "io/models/CifAtoms.h"
#include "io/models/CifModels.h"
#include "io/read/FileNames.h"

/// The flavour of mmCIF of cellPACK and Mesoscope: entities are types, whose description is their path in the tree, and
/// one assembly has all instances. An operator places all asyms of an entity together, but for lipids, of which each
/// is an asym.
namespace velum::io {

namespace {

/// Balls of these files have no size; in the one that is published they are of this, and strands of them touch.
constexpr float kBeadRadius = 21.0f;
/// Longer steps than so many usual ones end a strand.
constexpr float kJump = 3.0f;

float medianStep(std::span<const glm::vec3> points) {
  std::vector<float> steps;
  for (std::size_t i = 1; i < points.size(); ++i) steps.push_back(glm::length(points[i] - points[i - 1]));
  if (steps.empty()) return 0.0f;
  std::nth_element(steps.begin(), steps.begin() + std::ptrdiff_t(steps.size() / 2), steps.end());
  return steps[steps.size() / 2];
}

/// Calls body(first, end) for each strand.
template <class Body>
void forStrands(std::span<const glm::vec3> points, const Body& body) {
  float most = kJump * medianStep(points);
  std::size_t first = 0;
  for (std::size_t i = 1; i <= points.size(); ++i) {
    if (i < points.size() && glm::length(points[i] - points[i - 1]) <= most) continue;
    body(first, i);
    first = i;
  }
}

class CellPackReader {
 public:
  CellPackReader(const CifBlock& block, const Path& path, Progress& progress)
      : mBlock(block),
        mPath(path),
        mProgress(progress),
        mAtoms(readCifAtoms(block, path)),
        mBuilder(titleOf(path)),
        mOperators(block.find("pdbx_struct_oper_list"), path) {}

  Model read() {
    mProgress.report(0.4, "reading model");
    for (std::size_t code = 0; code < mAtoms.asym.names.size(); ++code)
      mAsyms[mAtoms.asym.names[code]] = std::uint32_t(code);
    nameEntities();
    gatherPlacings();
    for (std::uint32_t entity : mOrder) addEntity(entity);
    if (mAtoms.areBeads) addBeadDetails(mBuilder, mDetailed, mPath, mProgress);
    Model model = mBuilder.build();
    if (model.instances.empty()) refuse(mPath, "has types but no instances");
    return model;
  }

 private:
  /// Asyms of one entity that one row of generators places.
  struct Placing {
    std::vector<std::uint32_t> asyms;
    std::string expression;
  };
  struct Entity {
    std::string description, function, text, source;
    double mass = 0.0;
    std::vector<Placing> placings = {};
  };

  /// In the order of _entity; then those that only atoms name.
  void nameEntities() {
    mEntities.resize(mAtoms.entity.names.size());
    std::map<std::string, std::uint32_t> codes;
    for (std::size_t code = 0; code < mEntities.size(); ++code) codes[mAtoms.entity.names[code]] = std::uint32_t(code);
    std::set<std::uint32_t> named;
    const CifTable* table = mBlock.find("entity");
    for (std::size_t row = 0; table && row < table->rows; ++row) {
      auto at = codes.find(table->text("id", row));
      if (at == codes.end() || !named.insert(at->second).second) continue;
      mOrder.push_back(at->second);
      Entity& entity = mEntities[at->second];
      entity.description = table->text("pdbx_description", row);
      entity.function = table->text("details", row);
      entity.text = table->text("pdbx_parent_entity_id", row);
      entity.source = table->text("pdbx_fragment", row);
      double mass = table->number("formula_weight", row);
      if (mass > 0.0 && mass < 1e12) entity.mass = mass;
    }
    for (std::uint32_t code = 0; code < mEntities.size(); ++code)
      if (!named.count(code)) mOrder.push_back(code);
  }

  void gatherPlacings() {
    const CifTable* generators = mBlock.find("pdbx_struct_assembly_gen");
    if (!generators) refuse(mPath, "has types but no instances (_pdbx_struct_assembly_gen)");
    const CifColumn *asyms = generators->find("asym_id_list"), *expressions = generators->find("oper_expression");
    if (!asyms || !expressions) refuse(mPath, "its generators name no asyms, or no operators");
    for (std::size_t row = 0; row < generators->rows; ++row) {
      std::map<std::uint32_t, Placing> ofEntity;
      std::string list = asyms->text(row);
      for (std::string_view asym : itemsOf(list)) {
        auto at = mAsyms.find(asym);
        if (at == mAsyms.end()) continue;  // without atoms there is nothing to place
        const auto& rows = mAtoms.ofAsym[at->second];
        Placing& placing = ofEntity[mAtoms.entity.ofRow[rows.front()]];
        placing.asyms.push_back(at->second);
      }
      std::string expression = expressions->text(row);
      std::size_t poses = 0;
      mOperators.forEach(expression, [&](const Pose&) { ++poses; });
      if (poses == 0) continue;  // a range from high to low
      for (auto& [entity, placing] : ofEntity) {
        count(poses * placing.asyms.size());
        placing.expression = expression;
        mEntities[entity].placings.push_back(std::move(placing));
      }
    }
  }

  void addEntity(std::uint32_t code) {
    Entity& entity = mEntities[code];
    if (entity.placings.empty()) return;
    mProgress.throwIfCancelled();
    std::vector<std::string> parts = partsOf(entity.description);
    if (parts.empty()) parts = {"entity " + mAtoms.entity.names[code]};
    MoleculeType type{.name = parts.back()};
    parts.pop_back();
    if (!parts.empty() && parts.front() == "root") parts.erase(parts.begin());
    type.compartment = mBuilder.compartment(parts);
    type.function = entity.function;
    type.description = entity.text;
    type.structure = entity.source;
    if (entity.mass > 0.0) type.mass = entity.mass, type.massSource = MassSource::File;
    type.kind = kindOf(mAtoms, mAtoms.ofAsym[entity.placings.front().asyms.front()]);
    std::string lower = lowerCase(entity.description);
    if (lower.find("membrane") != std::string::npos && type.name.ends_with("membrane")) type.kind = MoleculeKind::Lipid;
    if (type.name == "DNA" || type.name == "RNA") type.kind = MoleculeKind::NucleicAcid;
    bool isApart = type.kind == MoleculeKind::Lipid || placesApart(entity);
    std::string name = type.name;
    bool isStrand = type.kind == MoleculeKind::NucleicAcid;
    std::uint32_t index = mBuilder.addType(std::move(type));
    if (isStrand && mAtoms.areBeads)
      placeBeads(entity, index);
    else
      isApart ? placeApart(entity, index) : placeTogether(entity, index, isStrand);
    if (mAtoms.areBeads && !isStrand) mDetailed.push_back({name, index, mMolecule});
  }

  /// Whether rows place different asyms of the entity.
  static bool placesApart(const Entity& entity) {
    return std::any_of(entity.placings.begin(), entity.placings.end(),
                       [&](const Placing& p) { return p.asyms != entity.placings.front().asyms; });
  }

  void placeApart(const Entity& entity, std::uint32_t type) {
    std::map<std::uint32_t, std::uint32_t> moleculeOf;
    for (const Placing& placing : entity.placings)
      for (std::uint32_t asym : placing.asyms) {
        if (!moleculeOf.count(asym)) moleculeOf[asym] = addMolecule(type, {asym});
        std::uint32_t molecule = moleculeOf[asym];
        mOperators.forEach(placing.expression, [&](const Pose& pose) { place(mBuilder, mPath, molecule, pose); });
      }
    mMolecule = moleculeOf.begin()->second;
  }

  /// A strand of beads is cut bead by bead, whatever the file makes one molecule: each bead is an instance.
  void placeBeads(const Entity& entity, std::uint32_t type) {
    std::vector<glm::vec3> points;
    for (const Placing& placing : entity.placings)
      mOperators.forEach(placing.expression, [&](const Pose& pose) {
        for (std::uint32_t asym : placing.asyms)
          for (std::uint32_t row : mAtoms.ofAsym[asym])
            points.push_back(pose.rotation * mAtoms.atoms[row].position + pose.position);
        if (points.size() > kMostInstances) refuse(mPath, fmt::format("names more than {} instances", kMostInstances));
      });
    float radius = 0.5f * medianStep(points);
    if (!(radius > 0.0f)) radius = kBeadRadius;
    std::uint32_t bead = mBuilder.addMolecule(type, {}, {{glm::vec4(0.0f, 0.0f, 0.0f, radius)}});
    MoleculeType& of = mBuilder.type(type);
    if (of.massSource == MassSource::File) of.mass /= double(points.size());  // the file's is of the whole strand
    forStrands(points, [&](std::size_t first, std::size_t end) {
      mBuilder.beginFibre();
      for (std::size_t i = first; i < end; ++i) place(mBuilder, mPath, bead, {{1.0f, 0.0f, 0.0f, 0.0f}, points[i]});
      mBuilder.addFibre(type, {points.begin() + std::ptrdiff_t(first), points.begin() + std::ptrdiff_t(end)});
    });
  }

  void placeTogether(const Entity& entity, std::uint32_t type, bool isStrand) {
    mMolecule = addMolecule(type, entity.placings.front().asyms);
    std::vector<Pose> poses;
    for (const Placing& placing : entity.placings)
      mOperators.forEach(placing.expression, [&](const Pose& pose) { poses.push_back(pose); });
    constexpr std::size_t kLeastStrand = 100;
    if (!isStrand || poses.size() < kLeastStrand) {
      for (const Pose& pose : poses) place(mBuilder, mPath, mMolecule, pose);
      return;
    }
    // Nucleotides follow their strand.
    std::vector<glm::vec3> points;
    for (const Pose& pose : poses) points.push_back(pose.position);
    forStrands(points, [&](std::size_t first, std::size_t end) {
      mBuilder.beginFibre();
      for (std::size_t i = first; i < end; ++i) place(mBuilder, mPath, mMolecule, poses[i]);
      mBuilder.addFibre(type, {points.begin() + std::ptrdiff_t(first), points.begin() + std::ptrdiff_t(end)});
    });
  }

  /// Before they are held: an expression of a few bytes may name millions.
  void count(std::size_t instances) {
    mCount += instances;
    if (mCount > kMostInstances) refuse(mPath, fmt::format("names more than {} instances", kMostInstances));
  }

  std::uint32_t addMolecule(std::uint32_t type, const std::vector<std::uint32_t>& asyms) {
    std::vector<Atom> atoms;
    std::map<std::uint32_t, std::uint16_t> chains;
    for (std::size_t chain = 0; chain < asyms.size(); ++chain)
      for (std::uint32_t row : mAtoms.ofAsym[asyms[chain]]) {
        atoms.push_back(mAtoms.atoms[row]);
        // Where all is one asym, the author's chains are within it.
        std::uint32_t own = asyms.size() > 1 ? std::uint32_t(chain) : mAtoms.authAsym.ofRow[row];
        atoms.back().chain = chains.try_emplace(own, std::uint16_t(chains.size())).first->second;
      }
    if (!mAtoms.areBeads) return mBuilder.addMolecule(type, std::move(atoms));
    std::vector<glm::vec4> beads;
    for (const Atom& atom : atoms) beads.emplace_back(atom.position, kBeadRadius);
    return mBuilder.addMolecule(type, {}, {std::move(beads)});
  }

  const CifBlock& mBlock;
  const Path& mPath;
  Progress& mProgress;
  CifAtoms mAtoms;
  ModelBuilder mBuilder;
  std::map<std::string, std::uint32_t, std::less<>> mAsyms;
  std::vector<Entity> mEntities;  ///< By the codes of atoms.
  std::vector<std::uint32_t> mOrder;
  Operators mOperators;
  std::vector<BeadMolecule> mDetailed;
  std::uint32_t mMolecule = 0;
  std::size_t mCount = 0;
};

}  // namespace

Model cellPackModel(const CifBlock& block, const Path& path, Progress& progress) {
  return CellPackReader(block, path, progress).read();
}

}  // namespace velum::io
