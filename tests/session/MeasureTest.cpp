// Measures of marks against closed forms, and how they are told.
#include "session/measure/Measure.h"

#include <gtest/gtest.h>

#include <random>

#include "MeasureGrids.h"
#include "PyramidSource.h"
#include "core/Error.h"
#include "session/document/Open.h"
#include "session/measure/Values.h"

namespace velum::session {
namespace {

Measured measured(const scene::Scene& scene, const scene::Mark& mark) {
  Progress progress;
  return measure(scene, mark, progress);
}
double valueOf(const Measured& of, std::string_view name) {
  const Quantity* quantity = findQuantity(of, name);
  EXPECT_TRUE(quantity) << name << ": " << of.problem;
  return quantity ? quantity->value : -1e9;
}

/// CT-like values that rise along all axes of the world: 16 bits with a slope.
double rampAt(glm::dvec3 p) { return 40.0 + 3.0 * p.x - 2.0 * p.y + 5.0 * p.z; }

Volume rampVolume(const MeasureGrid& grid) {
  glm::dmat4 frame = frameOf(grid);
  Volume volume = makeVolume(
      dimsOf(grid), SampleType::Int16, [&](glm::ivec3 v) { return rampAt(glm::dvec3(frame * glm::dvec4(v, 1.0))); },
      frame, 0.01, -50.0);
  volume.unit = "HU";
  return volume;
}
void expectValues(const Measured& found, const PlainSum& plain) {
  double mean = plain.sum / plain.count;
  EXPECT_EQ(valueOf(found, "voxels"), plain.count);
  EXPECT_NEAR(valueOf(found, "mean"), mean, 1e-9);
  EXPECT_NEAR(valueOf(found, "deviation"), std::sqrt(plain.squares / plain.count - mean * mean), 1e-6);
  EXPECT_EQ(valueOf(found, "least"), plain.least);
  EXPECT_EQ(valueOf(found, "most"), plain.most);
}
scene::Scene rampScene(const MeasureGrid& grid) {
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(rampVolume(grid));
  return scene;
}

TEST(Measure, StraightKindsAreGeometry) {
  scene::Scene scene = rampScene(measureGrids()[0]);
  EXPECT_EQ(measured(scene, markOf(scene::MarkKind::Distance, {{0, 0, 0}, {3, 4, 12}})).text, "13.0 mm");
  Measured path = measured(scene, markOf(scene::MarkKind::Path, {{0, 0, 0}, {3, 4, 0}, {3, 4, 12}}));
  EXPECT_NEAR(valueOf(path, "length"), 17.0, 1e-12);
  Measured angle = measured(scene, markOf(scene::MarkKind::Angle, {{10, 0, 0}, {0, 0, 0}, {0, 20, 0}}));
  EXPECT_NEAR(valueOf(angle, "angle"), 90.0, 1e-12);
  EXPECT_EQ(angle.text, "90\u00b0");  // of arms that are known to half a degree
  Measured far = measured(scene, markOf(scene::MarkKind::Angle, {{200, 0, 0}, {0, 0, 0}, {200, 200, 0}}));
  EXPECT_EQ(far.text, "45.0\u00b0");
  // An L in an oblique plane.
  glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(0.6, 0.0, 0.8)));
  std::vector<glm::dvec3> corners;
  for (glm::dvec3 p : {glm::dvec3(0, 0, 5), {20, 0, 5}, {20, 10, 5}, {10, 10, 5}, {10, 30, 5}, {0, 30, 5}})
    corners.push_back(turn * p);
  Measured area = measured(scene, markOf(scene::MarkKind::Area, corners));
  EXPECT_NEAR(valueOf(area, "area"), 400.0, 1e-9);
  EXPECT_EQ(area.text, "400 mm\u00b2");
  for (auto kind : {scene::MarkKind::Arrow, scene::MarkKind::Label})
    EXPECT_EQ(measured(scene, markOf(kind, {{0, 0, 0}, {1, 0, 0}})).text, "");
  EXPECT_NE(measured(scene, markOf(scene::MarkKind::Distance, {{0, 0, 0}})).problem, "");
}

