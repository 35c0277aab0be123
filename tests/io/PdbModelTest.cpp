#include "Damage.h"
#include "ModelFiles.h"
#include "PeakMemory.h"

namespace velum::io {
namespace {

Model readText(const std::string& text) {
  TempFolder folder;
  writeText(folder / "a.pdb", text);
  return readModelOf(folder / "a.pdb");
}

const std::string kCompound =
    "HEADER    VIRUS\n"
    "TITLE     A CAPSID\n"
    "COMPND    MOL_ID: 1;\n"
    "COMPND   2 MOLECULE: COAT PROTEIN;\n"
    "COMPND   3 CHAIN: A, B;\n";
const std::string kAssembly =
    "REMARK 350 BIOMOLECULE: 1\n"
    "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A\n"
    "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n"
    "REMARK 350   BIOMT1   2  0.000000 -1.000000  0.000000        5.00000\n"
    "REMARK 350   BIOMT2   2  1.000000  0.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT3   2  0.000000  0.000000  1.000000        0.00000\n"
    "REMARK 350 BIOMOLECULE: 2\n"
    "REMARK 350 APPLY THE FOLLOWING TO CHAINS: B\n"
    "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000       99.00000\n"
    "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n";

std::string twoAtoms(char chain, glm::vec3 p) {
  return pdbAtom("ATOM", " N", "ALA", chain, 1, p, "N") + pdbAtom("ATOM", " C", "ALA", chain, 1, p + 1.0f, "C");
}

TEST(PdbModel, TheFirstAssemblyIsBuilt) {
  Model model = readText(kCompound + kAssembly + twoAtoms('A', {10, 0, 0}) + twoAtoms('B', {50, 0, 0}));
  EXPECT_EQ(model.name, "A CAPSID");
  ASSERT_EQ(model.types.size(), 1u);
  EXPECT_EQ(model.types[0].name, "COAT PROTEIN");
  ASSERT_EQ(model.instances.size(), 2u) << "chain B is of the second assembly";
  glm::vec3 p = model.instances[1].position + model.instances[1].rotation * glm::vec3(10, 0, 0);
  EXPECT_NEAR(glm::length(p - glm::vec3(5, 10, 0)), 0.0f, 1e-4f);
}

TEST(PdbModel, ModelsInOnePlaceAreViewsOfOneThing) {
  std::string views, parts;
  for (int i = 0; i < 3; ++i) {
    views += fmt::format("MODEL {:8}\n", i + 1) + twoAtoms('A', {0, 0, 0.1f * float(i)}) + "ENDMDL\n";
    parts += fmt::format("MODEL {:8}\n", i + 1) + twoAtoms('A', {0, 0, 30.0f * float(i)}) + "ENDMDL\n";
  }
  Model one = readText(views), all = readText(parts);
  EXPECT_EQ(one.instances.size(), 1u);
  EXPECT_EQ(one.warnings.size(), 1u);
  EXPECT_EQ(all.instances.size(), 3u);
  EXPECT_TRUE(all.warnings.empty());
}

TEST(PdbModel, LigandsAreTypesAndWaterIsNone) {
  Model model = readText(twoAtoms('A', glm::vec3(0)) + pdbAtom("HETATM", "FE", "HEM", 'A', 5, {3, 0, 0}, "FE") +
                         pdbAtom("HETATM", "FE", "HEM", 'A', 6, {9, 0, 0}, "FE") +
                         pdbAtom("HETATM", " O", "HOH", 'A', 7, {9, 9, 0}, "O"));
  ASSERT_EQ(model.types.size(), 2u);
  EXPECT_EQ(model.types[1].name, "HEM");
  EXPECT_EQ(model.types[1].instanceCount, 2u);
  EXPECT_EQ(model.molecules[1].atoms[0].element, 26);
}

TEST(PdbModel, CAlphaAtomsStandForTheirResidues) {
  std::string text =
      pdbAtom("ATOM", " CA", "ALA", 'A', 1, {0, 0, 0}, "C") + pdbAtom("ATOM", " CA", "GLY", 'A', 2, {3.8f, 0, 0}, "C");
  Model model = readText(text);
  for (const Atom& atom : model.molecules[0].atoms) EXPECT_EQ(atom.element, kResidue);
  EXPECT_EQ(model.types[0].mass, 220.0);
  EXPECT_EQ(readText(text + pdbAtom("ATOM", " N", "GLY", 'A', 2, {4, 0, 0}, "N")).molecules[0].atoms[0].element, 6);
}

TEST(PdbModel, DamageIsReadOrRefused) {
  TempFolder folder;
  std::string good = kCompound + kAssembly + twoAtoms('A', {10, 0, 0}) + twoAtoms('B', {50, 0, 0});
  auto growth =
      peakGrowth([&] { expectReadOrRefused(good, folder / "a.pdb", 1000, [&] { readModelOf(folder / "a.pdb"); }); });
  EXPECT_LT(growth, std::size_t(64) << 20);
}

TEST(PdbModel, AtomsWithoutPlacesAreRefused) {
  TempFolder folder;
  for (const char* place : {"     nan", "     inf", "        ", "   1e300", "   1.2.3"}) {
    std::string text = twoAtoms('A', {10, 0, 0});
    text.replace(30, 8, place);
    writeText(folder / "a.pdb", text);
    expectClearRefusal(folder / "a.pdb");
  }
}

}  // namespace
}  // namespace velum::io
