#include "model/InstanceRows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "makeModel.h"
#include "model/FocusRows.h"
#include "model/InstanceTarget.h"
#include "scene/Scene.h"
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
  cut.model.spares = {spareOf("root", 0.1), spareOf("root.a.type0", 0.7), spareOf("root.a", 0.4),
                      spareOf("root.a.type", 1)};
  auto shareOf = [&](std::size_t t) {
    return model::typeSpareOf(cut, model, model.types[t], pathOf(model, model.types[t])).share;
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
  cut.model.spares = {spareOf("root", 1.0)};
  auto shareOf = [&](std::size_t t) {
    return model::typeSpareOf(cut, model, model.types[t], pathOf(model, model.types[t])).share;
  };
  EXPECT_EQ(shareOf(0) + shareOf(1), 2.0);
  cut.model.leastMass = 1e5;
  EXPECT_EQ(shareOf(0), 0.0);
  EXPECT_EQ(shareOf(1), 1.0);
  cut.model.leastMass = 0;
  cut.model.mostMass = 1e5;
  EXPECT_EQ(shareOf(0), 1.0);
  EXPECT_EQ(shareOf(1), 0.0);
  cut.model.mostMass = scene::Spare::kEndless;
  cut.model.leastCopies = 16;
  EXPECT_EQ(shareOf(0), 1.0) << "16 of them";
  EXPECT_EQ(shareOf(1), 0.0) << "15 of them";
}

TEST(TypeSpares, AFocusOnACompartmentHoldsAllOfItsTypes) {
  scene::Scene scene;
  scene.model.data = Shared<Model>(ModelMaker{.types = 4}.make());
  const Model& model = *scene.model.data;
  for (std::string path : {"root", "root.a", "root.b", "root.a.type0", "root.a.type", "type0", ""}) {
    scene::Cut cut;
    cut.model.focus.emplace().types = {{path}};
    scene.cuts = {cut};
    auto rows = model::makeTypeSpareRows(scene);
    ASSERT_EQ(rows.size(), model.types.size());
    for (std::size_t type = 0; type < rows.size(); ++type) {
      std::string own = pathOf(model, model.types[type]);
      bool isIn = !path.empty() && (own == path || own.starts_with(path + "."));
      EXPECT_EQ(rows[type].isFocus, isIn ? 1.0f : 0.0f) << own << " by " << path;
    }
  }
}

TEST(TypeSpares, ACutThatIsOffHasNoPlaceAmongThem) {
  scene::Scene scene;
  scene.model.data = Shared<Model>(ModelMaker{}.make());
  for (int i = 0; i < 4; ++i) {
    scene::Cut cut;
    cut.model.spares = {spareOf("root", 0.1 + 0.2 * i)};
    cut.model.spares[0].aperture = i % 2 ? 0.5 : 1.0;
    cut.model.wholeInstances = i % 2 == 0;
    cut.model.focus.emplace().types = {{i < 2 ? "root.a" : "root.b"}};
    scene::addCut(scene, cut);
  }
  auto rowsOf = [](const scene::Scene& of) {
    std::vector<std::pair<float, float>> rows;
    for (const auto& row : model::makeTypeSpareRows(of)) rows.emplace_back(row.share, row.isFocus);
    return rows;
  };
  auto focusOf = [](const scene::Scene& of) {
    std::vector<std::tuple<int, std::string, bool>> rows;
    for (const auto& row : model::focusRows(of)) rows.emplace_back(row.cut, row.focus->types[0].type, row.hasAperture);
    return rows;
  };
  ASSERT_EQ(focusOf(scene).size(), 4u);
  ASSERT_EQ(model::wholeInstanceBits(scene), 0b0101u);
  for (std::size_t at = 0; at <= scene.cuts.size(); ++at) {
    scene::Scene other = scene;
    scene::Cut off = scene.cuts[at % 4];
    off.enabled = false;
    off.model.wholeInstances = true;
    other.cuts.insert(other.cuts.begin() + std::ptrdiff_t(at), off);
    EXPECT_EQ(rowsOf(other), rowsOf(scene)) << at;
    EXPECT_EQ(focusOf(other), focusOf(scene)) << at;
    EXPECT_EQ(model::wholeInstanceBits(other), model::wholeInstanceBits(scene)) << at;
  }
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
  EXPECT_EQ(model::makeTypeRows(layer)[1].color.a, 0.0f);
  EXPECT_EQ(model::makeTypeRows(layer)[0].color.a, 1.0f);
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

TEST(InstanceParts, HoldEachInstanceOfEachCopyOnceAndNoneIsLargerThanAsked) {
  for (std::uint32_t instances : {1u, 63u, 64u, 1000u})
    for (int copies : {1, 3, 8})
      for (std::uint32_t most : {64u, 200u, 900u, 5000u}) {
        std::vector<int> held(instances * std::uint32_t(copies), 0);
        for (const auto& part : model::instanceParts(instances, copies, most)) {
          EXPECT_LE(part.end - part.first, most);
          if (part.copies > 1) {
            EXPECT_LE((part.end - part.first) * std::uint32_t(part.copies), most);
          }
          for (int copy = part.firstCopy; copy < part.firstCopy + part.copies; ++copy)
            for (std::uint32_t i = part.first; i < part.end; ++i) ++held.at(std::uint32_t(copy) * instances + i);
        }
        EXPECT_EQ(std::count(held.begin(), held.end(), 1), std::ptrdiff_t(held.size()))
            << instances << " instances, " << copies << " copies, " << most;
      }
}

}  // namespace
}  // namespace velum