TEST(Measure, TextsHaveTheUnitAndDigitsOfTheData) {
  auto withVoxels = [](double edge) {
    scene::Scene scene;
    scene.volume.data = Shared<Volume>(makeVolume(
        {8, 8, 8}, SampleType::UInt8, [](glm::ivec3 v) { return v.x; }, centredFrame({8, 8, 8}, glm::dvec3(edge))));
    return scene;
  };
  auto told = [](const scene::Scene& scene, double length) {
    return measured(scene, markOf(scene::MarkKind::Distance, {{0, 0, 0}, {length, 0, 0}})).text;
  };
  EXPECT_EQ(told(withVoxels(0.8), 23.4321), "23.4 mm");
  EXPECT_EQ(told(withVoxels(0.1), 23.4321), "23.43 mm");
  EXPECT_EQ(told(withVoxels(0.001), 0.0234321), "23.4 \u00b5m");
  EXPECT_EQ(told(withVoxels(25000.0), 1234567.0), "1.235 km");
  EXPECT_EQ(told(withVoxels(0.8), 0.0), "0.0 mm");
  scene::Scene unknown = withVoxels(1.0);
  Volume volume = *unknown.volume.data;
  volume.isSpacingKnown = false;
  unknown.volume.data = Shared<Volume>(std::move(volume));
  EXPECT_EQ(told(unknown, 12.0), "12.0 voxels");
  scene::Scene cell;
  cell.unit = LengthUnit::Angstrom;
  cell.model.data = Shared<Model>(Model());
  EXPECT_EQ(told(cell, 12.8), "1.28 nm");
  EXPECT_EQ(told(cell, 1.43), "1.4 \u00c5");
  EXPECT_EQ(told(cell, 123456.0), "12.346 \u00b5m");
}

TEST(Measure, QuantitiesAreToldAsPeopleDo) {
  EXPECT_EQ(quantityText({"volume", 12345.678, "mm\u00b3", -1}), "12.35 ml");
  EXPECT_EQ(quantityText({"volume", 123.4, "mm\u00b3", 0}), "123 mm\u00b3");
  EXPECT_EQ(quantityText({"volume", 0.3, "mm\u00b3", 0}), "0.3 mm\u00b3");
  EXPECT_EQ(quantityText({"surface", 45678.0, "mm\u00b2", -1}), "456.8 cm\u00b2");
  EXPECT_EQ(quantityText({"voxels", 1204.0, "voxels", 0}), "1,204 voxels");
  EXPECT_EQ(quantityText({"mean", -0.04, "HU", 1}), "-0.04 HU");
  EXPECT_EQ(quantityText({"angle", 37.46, "\u00b0", 1}), "37.5\u00b0");
  EXPECT_EQ(quantityNumber({"length", 23.4321, "mm", 1}), "23.43");
}

TEST(Measure, ValuesInABallAreThoseOfAPlainLoop) {
  for (const MeasureGrid& grid : measureGrids()) {
    SCOPED_TRACE(grid.name);
    scene::Scene scene = rampScene(grid);
    const Volume& volume = *scene.volume.data;
    glm::dvec3 middle(1.3, -2.1, 0.7), rim = middle + glm::dvec3(0, 0, 9.5);
    PlainSum plain = sumWhere(volume, [&](glm::dvec3 at) { return glm::distance(at, middle) <= 9.5; });
    Measured found = measured(scene, markOf(scene::MarkKind::Circle, {middle, rim}));
    expectValues(found, plain);
    EXPECT_EQ(findQuantity(found, "mean")->unit, "HU");
    // And the truth: a ramp's mean is the value in the middle, its deviation the slope by the ball's.
    EXPECT_NEAR(valueOf(found, "mean"), rampAt(middle), 0.01 * rampAt(middle));
    double slope = glm::length(glm::dvec3(3, -2, 5));
    EXPECT_NEAR(valueOf(found, "deviation"), slope * 9.5 / std::sqrt(5.0), 0.01 * slope * 9.5 / std::sqrt(5.0));
  }
}

/// Of labels on another grid, cut by a plane.
TEST(Measure, ValuesOfARegionAreThoseOfItsVoxelsThatAreLeft) {
  MeasureGrid labelled{"labels", {1.3, 0.9, 1.1}, 1.1, 0.2};
  for (const MeasureGrid& grid : measureGrids()) {
    SCOPED_TRACE(grid.name);
    scene::Scene scene = sceneOfBall(labelled, 12.0);
    scene.volume.data = Shared<Volume>(rampVolume(grid));
    glm::dvec3 normal = glm::normalize(glm::dvec3(1, -2, 0.7));
    scene::addCut(scene, cutAt(scene::CutShape::Plane, 3.3 * normal, normal));
    const Volume& volume = *scene.volume.data;
    const LabelVolume& labels = *scene.labels.data;
    PlainSum plain = sumWhere(volume, [&](glm::dvec3 at) {
      glm::ivec3 label(glm::round(glm::dvec3(glm::inverse(labels.worldFromVoxel()) * glm::dvec4(at, 1.0))));
      return labels.at(label) == 1 && glm::dot(at - kMeasureMiddle, normal) <= 3.3;
    });
    scene::Mark region = markOf(scene::MarkKind::Region, {});
    region.structure = 1;
    expectValues(measured(scene, region), plain);
  }
}

