// Points of marks that go with instances of a model and with structures.
#include "session/measure/Follow.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <random>

#include "core/Error.h"
#include "core/Parallel.h"
#include "lettered.h"
#include "makeModel.h"
#include "makeVolume.h"
#include "scene/Project.h"
#include "session/lettering/Lettering.h"
#include "session/measure/Measure.h"
#include "session/model/ModelEdit.h"

namespace velum::session {
namespace {

using scene::Mark;
using scene::MarkKind;

scene::Scene atoms(const std::vector<glm::vec3>& places) {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(modelOfAtoms(places));
  return scene;
}

/// In angstrom.
double lengthOf(const scene::Scene& scene, const Mark& mark) {
  Progress progress;
  Measured measured = measure(scene, mark, progress);
  EXPECT_EQ(measured.problem, "");
  return measured.quantities.at(0).value * (measured.quantities[0].unit == "nm" ? 10.0 : 1.0);
}

std::string whyNot(const scene::Scene& scene, const std::string& line) {
  try {
    after(scene, parseCall(line));
  } catch (const ArgumentError& error) {
    EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos);
    return error.what();
  }
  ADD_FAILURE() << line;
  return {};
}

/// The mean place of all voxels of a structure, voxel by voxel.
glm::dvec3 meanOf(const LabelVolume& labels, int id) {
  glm::dvec3 sum(0.0);
  int count = 0;
  for (int z = 0; z < labels.dims().z; ++z)
    for (int y = 0; y < labels.dims().y; ++y)
      for (int x = 0; x < labels.dims().x; ++x)
        if (labels.at({x, y, z}) == id) sum += glm::dvec3(x, y, z), ++count;
  return glm::dvec3(labels.worldFromVoxel() * glm::dvec4(sum / double(count), 1.0));
}

}  // namespace

TEST(Follow, ADistanceOfTwoInstancesIsThatOfTheirMiddlesWhereverTheyGo) {
  std::vector<glm::vec3> places{{0, 0, 0}, {30, 40, 0}, {-7, 5, 60}};
  scene::Scene scene = after(atoms(places), parseCall("mark.add distance pointInstances=0,1"));
  const Mark& mark = scene.lettering.marks.at(0);
  EXPECT_NEAR(lengthOf(scene, mark), 50.0, 1e-4);
  std::mt19937 random(4);
  std::uniform_real_distribution<float> unit(-90.0f, 90.0f);
  for (int i = 0; i < 20; ++i) {
    for (glm::vec3& place : places) place = {unit(random), unit(random), unit(random)};
    scene.model.data = Shared<Model>(modelOfAtoms(places));
    EXPECT_NEAR(lengthOf(scene, mark), glm::distance(places[0], places[1]), 1e-3) << "both ends follow";
  }
  EXPECT_EQ(fixed(scene, mark).pointInstances, std::vector<int>());
  double was = lengthOf(scene, mark);
  Mark still = fixed(scene, mark);
  scene.model.data = Shared<Model>(modelOfAtoms({{0, 0, 0}, {1, 0, 0}}));
  EXPECT_NEAR(lengthOf(scene, still), was, 1e-9) << "it was let go";
  scene.model.data = Shared<Model>(modelOfAtoms({{0, 0, 0}}));
  EXPECT_EQ(followed(scene, mark).points[1], mark.points[1]) << "where there is no such instance it stays";
}

TEST(Follow, EveryPointOfEveryKindIsDrawnWhereItsInstanceIs) {
  std::vector<glm::vec3> places{{0, 0, 0}, {30, 40, 0}, {-7, 5, 60}, {40, -20, 10}};
  for (auto [kind, count] : {std::pair(MarkKind::Distance, 2),
                             {MarkKind::Angle, 3},
                             {MarkKind::Path, 4},
                             {MarkKind::Area, 4},
                             {MarkKind::Arrow, 2}}) {
    scene::Scene scene = atoms(places);
    Mark mark{.kind = kind, .points = std::vector<glm::dvec3>(std::size_t(count), glm::dvec3(1e3))};
    for (int i = 0; i < count; ++i) mark.pointInstances.push_back(count - 1 - i);
    scene::addMark(scene.lettering.marks, mark);
    scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, 1.5);
    std::vector<glm::dvec2> points;
    for (const LetteringBlock& block : layLettering(scene, {900, 600}, {}).blocks)
      for (const vector::Item& item : block.items)
        if (const auto* shape = std::get_if<vector::Shape>(&item))
          for (const vector::Outline& outline : shape->outlines) {
            points.push_back(outline.start);
            for (const vector::Curve& curve : outline.curves) points.push_back(curve.end);
          }
    for (const glm::dvec3& middle : followed(scene, scene.lettering.marks[0]).points) {
      auto pixel = scene::pixelFromWorld(scene.camera, {900, 600}, middle);
      ASSERT_TRUE(pixel);
      double nearest = 1e9;
      for (glm::dvec2 point : points) nearest = std::min(nearest, glm::distance(point, *pixel));
      EXPECT_LT(nearest, 1e-6) << enumName(kind);
    }
  }
}

