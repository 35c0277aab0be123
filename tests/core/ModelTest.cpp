#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/ModelBuilder.h"

namespace velum {
namespace {

std::vector<Atom> atomAt(float x, std::uint8_t element = 6) { return {{.position = {x, 0, 0}, .element = element}}; }

TEST(ModelBuilder, WhatBelongsTogetherStandsInARow) {
  ModelBuilder builder("a");
  std::vector<std::string> inner{"a", "b"}, outer{"a"};
  std::uint32_t b = builder.compartment(inner), a = builder.compartment(outer);
  EXPECT_EQ(builder.compartment(inner), b);
  std::uint32_t first = builder.addType({.name = "first", .compartment = b});
  std::uint32_t second = builder.addType({.name = "second", .compartment = a});
  std::uint32_t s = builder.addMolecule(second, atomAt(0));
  std::uint32_t f1 = builder.addMolecule(first, atomAt(1)), f2 = builder.addMolecule(first, atomAt(2));
  for (int i = 0; i < 5; ++i)
    for (std::uint32_t molecule : {s, f2, f1}) builder.addInstance(molecule, glm::vec3(float(i)), {1, 0, 0, 0});
  Model model = builder.build();
  ASSERT_EQ(model.instances.size(), 15u);
  ASSERT_EQ(model.types.size(), 2u);
  EXPECT_EQ(pathOf(model, model.types[0]), "root.a.b.first");
  EXPECT_EQ(pathOf(model, model.types[1]), "root.a.second");
  EXPECT_EQ(model.types[0].instanceCount, 10u);
  EXPECT_EQ(model.types[1].firstInstance, 10u);
  for (const Molecule& molecule : model.molecules)
    for (std::uint32_t i = 0; i < 5; ++i) {
      const Instance& instance = model.instances[molecule.firstInstance + i];
      EXPECT_EQ(&model.molecules[instance.molecule], &molecule);
      EXPECT_EQ(instance.position.x, float(i));  // in the order in which they were added
    }
}

TEST(ModelBuilder, MoleculesOfNothingGoWithTheirInstances) {
  ModelBuilder builder("a");
  std::uint32_t empty = builder.addMolecule(builder.addType({.name = "empty"}), {});
  std::uint32_t type = builder.addType({.name = "full"}), full = builder.addMolecule(type, atomAt(0));
  builder.addInstance(empty, {5, 5, 5}, {1, 0, 0, 0});
  builder.beginFibre();
  builder.addInstance(full, {1, 0, 0}, {1, 0, 0, 0});
  builder.addInstance(full, {2, 0, 0}, {1, 0, 0, 0});
  builder.addFibre(type, {{1, 0, 0}, {2, 0, 0}});
  Model model = builder.build();
  ASSERT_EQ(model.instances.size(), 2u);
  ASSERT_EQ(model.types.size(), 1u);
  EXPECT_EQ(model.types[0].name, "full");
  ASSERT_EQ(model.fibres.size(), 1u);
  EXPECT_EQ(model.fibres[0].type, 0u);
  EXPECT_EQ(model.fibres[0].firstInstance, 0u);
  EXPECT_EQ(model.fibres[0].instanceCount, 2u);
  EXPECT_EQ(model.high.x, 2.0f + radiusOf(6));
}

TEST(ModelBuilder, BoundsHoldTheTurnedSpheres) {
  ModelBuilder builder("a");
  std::uint32_t molecule = builder.addMolecule(builder.addType({.name = "a"}), atomAt(10));
  builder.addInstance(molecule, {0, 0, 100}, glm::angleAxis(glm::radians(90.0f), glm::vec3(0, 0, 1)));
  Model model = builder.build();
  EXPECT_NEAR(model.low.y, 10 - radiusOf(6), 1e-4);
  EXPECT_NEAR(model.high.y, 10 + radiusOf(6), 1e-4);
  EXPECT_NEAR(model.high.x, radiusOf(6), 1e-4);
}

TEST(ModelBuilder, MassIsTheFilesElseTheAtoms) {
  ModelBuilder builder("a");
  std::uint32_t known = builder.addType({.name = "a", .mass = 5000, .massSource = MassSource::File});
  std::uint32_t atoms = builder.addType({.name = "b"}), beads = builder.addType({.name = "c"});
  builder.addMolecule(known, atomAt(0));
  builder.addMolecule(atoms, {{.element = 6}, {.element = 8}});
  builder.addMolecule(beads, {}, {{{0, 0, 0, 10}}});
  for (std::uint32_t molecule : {0u, 1u, 2u}) builder.addInstance(molecule, glm::vec3(0), {1, 0, 0, 0});
  Model model = builder.build();
  EXPECT_EQ(model.types[known].mass, 5000.0);
  EXPECT_NEAR(model.types[atoms].mass, 12.011 + 15.999, 1e-3);
  EXPECT_EQ(model.types[beads].massSource, MassSource::Beads);
  EXPECT_NEAR(model.types[beads].mass, 4188.79 * 0.813, 1.0);
}

TEST(Model, RandomNumbersAreEvenAndIndependent) {
  constexpr std::uint32_t kCount = 100000;
  double sum[2]{}, product = 0.0, neighbours = 0.0;
  std::vector<int> tenths(10);
  for (std::uint32_t i = 0; i < kCount; ++i) {
    float a = randomOf(i, 0), b = randomOf(i, 1);
    ASSERT_GE(a, 0.0f);
    ASSERT_LT(a, 1.0f);
    sum[0] += a, sum[1] += b, product += double(a) * double(b), neighbours += double(a) * double(randomOf(i + 1));
    ++tenths[std::size_t(a * 10.0f)];
  }
  // Five standard deviations of the mean of so many.
  double tolerance = 5.0 * std::sqrt(1.0 / 12.0 / kCount);
  EXPECT_NEAR(sum[0] / kCount, 0.5, tolerance);
  EXPECT_NEAR(sum[1] / kCount, 0.5, tolerance);
  EXPECT_NEAR(product / kCount, 0.25, tolerance);
  EXPECT_NEAR(neighbours / kCount, 0.25, tolerance);
  for (int count : tenths) EXPECT_NEAR(count, kCount / 10, 5.0 * std::sqrt(kCount * 0.09));
}

}  // namespace
}  // namespace velum
