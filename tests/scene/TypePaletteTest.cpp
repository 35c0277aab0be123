// Colours of types: what stands back, what stands out, what looks alike.
#include <gtest/gtest.h>

#include <cmath>

#include "makeModel.h"
#include "scene/ModelLayer.h"

namespace velum {
namespace {

/// Colour in Oklab: lightness, and how far it is from grey. Of sRGB, by the matrices of [OKLAB].
glm::dvec2 lightnessAndChroma(glm::vec3 srgb) {
  glm::dvec3 c;
  for (int i = 0; i < 3; ++i) c[i] = std::pow((double(srgb[i]) + 0.055) / 1.055, 2.4);  // none is near black here
  double l = std::cbrt(0.4122214708 * c.x + 0.5363325363 * c.y + 0.0514459929 * c.z);
  double m = std::cbrt(0.2119034982 * c.x + 0.6806995451 * c.y + 0.1073969566 * c.z);
  double s = std::cbrt(0.0883024619 * c.x + 0.2817188376 * c.y + 0.6299787005 * c.z);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          glm::length(glm::dvec2(1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
                                 0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s))};
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
  EXPECT_GT(nearest, 0.04) << "twelve grey levels, of types that take up most of the picture";
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

}  // namespace
}  // namespace velum