TEST(Measure, BoxesAreAVoxelThickAtLeast) {
  for (const MeasureGrid& grid : measureGrids()) {
    SCOPED_TRACE(grid.name);
    scene::Scene scene = rampScene(grid);
    glm::dmat4 frame = scene.volume.data->worldFromVoxel;
    auto at = [&](double x, double y, double z) { return glm::dvec3(frame * glm::dvec4(x, y, z, 1.0)); };
    auto countOf = [&](glm::dvec3 a, glm::dvec3 b) {
      return valueOf(measured(scene, markOf(scene::MarkKind::Box, {a, b})), "voxels");
    };
    EXPECT_EQ(countOf(at(3, 4, 5), at(7, 6, 9)), 5 * 3 * 5);
    EXPECT_EQ(countOf(at(7, 6, 9), at(3, 4, 5)), 5 * 3 * 5);
    EXPECT_EQ(countOf(at(2.6, 4, 5.2), at(7.4, 6, 5.2)), 5 * 3);  // flat, between two layers of voxels
    EXPECT_EQ(countOf(at(3.3, 4.4, 5.2), at(3.3, 4.4, 5.2)), 1);
    EXPECT_EQ(countOf(at(-5, -5, -5), at(1, 1, 1)), 8);
    EXPECT_NE(measured(scene, markOf(scene::MarkKind::Box, {at(-9, 0, 0), at(-5, 2, 2)})).problem, "");
  }
  scene::Scene scene = rampScene(measureGrids()[0]);
  EXPECT_EQ(valueOf(measured(scene, markOf(scene::MarkKind::Circle, {{0.2, 0.1, 0}, {0.21, 0.1, 0}})), "voxels"), 1.0);
  EXPECT_NE(measured(scene, markOf(scene::MarkKind::Circle, {{900, 0, 0}, {901, 0, 0}})).problem, "");
}

TEST(Measure, ProfilesOfARampAreStraight) {
  for (const MeasureGrid& grid : measureGrids()) {
    SCOPED_TRACE(grid.name);
    scene::Scene scene = rampScene(grid);
    glm::dvec3 a(-8, 5, -6), b(9, -7, 8);
    Measured found = measured(scene, markOf(scene::MarkKind::Profile, {a, b}));
    double step = 0.5 * smallestSpacing(scene.volume.data->worldFromVoxel);
    ASSERT_GT(found.profile.size(), 10u);
    EXPECT_EQ(found.profile.front().place, a);
    EXPECT_EQ(found.profile.back().place, b);
    for (std::size_t i = 0; i < found.profile.size(); ++i) {
      const ProfileSample& sample = found.profile[i];
      EXPECT_NEAR(sample.value, rampAt(sample.place), 0.011);  // the values' own step
      EXPECT_NEAR(sample.distance, glm::distance(a, sample.place), 1e-9);
      if (i == 0) continue;
      EXPECT_LE(sample.distance - found.profile[i - 1].distance, step * (1 + 1e-9));
    }
    // Beyond the volume there is no value.
    Measured beyond = measured(scene, markOf(scene::MarkKind::Profile, {{0, 0, 0}, {500, 0, 0}}));
    EXPECT_TRUE(std::isfinite(beyond.profile.front().value));
    EXPECT_TRUE(std::isnan(beyond.profile.back().value));
    EXPECT_NE(measured(scene, markOf(scene::MarkKind::Profile, {{400, 0, 0}, {500, 0, 0}})).problem, "");
  }
}

/// As a radiologist draws one on a section: the voxels of one layer, whatever the grid.
TEST(Measure, ACircleHasTheVoxelsOfOneLayerWithinIt) {
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume({60, 50, 40}, SampleType::UInt8, [](glm::ivec3 v) { return 3 * v.z; }));
  for (glm::dvec3 normal : {glm::dvec3(0, 0, 2), glm::dvec3(1, 0, 0)}) {
    scene::Mark mark = markOf(scene::MarkKind::Circle, {{30, 25, 20}, glm::dvec3(30, 25, 20) + glm::dvec3(0, 9.3, 0)});
    mark.normal = normal;
    double count = 0;
    for (int z = -10; z <= 10; ++z)
      for (int y = -10; y <= 10; ++y) count += y * y + z * z <= 9.3 * 9.3;
    Measured found = measured(scene, mark);
    EXPECT_EQ(findQuantity(found, "voxels")->value, count);
    EXPECT_NEAR(findQuantity(found, "area")->value, 3.14159265 * 9.3 * 9.3, 1e-4);
    EXPECT_EQ(findQuantity(found, "deviation")->value == 0.0, normal.z > 0.0) << "values rise along z";
  }
  scene::Mark ball = markOf(scene::MarkKind::Circle, {{30, 25, 20}, {30, 34.3, 20}});
  EXPECT_GT(findQuantity(measured(scene, ball), "voxels")->value, 3000.0);
}

