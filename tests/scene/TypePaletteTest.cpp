// Colours of types: what stands back, what stands out, what looks alike.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "ColorVision.h"
#include "makeModel.h"
#include "scene/ModelLayer.h"

namespace velum {
namespace {

/// Colour in Oklab: lightness, and how far it is from grey.
glm::dvec2 lightnessAndChroma(glm::vec3 srgb) {
  glm::dvec3 lab = oklabOf(srgb);
  return {lab.x, glm::length(glm::dvec2(lab.y, lab.z))};
}

double hueDeg(glm::vec3 srgb) {
  glm::dvec3 lab = oklabOf(srgb);
  return glm::degrees(std::atan2(lab.z, lab.y));
}

std::vector<glm::vec3> colorsOf(Model model, scene::Palette palette = scene::Palette::Type) {
  scene::ModelLayer layer;
  layer.data = Shared<Model>(std::move(model));
  layer.palette = palette;
  return scene::typeColors(layer);
}

/// Types as lists of compartments, name and what they do; one instance each.
class TypesMaker {
 public:
  void add(std::vector<std::string> path, MoleculeType type) {
    type.compartment = mBuilder.compartment(path);
    std::uint32_t molecule = mBuilder.addMolecule(mBuilder.addType(type), randomAtoms(20, 10.0f, 5));
    mBuilder.addInstance(molecule, glm::vec3(30.0f * float(mCount++)), glm::quat(1, 0, 0, 0));
  }
  Model make() { return mBuilder.build(); }