TEST(Follow, AStructuresMiddleIsTheMeanOfItsVoxelsAlsoAfterEdits) {
  std::mt19937 random(11);
  glm::dmat4 frame =
      glm::rotate(glm::dmat4(1.0), 0.4, glm::dvec3(1, 2, 3)) * glm::scale(glm::dmat4(1.0), glm::dvec3(0.5, 0.7, 2.0));
  LabelVolume labels = makeLabels(
      {45, 70, 37}, [&](glm::ivec3 v) { return v.z < 33 && v.x < 40 ? int(random() % 4)
                                               : v.y > 40           ? 5
                                                                    : 0; }, frame);
  scene::Scene scene;
  for (int edit = 0; edit < 6; ++edit) {
    scene.labels.data = Shared<LabelVolume>(labels);
    for (int id : {1, 2, 3, 5})
      EXPECT_LT(glm::distance(*middleOfVoxels(scene, id), meanOf(labels, id)), 1e-9) << edit << " " << id;
    EXPECT_FALSE(middleOfVoxels(scene, 9));
    glm::ivec3 corner(random() % 20, random() % 40, random() % 20), size(9, 14, 11);
    std::vector<std::uint16_t> ids(9 * 14 * 11);
    for (auto& id : ids) id = std::uint16_t(1 + random() % 3);
    labels.write(corner, size, ids);
  }
}

TEST(Follow, MiddlesOfLabelsThatAreAskedForByTurnsStayTheirOwn) {
  std::mt19937 random(5);
  std::vector<LabelVolume> volumes;
  for (glm::ivec3 dims : {glm::ivec3(40, 40, 40), {70, 33, 20}, {40, 40, 40}, {64, 64, 33}, {5, 6, 7}, {33, 64, 64}}) {
    // Bricks of one id, and of many.
    volumes.push_back(makeLabels(dims, [&](glm::ivec3 v) { return v.x >= 32 ? 2 : 1 + int(random() % 3); }));
  }
  std::vector<Shared<LabelVolume>> shared(volumes.begin(), volumes.end());
  for (int round = 0; round < 3; ++round)
    for (std::size_t i = 0; i < volumes.size(); ++i) {
      scene::Scene scene;
      scene.labels.data = shared[i];
      for (int id : {1, 2, 3})
        EXPECT_LT(glm::distance(*middleOfVoxels(scene, id), meanOf(volumes[i], id)), 1e-9) << i << " " << id;
    }
}

TEST(Follow, MiddlesCanBeAskedForUnderALockAndFromManyThreads) {
  std::mt19937 random(6);
  LabelVolume labels = makeLabels({70, 70, 70}, [&](glm::ivec3) { return 1 + int(random() % 5); });
  glm::dvec3 mean = meanOf(labels, 4);
  std::mutex mutex;
  std::atomic<int> wrong = 0;
  parallelFor(0, 200, [&](int i) {
    scene::Scene scene;
    scene.labels.data = Shared<LabelVolume>(labels);
    std::unique_lock lock(mutex, std::defer_lock);
    if (i % 2 == 0) lock.lock();
    auto middle = middleOfVoxels(scene, 4);
    if (!middle || glm::distance(*middle, mean) > 1e-9) ++wrong;
  });
  EXPECT_EQ(wrong, 0);
}

TEST(Follow, PointsGoToTheNextMiddleOfTheBallsThatHoldThemInAnyCopy) {
  scene::Scene scene;
  scene.model.enlargement = 2.5e5;
  scene.model.data = Shared<Model>(ModelMaker{.atoms = 20, .instances = 300, .halfEdge = 60.0f}.make());
  scene.model.copies = 5;
  scene.model.offset = {3, -7, 11};
  std::uint32_t count = 5 * 300;
  scene::ModelBox box = scene::worldBoxOfModel(scene);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-0.1, 1.1);
  Mark mark{.kind = MarkKind::Path};
  for (int i = 0; i < 150; ++i)
    mark.points.push_back(box.low + glm::dvec3(unit(random), unit(random), unit(random)) * (box.high - box.low));
  Progress progress;
  Mark bound = following(scene, mark, progress);
  int held = 0;
  for (std::size_t point = 0; point < mark.points.size(); ++point) {
    int nearest = -1;
    double least = 1e300;
    for (std::uint32_t i = 0; i < count; ++i) {
      auto place = instancePlace(scene, i);
      double away = glm::distance(place->middle, mark.points[point]);
      if (away <= place->radius && away < least) least = away, nearest = int(i);
    }
    held += nearest >= 0;
    EXPECT_EQ(point < bound.pointInstances.size() ? bound.pointInstances[point] : -1, nearest) << point;
  }
  EXPECT_GT(held, 20);
  EXPECT_LT(held, 150);
  progress.cancel();
  EXPECT_THROW(following(scene, mark, progress), Cancelled);
}

