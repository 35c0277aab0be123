// The side from which a model is first seen.
#include "scene/ModelView.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "makeModel.h"
#include "scene/Scene.h"
#include "scene/VisibleFrame.h"

namespace velum::scene {
namespace {

/// Turns about axes that are no axis of the world.
const glm::dquat kTurns[] = {glm::dquat(1, 0, 0, 0), glm::normalize(glm::dquat(0.8, 0.3, -0.5, 0.2)),
                             glm::normalize(glm::dquat(0.1, 0.9, 0.2, -0.6))};

class Places {
 public:
  /// Instances of a type of its own, at places of a cube of two about the origin that are in the form.
  void add(const char* compartment, int count, const glm::dquat& turn, double size,
           const std::function<bool(glm::dvec3)>& isIn) {
    MoleculeType type;
    type.name = compartment;
    std::vector<std::string> path{compartment};
    type.compartment = mBuilder.compartment(path);
    std::uint32_t molecule = mBuilder.addMolecule(mBuilder.addType(type), randomAtoms(10, 8.0f, 3));
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int placed = 0; placed < count;) {
      glm::dvec3 p(unit(mRandom), unit(mRandom), unit(mRandom));
      if (!isIn(p)) continue;
      mBuilder.addInstance(molecule, glm::vec3(turn * (p * size)), glm::quat(1, 0, 0, 0));
      ++placed;
    }
  }
  Scene scene() {
    Scene scene;
    scene.unit = LengthUnit::Angstrom;
    scene.model.data = Shared<Model>(mBuilder.build());
    return scene;
  }

 private:
  ModelBuilder mBuilder{"places"};
  std::mt19937 mRandom{7};
};

bool isInShell(glm::dvec3 p) { return std::abs(glm::length(p) - 0.95) < 0.05; }
bool isInCone(glm::dvec3 p) { return glm::length(glm::dvec2(p)) < 0.3 * (1.0 - p.z) * 0.5 + 0.05; }
bool isInRod(glm::dvec3 p) { return glm::length(glm::dvec2(p)) < 0.15; }
bool isInPlate(glm::dvec3 p) { return std::abs(p.z) < 0.08; }

double degreesFrom(glm::dvec3 a, glm::dvec3 b) {
  return glm::degrees(std::acos(std::min(1.0, std::abs(glm::dot(glm::normalize(a), glm::normalize(b))))));
}

TEST(ModelView, AConeInAShellLiesAlongThePicture) {
  for (const glm::dquat& turn : kTurns) {
    Places places;
    places.add("envelope", 6000, turn, 700.0, isInShell);
    places.add("capsid", 600, turn, 400.0, isInCone);
    glm::dmat3 axes = bestSide(places.scene(), 1.5);
    EXPECT_LT(degreesFrom(axes[0], turn * glm::dvec3(0, 0, 1)), 12.0);
  }
}

TEST(ModelView, ARodLiesAlongTheLongerEdgeOfThePicture) {
  for (const glm::dquat& turn : kTurns)
    for (double aspect : {0.6, 1.8}) {
      Places places;
      places.add("rod", 500, turn, 400.0, isInRod);
      glm::dmat3 axes = bestSide(places.scene(), aspect);
      EXPECT_LT(degreesFrom(axes[aspect < 1.0 ? 1 : 0], turn * glm::dvec3(0, 0, 1)), 10.0) << aspect;
    }
}

TEST(ModelView, APlateFacesTheEye) {
  for (const glm::dquat& turn : kTurns) {
    Places places;
    places.add("plate", 2000, turn, 400.0, isInPlate);
    EXPECT_LT(degreesFrom(bestSide(places.scene(), 1.5)[2], turn * glm::dvec3(0, 0, 1)), 10.0);
  }
}

TEST(ModelView, ABallIsSeenObliquelyAsItLies) {
  Places places;
  places.add("envelope", 40000, kTurns[0], 700.0, isInShell);
  Scene scene = places.scene();
  Camera first = firstCamera(scene, 1.5), oblique = frameCamera(scene, StandardView::Oblique, 1.5);
  EXPECT_LT(degreesFrom(first.eye - first.target, oblique.eye - oblique.target), 15.0) << "but for chance";
  EXPECT_GT(first.up.z, 0.8);
}

TEST(ModelView, FewInstancesSayNothingOfAShape) {
  Places places;
  places.add("envelope", 6000, kTurns[0], 700.0, isInShell);
  places.add("spikes", 20, kTurns[1], 400.0, isInRod);
  Places without;
  without.add("envelope", 6000, kTurns[0], 700.0, isInShell);
  EXPECT_LT(degreesFrom(bestSide(places.scene(), 1.5)[2], bestSide(without.scene(), 1.5)[2]), 10.0);
}

TEST(ModelView, TheAxesAreThoseOfAPicture) {
  for (const glm::dquat& turn : kTurns) {
    Places places;
    places.add("capsid", 600, turn, 400.0, isInCone);
    glm::dmat3 axes = bestSide(places.scene(), 1.5), seen = glm::transpose(axes) * axes;
    for (int i = 0; i < 3; ++i) EXPECT_LT(glm::length(seen[i] - glm::dmat3(1.0)[i]), 1e-9);
    EXPECT_GT(glm::determinant(axes), 0.0) << "and no mirror image";
  }
}

TEST(ModelView, AllOfAModelIsInItsFirstPicture) {
  for (const glm::dquat& turn : kTurns) {
    Places places;
    places.add("capsid", 600, turn, 400.0, isInCone);
    Scene scene = places.scene();
    Camera camera = firstCamera(scene, 1.5);
    glm::dvec3 toEye = glm::normalize(camera.eye - camera.target), right = glm::cross(camera.up, toEye);
    double tangent = std::tan(glm::radians(camera.fieldOfViewDeg) / 2), most = 0.0;
    for (const Instance& one : scene.model.data->instances) {
      glm::dvec3 off = glm::dvec3(one.position) - camera.eye;
      double depth = -glm::dot(off, toEye) * tangent;
      most = std::max({most, std::abs(glm::dot(off, camera.up)) / depth, std::abs(glm::dot(off, right)) / depth / 1.5});
    }
    EXPECT_LT(most, 1.0);
    EXPECT_GT(most, 0.8) << "and fills it";
  }
}

}  // namespace
}  // namespace velum::scene