 private:
  ModelBuilder mBuilder{"types"};
  int mCount = 0;
};

/// Bodies within each other, each with types on its surface and inside; in the innermost a genome, about the outermost
/// a membrane and a medium. The first types of all: medium, lipid, genome.
Model bodiesInBodies(int bodies, int typesOnEachSide, const std::vector<std::string>& functions = {}) {
  TypesMaker maker;
  maker.add({"plasma"}, {.name = "albumin"});
  maker.add({"body0", "membrane"}, {.name = "phospholipid", .kind = MoleculeKind::Lipid});
  std::vector<std::string> path;
  for (int body = 0; body < bodies; ++body) {
    path.push_back("body" + std::to_string(body));
    for (const char* side : {"surface", "interior"})
      for (int t = 0; t < typesOnEachSide; ++t) {
        std::vector<std::string> at = path;
        at.insert(at.end(), {side, "proteins"});
        std::string name = side + std::to_string(t);
        maker.add(at,
                  {.name = name, .function = functions.empty() ? "" : functions[std::size_t(t) % functions.size()]});
      }
  }
  path.push_back("interior");
  maker.add(path, {.name = "genome", .kind = MoleculeKind::NucleicAcid});
  return maker.make();
}

/// A virus with an envelope, a capsid and what these hold, in plasma of many types.
Model virusInPlasma() {
  ModelBuilder builder("virus");
  auto add = [&](std::vector<std::string> path, const char* name, int count, const char* function = "") {
    MoleculeType type;
    type.name = name;
    type.function = function;
    type.compartment = builder.compartment(path);
    std::uint32_t molecule = builder.addMolecule(builder.addType(type), randomAtoms(40, 10.0f, 5));
    for (int i = 0; i < count; ++i) builder.addInstance(molecule, glm::vec3(30.0f * float(i)), glm::quat(1, 0, 0, 0));
  };
  for (const char* name : {"albumin", "IgG", "LDL", "fibrinogen", "transferrin", "IgA"}) add({"plasma"}, name, 300);
  add({"virus", "surface"}, "matrix", 50);
  add({"virus", "capsid", "surface"}, "CA", 40);
  add({"virus", "interior"}, "p6", 30, "budding");
  add({"virus", "interior"}, "vpr", 20, "budding");
  add({"virus", "interior"}, "protease", 10, "cutting");
  add({"virus", "capsid", "interior", "proteins"}, "NC", 5);
  return builder.build();
}

TEST(TypePalette, TheFirstColourIsOfWhatThereIsMostOfNotOfTheLargestMolecule) {
  auto colorsOf = [](int few, int many) {
    ModelBuilder builder("two");
    for (int t : {0, 1}) {
      MoleculeType type;
      type.name = t == 0 ? "large" : "small";
      type.compartment = builder.compartment(std::vector<std::string>{type.name});
      std::uint32_t molecule = builder.addMolecule(builder.addType(type), randomAtoms(t == 0 ? 200 : 40, 10.0f, 5));
      for (int i = 0; i < (t == 0 ? few : many); ++i)
        builder.addInstance(molecule, glm::vec3(30.0f * float(i)), glm::quat(1, 0, 0, 0));
    }
    scene::ModelLayer layer;
    layer.data = Shared<Model>(builder.build());
    return scene::typeColors(layer);
  };
  // 200 atoms three times are more than 40 once, and less than 40 a hundred times.
  std::vector<glm::vec3> largeFirst = colorsOf(3, 1), smallFirst = colorsOf(3, 100);
  EXPECT_NE(largeFirst[0], largeFirst[1]);
  EXPECT_EQ(smallFirst[1], largeFirst[0]);
}

TEST(TypePalette, WhatAllElseSwimsInStandsBackInManyHues) {
  scene::ModelLayer layer;
  layer.data = Shared<Model>(virusInPlasma());
  std::vector<glm::vec3> colors = scene::typeColors(layer);
  double darkestOut = 1.0, dullestIn = 1.0, mostOut = 0.0, lightestIn = 0.0, nearest = 1.0;
  for (std::size_t t = 0; t < colors.size(); ++t) {
    glm::dvec2 seen = lightnessAndChroma(colors[t]);
    if (t < 6) {
      darkestOut = std::min(darkestOut, seen.x);
      mostOut = std::max(mostOut, seen.y);
      for (std::size_t other = 0; other < t; ++other)
        nearest = std::min(nearest, double(glm::length(colors[t] - colors[other])));
    } else {
      lightestIn = std::max(lightestIn, seen.x);
      dullestIn = std::min(dullestIn, seen.y);
    }
  }
  EXPECT_GT(darkestOut, 0.74);
  EXPECT_LT(mostOut, 0.085);
  EXPECT_GT(nearest, 0.03) << "eight grey levels, of types that take up most of the picture";
  EXPECT_LT(lightestIn, 0.82);
  EXPECT_GT(dullestIn, 0.06);
}

TEST(TypePalette, SurfacesAndFunctionsAreFamilies) {
  scene::ModelLayer layer;
  layer.data = Shared<Model>(virusInPlasma());
  std::vector<glm::vec3> colors = scene::typeColors(layer);
  auto apart = [&](std::size_t a, std::size_t b) { return double(glm::length(colors[a] - colors[b])); };
  constexpr std::size_t kMatrix = 6, kCapsid = 7, kP6 = 8, kVpr = 9, kProtease = 10, kNc = 11;
  EXPECT_LT(apart(kP6, kVpr), 0.5 * apart(kP6, kProtease)) << "what does the same looks alike";
  for (std::size_t a : {kMatrix, kCapsid, kP6, kNc})
    for (std::size_t b : {kMatrix, kCapsid, kP6, kNc}) {
      if (a == b) continue;
      EXPECT_GT(apart(a, b), 0.12) << a << " " << b;
    }
}

TEST(TypePalette, OneCompartmentAloneTakesAllFamilies) {
  scene::ModelLayer layer;
  ModelBuilder builder("flat");
  for (int t = 0; t < 8; ++t) {
    MoleculeType type;
    type.name = "m" + std::to_string(t);
    std::uint32_t molecule = builder.addMolecule(builder.addType(type), randomAtoms(40, 10.0f, 5));
    builder.addInstance(molecule, glm::vec3(30.0f * float(t)), glm::quat(1, 0, 0, 0));
  }
  layer.data = Shared<Model>(builder.build());
  std::vector<glm::vec3> colors = scene::typeColors(layer);
  for (std::size_t a = 0; a < colors.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) EXPECT_GT(double(glm::length(colors[a] - colors[b])), 0.1) << a << " " << b;
}

TEST(TypePalette, FamiliesAreToldApartByEyesThatLackConesOfAKind) {
  double least = 1e9;
  for (int bodies : {1, 2, 3, 4}) {
    std::vector<glm::vec3> colors = colorsOf(bodiesInBodies(bodies, 1), scene::Palette::Compartment);
    for (std::size_t a = 0; a < colors.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) {
        double apart = leastApart(colors[a], colors[b]);
        EXPECT_GT(apart, 0.07) << bodies << " bodies, types " << b << " and " << a;
        least = std::min(least, apart);
      }
  }
  RecordProperty("leastApart", std::to_string(least));
}

TEST(TypePalette, ASurfaceIsToldFromWhatIsInsideByAllItsTypesForSuchEyes) {
  for (int bodies : {1, 2, 3}) {
    constexpr int kTypes = 6;
    Model model = bodiesInBodies(bodies, kTypes);
    std::vector<glm::vec3> colors = colorsOf(model);
    for (int body = 0; body < bodies; ++body)
      for (int out = 0; out < kTypes; ++out)
        for (int in = 0; in < kTypes; ++in) {
          auto first = std::size_t(2 + 2 * body * kTypes);
          EXPECT_GT(leastApart(colors[first + std::size_t(out)], colors[first + std::size_t(kTypes + in)]), 0.03)
              << bodies << " bodies: " << body << ", " << out << ", " << in;
        }
    for (std::size_t t = 2; t + 1 < colors.size(); ++t)
      EXPECT_GT(leastApart(colors[t], colors.back()), 0.05) << "a genome is told from all proteins: " << t;
  }
}

TEST(TypePalette, FiveHundredTypesAreFewCalmHues) {
  std::vector<std::string> functions;
  for (int i = 0; i < 12; ++i) functions.push_back("function" + std::to_string(i));
  constexpr std::size_t kTypes = 250;
  std::vector<glm::vec3> colors = colorsOf(bodiesInBodies(1, kTypes, functions));
  for (std::size_t first : {std::size_t(2), 2 + kTypes}) {
    double low = 1e9, high = -1e9, palest = 1.0, strongest = 0.0;
    std::set<std::tuple<float, float, float>> all;
    for (std::size_t t = first; t < first + kTypes; ++t) {
      double hue = hueDeg(colors[t]);
      if (hue < -30.0) hue += 360.0;
      low = std::min(low, hue), high = std::max(high, hue);
      double chroma = lightnessAndChroma(colors[t]).y;
      palest = std::min(palest, chroma), strongest = std::max(strongest, chroma);
      all.insert({colors[t].x, colors[t].y, colors[t].z});
    }
    EXPECT_LT(high - low, 90.0) << "a side is one family of hues";
    EXPECT_LT(strongest, 0.15);
    EXPECT_GT(palest, 0.05);
    EXPECT_GT(all.size(), kTypes / 2) << "in which types differ by steps";
  }
}

TEST(TypePalette, LipidsAreCreamAndGenomesYellowInEachPalette) {
  for (auto palette : {scene::Palette::Type, scene::Palette::Compartment, scene::Palette::Function}) {
    std::vector<glm::vec3> colors = colorsOf(bodiesInBodies(2, 3), palette);
    glm::vec3 lipid = colors[1], genome = colors.back();
    EXPECT_GT(lightnessAndChroma(lipid).x, 0.88);
    EXPECT_LT(lightnessAndChroma(lipid).y, 0.06);
    EXPECT_NEAR(hueDeg(genome), 95.0, 15.0) << enumName(palette);
    EXPECT_GT(lightnessAndChroma(genome).y, 0.1);
  }
}

TEST(TypePalette, WhereNoTypeSaysWhatItDoesWordsSaySo) {
  scene::ModelLayer layer;
  for (bool isKnown : {false, true}) {
    layer.data = Shared<Model>(
        bodiesInBodies(1, 4, isKnown ? std::vector<std::string>{"repair", "copying"} : std::vector<std::string>{}));
    layer.palette = scene::Palette::Type;
    EXPECT_EQ(scene::whyOneColor(layer), "");
    layer.palette = scene::Palette::Function;
    EXPECT_EQ(scene::whyOneColor(layer).empty(), isKnown);
    std::vector<glm::vec3> colors = scene::typeColors(layer);
    EXPECT_EQ(colors[2] != colors[3], isKnown);
  }
}

}  // namespace
}  // namespace velum