TEST(Follow, MoreInstancesThanCanBeLookedAtAreRefusedAtOnce) {
  std::vector<glm::vec3> places;
  for (int i = 0; i < 50000; ++i) places.emplace_back(float(i % 100), float(i / 100 % 100), float(i / 10000));
  scene::Scene scene = atoms(places);
  Mark mark{.kind = MarkKind::Path};
  mark.points.assign(kMostSearched / places.size() + 1, glm::dvec3(50, 50, 2));
  Progress progress;
  EXPECT_THROW(following(scene, mark, progress), ArgumentError);
  mark.points.resize(2);
  EXPECT_EQ(following(scene, mark, progress).pointInstances.size(), 2u);
}

TEST(Follow, ACircleGoesWithItsMiddleAndWhatFollowsNothingStays) {
  scene::Scene scene = atoms({{0, 0, 0}, {30, 40, 0}});
  glm::dvec3 middle = followed(scene, {.points = {{9, 9, 9}}, .pointInstances = {1}}).points[0];
  Mark circle{.kind = MarkKind::Circle, .points = {{1, 1, 1}, {1, 1, 6}}, .pointInstances = {1}};
  EXPECT_LT(glm::distance(followed(scene, circle).points[1], middle + glm::dvec3(0, 0, 5)), 1e-9);
  Mark line{.kind = MarkKind::Path, .points = {{1, 1, 1}, {2, 2, 2}, {3, 3, 3}}, .pointInstances = {-1, 1}};
  Mark now = followed(scene, line);
  EXPECT_EQ(now.points[0], line.points[0]);
  EXPECT_EQ(now.points[2], line.points[2]);
  EXPECT_LT(glm::distance(now.points[1], middle), 1e-9);
}

TEST(Follow, PointsAreBoundToWhatHoldsThem) {
  scene::Scene scene = atoms({{0, 0, 0}, {30, 40, 0}});
  scene.labels.data = Shared<LabelVolume>(makeLabels(
      {40, 40, 40}, [](glm::ivec3 v) { return v.x > 30 ? 2 : 0; },
      glm::translate(glm::dmat4(1.0), glm::dvec3(200, 0, 0))));
  scene.labels.structures = {{.id = 2, .name = "wall"}};
  glm::dvec3 first = followed(scene, {.points = {{9, 9, 9}}, .pointInstances = {0}}).points[0];
  Mark mark{.kind = MarkKind::Path, .points = {first + glm::dvec3(0.3, 0, 0), {235, 9, 9}, {100, 100, 100}}};
  scene::addMark(scene.lettering.marks, mark);
  scene = after(scene, parseCall("mark.follow 1"));
  const Mark& bound = scene.lettering.marks[0];
  EXPECT_EQ(bound.pointInstances, std::vector<int>{0});
  EXPECT_EQ(bound.pointStructures, (std::vector<int>{0, 2}));
  EXPECT_LT(glm::distance(bound.points[0], first), 1e-9);
  EXPECT_LT(glm::distance(bound.points[1], glm::dvec3(235, 19.5, 19.5)), 1e-9);
  EXPECT_EQ(bound.points[2], mark.points[2]);
  scene::Scene free = after(scene, parseCall("mark.follow 1 false"));
  EXPECT_TRUE(free.lettering.marks[0].pointStructures.empty());
  EXPECT_EQ(free.lettering.marks[0].points, bound.points);
  scene::Scene by = after(scene, parseCall("mark.add distance pointInstances=1 pointStructures=0,wall"));
  EXPECT_EQ(by.lettering.marks[1].pointStructures, (std::vector<int>{0, 2}));
  EXPECT_LT(glm::distance(by.lettering.marks[1].points[1], glm::dvec3(235, 19.5, 19.5)), 1e-9);
}

TEST(Follow, WhatIsNotThereIsSaidInALine) {
  scene::Scene scene = atoms({{0, 0, 0}, {30, 40, 0}});
  EXPECT_EQ(whyNot(scene, "mark.add distance pointInstances=0,7"), "the model has no instance 7");
  EXPECT_NE(whyNot(scene, "mark.add distance pointInstances=-1,1").find("point 1"), std::string::npos);
  EXPECT_NE(whyNot(scene, "mark.add distance pointStructures=4,5").find("4"), std::string::npos);
  scene::addMark(scene.lettering.marks, {.points = {{500, 0, 0}, {600, 0, 0}}});
  EXPECT_NE(whyNot(scene, "mark.follow 1").find("no point of mark 1"), std::string::npos);
}

}  // namespace velum::session
