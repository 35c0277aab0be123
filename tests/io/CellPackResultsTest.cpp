#include <cmath>

#include "Damage.h"
#include "ModelFiles.h"
#include "PeakMemory.h"

namespace velum::io {
namespace {

constexpr char kProtein[] =
    "ATOM      1  N   ALA A   1      10.000   0.000   0.000  1.00  0.00           N  \r\n"
    "ATOM      2  CA  ALA A   1      14.000   0.000   0.000  1.00  0.00           C  \r\n"
    "ENDMDL\r\n"
    "ATOM      3  N   ALA A   1      90.000   0.000   0.000  1.00  0.00           N  \r\n";

std::string recipe(const std::string& surface, const std::string& interior = "") {
  return R"({"recipe": {"name": "x"}, "cytoplasme": {"ingredients": {}}, "compartments": {"C": {"surface": {"ingredients": {)" +
         surface + R"(}}, "interior": {"ingredients": {)" + interior + "}}}}}";
}

std::string ingredient(const std::string& name, const std::string& results, bool isCentred,
                       const std::string& pdb = "p") {
  return fmt::format(
      R"("{0}": {{"name": "{0}", "source": {{"pdb": "{3}", "transform": {{"center": {2}}}}}, "results": [{1}]}})", name,
      results, isCentred ? "true" : "false", pdb);
}

/// On a sphere, with their own x axis outwards; quaternions w, x, y, z.
std::string onSphere(bool isInverse) {
  std::string results;
  for (int i = 0; i < 40; ++i) {
    float z = -0.95f + 1.9f * float(i) / 39.0f, turn = 2.4f * float(i), r = std::sqrt(1.0f - z * z);
    glm::vec3 outward(r * std::cos(turn), r * std::sin(turn), z);
    glm::vec3 across = glm::normalize(glm::cross(glm::vec3(0.3f, 0.5f, 0.8f), outward));
    glm::quat q = glm::quat_cast(glm::mat3(outward, across, glm::cross(outward, across)));
    if (isInverse) q = glm::conjugate(q);
    glm::vec3 p = 100.0f * outward;
    results += fmt::format("{}[[{},{},{}],[{},{},{},{}]]", i ? "," : "", p.x, p.y, p.z, q.w, q.x, q.y, q.z);
  }
  return results;
}

TEST(CellPackResults, APoseIsARotationThenAPlace) {
  TempFolder folder;
  writeText(folder / "p.pdb", kProtein);
  // A quarter turn about z: x becomes y.
  writeText(folder / "a.cpr", recipe("", ingredient("I", "[[1,2,3],[0.70710678,0,0,0.70710678]]", false)));
  Model model = readModelOf(folder / "a.cpr");
  ASSERT_EQ(model.instances.size(), 1u);
  ASSERT_EQ(model.molecules[0].atoms.size(), 2u) << "the first model, with any line ends";
  EXPECT_EQ(model.molecules[0].atoms[0].element, 7);
  glm::vec3 n = model.instances[0].position + model.instances[0].rotation * model.molecules[0].atoms[0].position;
  EXPECT_NEAR(glm::length(n - glm::vec3(1, 12, 3)), 0.0f, 1e-4f);
  EXPECT_EQ(pathOf(model, model.types[0]), "root.C.interior.I");
}

TEST(CellPackResults, CentredMoleculesStandWithTheirMiddleOnTheirPlace) {
  TempFolder folder;
  writeText(folder / "p.pdb", kProtein);
  writeText(folder / "a.cpr", recipe("", ingredient("I", "[[1,2,3],[1,0,0,0]]", true)));
  Model model = readModelOf(folder / "a.cpr");
  EXPECT_NEAR(glm::length(middleOf(model, model.instances[0]) - glm::vec3(1, 2, 3)), 0.0f, 1e-4f);
}

TEST(CellPackResults, TheSurfaceTellsWhichWayRotationsGo) {
  TempFolder folder;
  writeText(folder / "p.pdb", kProtein);
  for (bool isInverse : {false, true}) {
    writeText(folder / "a.cpr", recipe(ingredient("S", onSphere(isInverse), false)));
    Model model = readModelOf(folder / "a.cpr");
    ASSERT_EQ(model.instances.size(), 40u);
    for (const Instance& instance : model.instances)
      EXPECT_NEAR(glm::length(middleOf(model, instance)), 112.0f, 0.01f) << isInverse;
    EXPECT_EQ(model.warnings.size(), isInverse ? 1u : 0u);
  }
}

TEST(CellPackResults, CurvesBecomeStrandsOfEqualSteps) {
  TempFolder folder;
  writeText(folder / "a.cpr",
            recipe("", R"("peptides": {"name": "peptides", "source": {"pdb": null}, "results": [], "nbCurve": 2,
                   "curve0": [[0,0,0],[0,0,30],[0,0,60]], "curve1": [[5,5,5],[5,5,8]]})"));
  Model model = readModelOf(folder / "a.cpr");
  ASSERT_EQ(model.fibres.size(), 2u);
  EXPECT_EQ(model.fibres[0].points.size(), 3u);
  ASSERT_EQ(model.fibres[0].instanceCount, 20u) << "balls of 3 angstrom, a radius apart, on 60";
  for (std::uint32_t i = 0; i < 20; ++i) {
    EXPECT_NEAR(model.instances[i].position.z, 3.0f * float(i), 1e-3f);
    EXPECT_NEAR(glm::length(model.instances[i].rotation * glm::vec3(0, 0, 1) - glm::vec3(0, 0, 1)), 0.0f, 1e-3f);
  }
  EXPECT_EQ(countsOf(model).instances, 0u) << "the file has curves, not instances";
}

TEST(CellPackResults, WhatHasNoStructureIsABallAndSaidToBe) {
  TempFolder folder;
  writeText(folder / "a.cpr", recipe("", ingredient("I", "[[0,0,0],[1,0,0,0]],[[50,0,0],[1,0,0,0]]", true, "1abc")));
  Model model = readModelOf(folder / "a.cpr");
  ASSERT_EQ(model.molecules[0].beads.size(), 1u);
  EXPECT_FLOAT_EQ(model.molecules[0].radius, 25.0f) << "half the distance of the two";
  ASSERT_EQ(model.added.size(), 1u);
  EXPECT_NE(model.added[0].find("I"), std::string::npos);
}

TEST(CellPackResults, NoFileOutsideIsOpened) {
  TempFolder folder;
  std::filesystem::create_directories(folder / "in");
  writeText(folder / "secret.pdb", kProtein);
  for (const char* name : {"../secret.pdb", "../secret", "..\\\\secret", "/etc/passwd"}) {
    writeText(folder / "in/a.cpr", recipe("", ingredient("I", "[[0,0,0],[1,0,0,0]]", true, name)));
    EXPECT_TRUE(readModelOf(folder / "in/a.cpr").molecules[0].atoms.empty()) << name;
  }
}

TEST(CellPackResults, DamageIsReadOrRefused) {
  TempFolder folder;
  writeText(folder / "p.pdb", kProtein);
  std::string good = recipe(ingredient("S", onSphere(false), true), ingredient("I", "[[1,2,3],[1,0,0,0]]", false));
  auto growth =
      peakGrowth([&] { expectReadOrRefused(good, folder / "a.cpr", 500, [&] { readModelOf(folder / "a.cpr"); }); });
  EXPECT_LT(growth, std::size_t(64) << 20);
}

TEST(CellPackResults, NonsenseIsRefusedInOneLine) {
  TempFolder folder;
  writeText(folder / "p.pdb", kProtein);
  std::string deep(200000, '[');
  for (const std::string& results :
       {std::string("[[1,2],[1,0,0,0]]"), std::string("[[1,2,1e300],[1,0,0,0]]"), std::string("[[1,2,3],[1,0,0]]"),
        std::string("[[1,2,\"x\"],[1,0,0,0]]"), std::string("[[1,2,3]]"), std::string("7"), std::string(""),
        std::string("[[1,2,3],[[0,0,0],[0,0,0],[0,0,0]]]"), "[" + deep}) {
    writeText(folder / "a.cpr", recipe("", ingredient("I", results, false)));
    expectClearRefusal(folder / "a.cpr");
  }
  writeText(folder / "a.cpr", recipe("", R"("f": {"results": [], "nbCurve": 9e18, "curve0": [[0,0,0],[1,1,1]]})"));
  expectClearRefusal(folder / "a.cpr");
  writeText(folder / "a.cpr", recipe("", R"("f": {"results": [], "nbCurve": 1, "curve0": [[0,0,0],[9e8,9e8,1]]})"));
  expectClearRefusal(folder / "a.cpr");
}

}  // namespace
}  // namespace velum::io
