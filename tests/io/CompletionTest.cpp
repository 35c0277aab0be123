#include "ModelFiles.h"
#include "io/models/Envelope.h"

namespace velum::io {
namespace {

/// On a sphere or on an egg.
std::string onShell(int count, glm::vec3 radii) {
  std::string results;
  for (int i = 0; i < count; ++i) {
    glm::vec3 p = radii * spiralPoint(std::size_t(i), std::size_t(count));
    results += fmt::format("{}[[{},{},{}],[1,0,0,0]]", i ? "," : "", p.x, p.y, p.z);
  }
  return results;
}

std::string virus(glm::vec3 envelope) {
  constexpr const char* kSource = R"("source": {"pdb": "p", "transform": {"center": true}})";
  return fmt::format(
      R"({{"recipe": {{}}, "compartments": {{"envelope_1": {{"surface": {{"ingredients": {{"S": {{{0}, "results": [{1}]}}}}}}}},
          "capsid_1": {{"surface": {{"ingredients": {{"CA": {{{0}, "results": [{2}]}}}}}}}}}}}})",
      kSource, onShell(80, envelope), onShell(400, {150, 150, 220}));
}

Model complete(const std::string& text) {
  TempFolder folder;
  std::filesystem::create_directories(folder / "in");
  std::string ball;
  for (int i = 0; i < 400; ++i)
    ball += pdbAtom("ATOM", i % 2 ? " N" : " C", "ALA", 'A', i, 12.0f * spiralPoint(std::size_t(i), 400),
                    i % 2 ? "N" : "C");
  writeText(folder / "in/p.pdb", ball);
  writeText(folder / "in/a.cpr", text);
  return readModelOf(folder / "in/a.cpr", true);
}

TEST(Completion, AnEnvelopeGetsLipidsButUnderProteinsAndACapsidItsStrand) {
  Model model = complete(virus(glm::vec3(300)));
  EXPECT_EQ(model.added.size(), 2u);
  EXPECT_EQ(countsOf(model).instances, 480u);
  const MoleculeType& outer = typeOf(model, ".membrane.outer_membrane");
  // A lipid has 62 square angstrom of the sphere of heads; balls of 12 to 20 angstrom are kept free of them.
  double whole = 4 * 3.14159 * 318 * 318 / 62, ofProteins = 80 * 3.14159 / 62;
  EXPECT_LT(outer.instanceCount, whole - ofProteins * 12 * 12 * 0.8);
  EXPECT_GT(outer.instanceCount, whole - ofProteins * 20 * 20);
  for (const Instance& lipid : instancesOf(model, outer)) {
    // Heads outwards; the middle of so few proteins is found to some angstrom.
    EXPECT_GT(glm::length(lipid.position + lipid.rotation * glm::vec3(0, 0, 20)), 317.0f);
    for (const Instance& protein : instancesOf(model, typeOf(model, "surface.S")))
      ASSERT_GT(glm::length(lipid.position * (310.0f / 300.0f) - protein.position), 10.0f);
  }
  const MoleculeType& strand = typeOf(model, ".interior.RNA");
  EXPECT_EQ(strand.origin, Origin::Added);
  EXPECT_GT(strand.instanceCount, 10000u);
  for (const Instance& nucleotide : instancesOf(model, strand))
    ASSERT_LT(glm::length(nucleotide.position / glm::vec3(150, 150, 220)), 0.95f);
}

TEST(Completion, WhatIsNoSphereGetsNoLipids) {
  Model model = complete(virus({300, 300, 360}));
  EXPECT_TRUE(model.added.empty());
  EXPECT_EQ(model.types.size(), 2u);
}

TEST(Completion, ReadingCanDoWithoutIt) {
  TempFolder folder;
  writeText(folder / "a.cpr", virus(glm::vec3(300)));
  EXPECT_EQ(readModelOf(folder / "a.cpr", false).types.size(), 2u);
}

}  // namespace
}  // namespace velum::io