TEST(Measure, KnowsTimeStepAndChannel) {
  Volume volume;
  volume.dims = {9, 8, 7};
  volume.type = SampleType::UInt16;
  volume.channels = 3, volume.timeSteps = 2;
  volume.voxels.resize(timeStepBytes(volume) * 2);
  auto* samples = reinterpret_cast<std::uint16_t*>(volume.voxels.data());
  for (int i = 0; i < 9 * 8 * 7 * 3 * 2; ++i)
    samples[i] = std::uint16_t(100 * (i % 3) + (i >= 9 * 8 * 7 * 3 ? 1000 : 0));
  computeRange(volume);
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(std::move(volume));
  scene.volume.channel = 2, scene.volume.timeStep = 1;
  EXPECT_EQ(valueOf(measured(scene, markOf(scene::MarkKind::Box, {{0, 0, 0}, {8, 7, 6}})), "mean"), 1200.0);
  Measured profile = measured(scene, markOf(scene::MarkKind::Profile, {{0, 0, 0}, {8, 7, 6}}));
  for (const ProfileSample& sample : profile.profile) EXPECT_NEAR(sample.value, 1200.0, 1e-9);
}

TEST(Measure, OfAStreamedVolumeIsWhatItIsInMemory) {
  for (const MeasureGrid& grid : measureGrids()) {
    SCOPED_TRACE(grid.name);
    scene::Scene whole = sceneOfBall(grid, 13.0), streamed = whole;
    Volume volume = rampVolume(grid);
    auto source = std::make_shared<PyramidSource>(volume, 3, glm::ivec3(24, 40, 16));
    whole.volume.data = Shared<Volume>(std::move(volume));
    streamed.volume.data = Shared<Volume>(streamedVolume(source, 2));
    scene::Mark region;
    region.kind = scene::MarkKind::Region;
    region.structure = 1;
    for (scene::Mark mark : {markOf(scene::MarkKind::Circle, {{1, 2, 3}, {1, 2, 12}}),
                             markOf(scene::MarkKind::Box, {{-9, -8, -7}, {6, 7, 8}}),
                             markOf(scene::MarkKind::Profile, {{-9, -8, -7}, {6, 7, 8}}), region}) {
      Measured in = measured(whole, mark), out = measured(streamed, mark);
      EXPECT_EQ(in.problem, "");
      ASSERT_EQ(in.quantities.size(), out.quantities.size());
      for (std::size_t i = 0; i < in.quantities.size(); ++i)
        EXPECT_NEAR(in.quantities[i].value, out.quantities[i].value, 1e-9 * std::abs(in.quantities[i].value) + 1e-12);
      ASSERT_EQ(in.profile.size(), out.profile.size());
      for (std::size_t i = 0; i < in.profile.size(); ++i) EXPECT_NEAR(in.profile[i].value, out.profile[i].value, 1e-9);
    }
    // A small circle reads few bricks.
    auto fresh = std::make_shared<PyramidSource>(rampVolume(grid), 3, glm::ivec3(8));
    streamed.volume.data = Shared<Volume>(streamedVolume(fresh, 2));
    int before = fresh->reads;
    measured(streamed, markOf(scene::MarkKind::Circle, {{0, 0, 0}, {0, 0, 2}}));
    EXPECT_LE(fresh->reads - before, 8);
    fresh->damaged = true;
    EXPECT_THROW(measured(streamed, markOf(scene::MarkKind::Circle, {{10, 10, 10}, {10, 10, 14}})), InputError);
  }
}

TEST(Measure, SaysWhatIsMissing) {
  scene::Scene empty;
  for (auto kind : {scene::MarkKind::Circle, scene::MarkKind::Box, scene::MarkKind::Profile})
    EXPECT_NE(measured(empty, markOf(kind, {{0, 0, 0}, {1, 0, 0}})).problem, "");
  scene::Mark region;
  region.kind = scene::MarkKind::Region;
  EXPECT_NE(measured(empty, region).problem, "");
  region.structure = 9;
  EXPECT_NE(measured(sceneOfBall(measureGrids()[0], 5.0), region).problem, "");
  scene::Mark along = markOf(scene::MarkKind::Distance, {{0, 0, 0}, {1, 0, 0}});
  along.alongSurface = true;
  EXPECT_NE(measured(empty, along).problem, "");
  Progress cancelled;
  cancelled.cancel();
  EXPECT_THROW(measure(rampScene(measureGrids()[0]), markOf(scene::MarkKind::Box, {{0, 0, 0}, {9, 9, 9}}), cancelled),
               Cancelled);
}

}  // namespace
}  // namespace velum::session
