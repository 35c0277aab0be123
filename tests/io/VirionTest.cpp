#include "io/phantoms/Virion.h"

#include <set>
#include <unordered_map>

#include "GemmiAssembly.h"
#include "ModelFiles.h"
#include "io/models/Strands.h"
#include "io/models/WriteModel.h"

namespace velum::io {
namespace {

const Model& virion() {
  static const Model model = [] {
    Progress progress;
    return makeVirion(progress);
  }();
  return model;
}

bool isProtein(const Model& model, const Instance& instance) {
  return model.types[model.molecules[instance.molecule].type].kind == MoleculeKind::Protein;
}

TEST(Virion, HasAllThatAVirusInPlasmaHas) {
  const Model& model = virion();
  EXPECT_GE(model.types.size(), 20u);
  std::size_t lipids = 0, nucleotides = 0;
  std::set<std::string> functions;
  for (const MoleculeType& type : model.types) {
    if (type.kind == MoleculeKind::Lipid) lipids += type.instanceCount;
    if (type.kind == MoleculeKind::NucleicAcid) nucleotides += type.instanceCount;
    EXPECT_FALSE(type.function.empty()) << type.name;
    EXPECT_GT(type.instanceCount, 0u) << type.name;
    functions.insert(type.function);
  }
  EXPECT_GE(model.instances.size() - lipids, 20000u);
  EXPECT_GE(lipids, 80000u);
  EXPECT_GE(nucleotides, 5000u);
  EXPECT_GE(functions.size(), 15u);
  for (const char* end :
       {"surface.spike", "surface.matrix", "capsid.surface.capsid_monomer", "interior.RNA", "plasma.albumin"})
    typeOf(model, end);
}

TEST(Virion, EveryPartIsWhereItBelongs) {
  const Model& model = virion();
  auto expectBetween = [&](const char* end, float from, float to) {
    for (const Instance& instance : instancesOf(model, typeOf(model, end))) {
      float radius = glm::length(middleOf(model, instance));
      ASSERT_GE(radius, from) << end;
      ASSERT_LE(radius, to) << end;
    }
  };
  expectBetween("surface.spike", 520, 660);
  expectBetween("surface.matrix", 430, 480);
  expectBetween("capsid_monomer", 255, 275);
  expectBetween("interior.RNA", 0, 245);
  expectBetween("nucleocapsid", 0, 240);
  expectBetween("interior.p6", 290, 460);
  expectBetween("plasma.albumin", 540, 1560);
  expectBetween("outer_membrane", 500, 520);
  expectBetween("inner_membrane", 480, 500);
}

TEST(Virion, NoTwoProteinsOverlap) {
  const Model& model = virion();
  // Pairs whose spheres touch, found by cells as large as the largest of the usual ones; the few larger are tried
  // against all.
  constexpr float kCell = 200.0f;
  std::unordered_map<std::int64_t, std::vector<std::uint32_t>> cells;
  auto cellOf = [](glm::vec3 p) { return glm::ivec3(glm::floor(p / kCell)); };
  auto keyOf = [](glm::ivec3 c) { return (std::int64_t(c.x + 500) * 1000 + c.y + 500) * 1000 + c.z + 500; };
  auto centreOf = [&](std::uint32_t i) {
    return model.instances[i].position +
           model.instances[i].rotation * model.molecules[model.instances[i].molecule].centre;
  };
  auto radiusOfInstance = [&](std::uint32_t i) { return model.molecules[model.instances[i].molecule].radius; };
  std::size_t pairs = 0;
  float least = 1e9f;
  auto compare = [&](std::uint32_t a, std::uint32_t b) {
    if (glm::length(centreOf(a) - centreOf(b)) > radiusOfInstance(a) + radiusOfInstance(b)) return;
    ++pairs;
    const Instance &one = model.instances[a], &other = model.instances[b];
    const auto& theirs = model.molecules[other.molecule].atoms;
    glm::quat back = glm::conjugate(one.rotation);
    // Atoms of the other that come within the first's sphere, in its frame. Every 23rd: overlaps of lobes would be of
    // hundreds of atoms.
    std::vector<glm::vec3> near;
    for (std::size_t i = 0; i < theirs.size(); i += 23) {
      glm::vec3 p = back * (other.position + other.rotation * theirs[i].position - one.position);
      if (glm::length(p - model.molecules[one.molecule].centre) < model.molecules[one.molecule].radius)
        near.push_back(p);
    }
    if (near.empty()) return;
    const auto& ours = model.molecules[one.molecule].atoms;
    for (std::size_t i = 0; i < ours.size(); i += 7)
      for (glm::vec3 p : near) least = std::min(least, glm::length(p - ours[i].position));
  };
  std::vector<std::uint32_t> large;
  for (std::uint32_t i = 0; i < model.instances.size(); ++i) {
    if (!isProtein(model, model.instances[i])) continue;
    for (std::uint32_t other : large) compare(i, other);
    if (radiusOfInstance(i) > 0.5f * kCell) {
      for (const auto& [key, members] : cells)
        for (std::uint32_t other : members) compare(i, other);
      large.push_back(i);
      continue;
    }
    glm::ivec3 cell = cellOf(centreOf(i));
    for (int n = 0; n < 27; ++n)
      if (auto at = cells.find(keyOf(cell + glm::ivec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1))); at != cells.end())
        for (std::uint32_t other : at->second) compare(i, other);
    cells[keyOf(cell)].push_back(i);
  }
  EXPECT_GT(pairs, 10000u) << "spheres around them do touch";
  // Twice what atoms stay within their lobes.
  EXPECT_GT(least, 3.39f);
}

TEST(Virion, IsTheSameEveryTime) {
  Progress progress;
  Model again = makeVirion(progress);
  EXPECT_EQ(again.instances, virion().instances);
  EXPECT_EQ(again.molecules[0].atoms, virion().molecules[0].atoms);
}

TEST(Virion, WhatIsWrittenIsReadBack) {
  TempFolder folder;
  Progress progress;
  writeModel(virion(), folder / "v.cif.gz", progress);
  Model back = readModelOf(folder / "v.cif.gz");
  ASSERT_EQ(back.types.size(), virion().types.size());
  ASSERT_EQ(back.instances.size(), virion().instances.size());
  for (const MoleculeType& type : virion().types) {
    const MoleculeType& same = typeOf(back, pathOf(virion(), type));
    EXPECT_EQ(same.instanceCount, type.instanceCount);
    EXPECT_EQ(same.kind, type.kind);
    EXPECT_EQ(same.function, type.function);
    EXPECT_NEAR(same.mass, type.mass, 0.06);
    EXPECT_EQ(atomCount(back, same), atomCount(virion(), type));
    // 0.3 is what five digits of a rotation leave at 200 angstrom.
    for (std::uint32_t i = 0; i < type.instanceCount; i += 97) {
      const Instance &a = virion().instances[type.firstInstance + i], &b = back.instances[same.firstInstance + i];
      ASSERT_LT(glm::length(a.position - b.position), 0.01f) << type.name;
      ASSERT_LT(glm::length(a.rotation * glm::vec3(0, 0, 200) - b.rotation * glm::vec3(0, 0, 200)), 0.3f) << type.name;
    }
  }
  const auto& spike = back.molecules[typeOf(back, ".spike").firstMolecule].atoms;
  EXPECT_TRUE(std::any_of(spike.begin(), spike.end(), [](const Atom& a) { return a.chain >= 6; })) << "chains too";
  EXPECT_EQ(back.fibres.size(), 1u) << "the strand is known again by its steps";
}

TEST(Strands, NucleotidesTurnToTheRightAboutTheirStrand) {
  std::vector<glm::vec3> bow;
  for (int i = 0; i <= 60; ++i) bow.push_back(300.0f * glm::vec3(std::cos(0.05f * i), std::sin(0.05f * i), 0.0f));
  for (const auto& points : {std::vector<glm::vec3>{{0, 0, 0}, {0, 0, 90}, {0, 0, 200}},
                             std::vector<glm::vec3>{{5, 8, 1}, {-40, 30, -100}}, bow}) {
    std::vector<Pose> poses;
    walkAlong(points, kNucleotide, [&](const Pose& pose) { poses.push_back(pose); });
    ASSERT_GT(poses.size(), 30u);
    for (std::size_t i = 1; i < poses.size(); ++i) {
      auto axis = [&](std::size_t of, glm::vec3 own) { return poses[of].rotation * own; };
      glm::vec3 z = axis(i, {0, 0, 1}), before = axis(i - 1, {1, 0, 0}), after = axis(i, {1, 0, 0});
      EXPECT_GT(glm::dot(z, glm::normalize(poses[i].position - poses[i - 1].position)), 0.999f);
      EXPECT_NEAR(std::atan2(glm::dot(glm::cross(before, after), z), glm::dot(before, after)), 0.59865f, 2e-3f) << i;
      EXPECT_NEAR(glm::length(poses[i].position - poses[i - 1].position), 34.0f / 12.0f, 2e-3f) << i;
    }
  }
}

TEST(Virion, GemmiReadsItsAssembly) {
  // Five instances of each molecule: gemmi looks for every operator through all of them.
  Model few = virion();
  few.instances.clear();
  for (Molecule& molecule : few.molecules) {
    std::uint32_t first = molecule.firstInstance, count = std::min(molecule.instanceCount, 5u);
    molecule.firstInstance = std::uint32_t(few.instances.size());
    molecule.instanceCount = count;
    for (std::uint32_t i = 0; i < count; ++i) few.instances.push_back(virion().instances[first + i]);
  }
  TempFolder folder;
  Progress progress;
  writeModel(few, folder / "v.cif", progress);
  std::string text = bytesOf(folder / "v.cif");
  GemmiAssembly assembly = readByGemmi(text);
  EXPECT_EQ(assembly.block, "CELLPACK_MODEL") << "by which Mol* knows the flavour";
  EXPECT_EQ(assembly.count, 1u);
  ASSERT_EQ(assembly.operators.size(), few.instances.size());
  for (std::size_t i = 0; i < few.instances.size(); ++i) {
    const Instance& instance = few.instances[i];
    const GemmiOperator& read = assembly.operators[i];
    glm::vec3 own = instance.rotation * glm::vec3(0, 0, 1);
    ASSERT_EQ(read.subchains, 1u);
    ASSERT_LT(glm::length(instance.position - glm::vec3(read.shift[0], read.shift[1], read.shift[2])), 0.01f);
    ASSERT_LT(glm::length(own - glm::vec3(read.turnedZ[0], read.turnedZ[1], read.turnedZ[2])), 1e-4f);
  }
  std::size_t atoms = 0;
  for (const Molecule& molecule : few.molecules) atoms += molecule.atoms.size();
  EXPECT_EQ(assembly.atoms, atoms);
}

}  // namespace
}  // namespace velum::io
