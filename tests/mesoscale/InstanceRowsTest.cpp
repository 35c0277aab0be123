#include "velum/mesoscale/InstanceRows.h"

#include <gtest/gtest.h>

#include <cmath>

#include "makeModel.h"
#include "shared/instance.h"

namespace velum {
namespace {

scene::TypeSpare spareOf(std::string type, double share) {
  scene::TypeSpare spare;
  spare.type = std::move(type);
  spare.share = share;
  return spare;
}

shared::TypeSpareRow rowOf(double share, double falloff, double amount, double exponent) {
  shared::TypeSpareRow row{};
  row.share = float(share);
  row.distance = shared::kCutFar;
  row.falloff = float(falloff);
  row.amount = float(amount);
  row.exponent = float(exponent);
  return row;
}

/// The probability that an instance at a signed depth in the removed side stays, as TypeSpare describes it.
double stays(double share, double falloff, double amount, double exponent, double depth) {
  double ramp = std::min(1.0, std::pow(std::abs(depth) / std::max(std::abs(falloff), 1e-12), exponent));
  if (depth >= 0) return falloff > 0 && depth < falloff ? share + (1 - share) * amount * (1 - ramp) : share;
  return falloff < 0 && depth > falloff ? 1 - (1 - share) * amount * (1 - ramp) : 1.0;
}

TEST(TypeSpares, TheLongestPathThatFitsCounts) {
  Model model = ModelMaker{}.make();
  scene::Cut cut;
  cut.typeSpares = {spareOf("root", 0.1), spareOf("root.a.type0", 0.7), spareOf("root.a", 0.4),
                    spareOf("root.a.type", 1)};
  auto shareOf = [&](std::size_t t) {
    return mesoscale::typeSpareOf(cut, model, model.types[t], pathOf(model, model.types[t])).share;
  };
  EXPECT_EQ(shareOf(0), 0.7);
  EXPECT_EQ(shareOf(1), 0.1) << "of compartment b";
  EXPECT_EQ(shareOf(2), 0.4) << "a name that only begins alike is another's";
}

TEST(TypeSpares, TypesOutOfTheRangesOfMassAndNumberAreNotSpared) {
  ModelMaker maker;
  maker.types = 2;
  maker.instances = 31;
  Model model = maker.make();
  model.types[0].mass = 1e4;
  model.types[1].mass = 1e6;
  scene::Cut cut;
  cut.typeSpares = {spareOf("root", 1.0)};
  auto shareOf = [&](std::size_t t) {
    return mesoscale::typeSpareOf(cut, model, model.types[t], pathOf(model, model.types[t])).share;
  };
  EXPECT_EQ(shareOf(0) + shareOf(1), 2.0);
  cut.leastMass = 1e5;
  EXPECT_EQ(shareOf(0), 0.0);
  EXPECT_EQ(shareOf(1), 1.0);
  cut.leastMass = 0;
  cut.mostMass = 1e5;
  EXPECT_EQ(shareOf(0), 1.0);
  EXPECT_EQ(shareOf(1), 0.0);
  cut.mostMass = scene::Spare::kEndless;
  cut.leastCopies = 16;
  EXPECT_EQ(shareOf(0), 1.0) << "16 of them";
  EXPECT_EQ(shareOf(1), 0.0) << "15 of them";
}

TEST(TypeSpares, DepthsGiveTheProbabilityOfTheFormula) {
  constexpr int kNumbers = 20000;
  for (double share : {0.0, 0.25, 0.8, 1.0})
    for (double falloff : {0.0, 30.0, -30.0})
      for (double amount : {0.5, 1.0})
        for (double exponent : {0.5, 1.0, 3.0}) {
          shared::TypeSpareRow row = rowOf(share, falloff, amount, exponent);
          for (double depth : {-60.0, -29.0, -15.0, -1.0, 1.0, 8.0, 15.0, 29.0, 60.0}) {
            int left = 0;
            for (int i = 0; i < kNumbers; ++i)
              left += !(depth > double(shared::typeSpareDepth(row, (float(i) + 0.5f) / kNumbers)));
            EXPECT_NEAR(double(left) / kNumbers, stays(share, falloff, amount, exponent, depth), 2e-3)
                << "share " << share << " falloff " << falloff << " amount " << amount << " exponent " << exponent
                << " depth " << depth;
          }
        }
}

TEST(TypeSpares, EndWhereTheirDistanceDoes) {
  shared::TypeSpareRow row = rowOf(0.5, 0, 1, 1);
  row.distance = 12.0f;
  EXPECT_EQ(shared::typeSpareDepth(row, 0.2f), 12.0f);
  EXPECT_EQ(shared::typeSpareDepth(row, 0.7f), 0.0f);
}

TEST(InstanceRandom, IsThatOfCore) {
  for (std::uint32_t i : {0u, 1u, 7u, 63u, 235316u, 0xfffffffeu})
    for (std::uint32_t stream : {0u, 1u, 2u}) EXPECT_EQ(shared::instanceRandom(i, stream), randomOf(i, stream));
}

TEST(TypeColors, AreThoseOfTheUserWhereHeSaysSo) {
  scene::ModelLayer layer;
  layer.data = Shared<Model>(ModelMaker{}.make());
  auto plain = scene::typeColors(layer);
  scene::TypeLook look;
  look.type = "root.b.type1";
  look.color = glm::vec3(0.1f, 0.9f, 0.2f);
  layer.types = {look};
  auto colors = scene::typeColors(layer);
  EXPECT_EQ(colors[0], plain[0]);
  EXPECT_EQ(colors[1], *look.color);
  layer.types[0].visible = false;
  EXPECT_EQ(mesoscale::makeTypeRows(layer)[1].color.a, 0.0f);
  EXPECT_EQ(mesoscale::makeTypeRows(layer)[0].color.a, 1.0f);
}

TEST(TypeColors, TellCompartmentsApart) {
  scene::ModelLayer layer;
  ModelMaker maker;
  maker.types = 8;
  layer.data = Shared<Model>(maker.make());
  for (auto palette : {scene::Palette::Type, scene::Palette::Compartment}) {
    layer.palette = palette;
    auto colors = scene::typeColors(layer);
    double within = 0, across = 1e9;
    for (std::size_t a = 0; a < colors.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) {
        double apart = glm::length(colors[a] - colors[b]);
        if (a % 2 == b % 2)
          within = std::max(within, palette == scene::Palette::Compartment ? apart : 0.0);
        else
          across = std::min(across, apart);
      }
    EXPECT_EQ(within, 0.0) << "a compartment has one colour";
    EXPECT_GT(across, 0.02) << enumName(palette);
  }
}

TEST(CopyGrid, HoldsAllCopiesInABlock) {
  scene::ModelLayer layer;
  layer.data = Shared<Model>(ModelMaker{}.make());
  for (int copies : {1, 2, 5, 8, 27, 237, 4096}) {
    layer.copies = copies;
    scene::CopyGrid grid = scene::copyGrid(layer);
    EXPECT_GE(grid.counts.x * grid.counts.y * grid.counts.z, copies);
    EXPECT_LT((grid.counts.z - 1) * grid.counts.x * grid.counts.y, copies) << "no layer is empty";
    EXPECT_LE(std::max(grid.counts.x, grid.counts.z), 2 * int(std::cbrt(copies)) + 2);
  }
}

}  // namespace
}  // namespace velum
