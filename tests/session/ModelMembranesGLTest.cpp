// Membranes over a model: kernels where instances of protected types are dense, which stay whole or go whole.
#include <random>

#include "GlFixture.h"
#include "core/Error.h"
#include "core/ModelBuilder.h"
#include "membrane/forces/Kernels.h"
#include "render/kept/KeptInstances.h"
#include "scene/TypesFromLabels.h"
#include "session/cut/CutEdit.h"
#include "session/membrane/DefaultField.h"
#include "session/membrane/MembraneEdit.h"
#include "session/membrane/Membranes.h"

namespace velum::session {

namespace {

constexpr float kShell = 120.0f, kHalfEdge = 400.0f;

/// A ball of 26 angstrom as a molecule of a type.
std::uint32_t addKind(ModelBuilder& builder, const std::vector<std::string>& path, const char* name) {
  MoleculeType type;
  type.name = name;
  type.compartment = builder.compartment(path);
  return builder.addMolecule(builder.addType(type), {}, {{glm::vec4(0, 0, 0, 13)}});
}

/// A closed shell of molecules about the origin, in plasma.
Model shellInPlasma() {
  ModelBuilder builder("shell");
  std::uint32_t shell = addKind(builder, {"capsid"}, "CA"), plasma = addKind(builder, {"plasma"}, "albumin");
  for (int i = 0; i < 500; ++i) {
    float z = 1.0f - 2.0f * (float(i) + 0.5f) / 500.0f, turn = 2.39996323f * float(i);
    glm::vec2 flat = std::sqrt(1.0f - z * z) * glm::vec2(std::cos(turn), std::sin(turn));
    builder.addInstance(shell, kShell * glm::vec3(flat, z), glm::quat(1, 0, 0, 0));
  }
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(-kHalfEdge, kHalfEdge);
  for (int i = 0; i < 3000;) {
    glm::vec3 at(unit(random), unit(random), unit(random));
    if (glm::length(at) < kShell + 30.0f) continue;
    builder.addInstance(plasma, at, glm::quat(1, 0, 0, 0));
    ++i;
  }
  return builder.build();
}

class ModelMembranesGL : public GlTest {
 protected:
  /// Seen from above, so that what is above the middle is removed, as far as the sheet hangs flat.
  static scene::Scene sceneOfShell(LengthUnit unit = LengthUnit::Angstrom) {
    scene::Scene scene;
    scene.unit = unit;
    scene.model.data = Shared<Model>(shellInPlasma());
    scene.camera.eye = {0, 0, 1e4};
    scene.cuts = {makeCut(scene, scene::CutShape::Membrane)};
    scene.cuts[0].centre = glm::dvec3(0.0);
    scene.cuts[0].size.z = 420.0 * unitsPer(LengthUnit::Angstrom, unit);
    return scene;
  }
  /// Shares of a type's instances that the scene's cuts leave.
  static double keptShare(const scene::Scene& scene, const char* name) {
    const Model& model = *scene.model.data;
    std::vector<std::uint8_t> kept = render::keptInstances(scene);
    for (const MoleculeType& type : model.types) {
      auto first = kept.begin() + type.firstInstance;
      if (type.name == name)
        return double(std::count(first, first + type.instanceCount, 1)) / double(type.instanceCount);
    }
    return -1.0;
  }
  inline static Progress sProgress;
};

TEST_F(ModelMembranesGL, WhatIsProtectedStaysWholeWhereAPlaneWouldHalveIt) {
  for (auto unit : {LengthUnit::Angstrom, LengthUnit::Millimetre}) {
    scene::Scene scene = sceneOfShell(unit);
    EXPECT_NEAR(keptShare(scene, "CA"), 0.5, 0.05) << "a flat sheet halves it";
    for (const auto& type : protectableTypes(*scene.model.data, "capsid")) protectType(*scene.cuts[0].membrane, type);
    auto report = settleMembranes(scene, {true, false}, sProgress).at(0);
    EXPECT_TRUE(report.atRest);
    EXPECT_GT(report.kernels, 100u);
    EXPECT_EQ(keptShare(scene, "CA"), 1.0);
    EXPECT_EQ(report.kept->cutAreaMembrane, 0);
    EXPECT_GT(report.kept->cutAreaPlane, 20);
    // The sheet goes around the shell, not away from everything.
    EXPECT_NEAR(keptShare(scene, "albumin"), 0.5, 0.06);
  }
}

TEST_F(ModelMembranesGL, OrGoesWholeWhereThatIsAskedFor) {
  scene::Scene scene = sceneOfShell();
  protectType(*scene.cuts[0].membrane, protectableTypes(*scene.model.data, "capsid.CA").at(0));
  scene.cuts[0].membrane->field.side = scene::MembraneSide::Remove;
  settleMembranes(scene, {}, sProgress);
  EXPECT_EQ(keptShare(scene, "CA"), 0.0);
  EXPECT_NEAR(keptShare(scene, "albumin"), 0.5, 0.06);
}

TEST_F(ModelMembranesGL, ANewOneProtectsTheCompartmentThatIsNotEverywhere) {
  scene::Scene scene = sceneOfShell();
  scene::ForceField field = defaultField(scene);
  EXPECT_EQ(field.byType, (std::vector<scene::TypeStrength>{{"root.capsid.CA", kProtectStrength}}));
}

TEST_F(ModelMembranesGL, CopiesAreProtectedEachWhereItStands) {
  scene::Scene scene = sceneOfShell();
  scene.model.copies = 2;  // side by side along x
  scene.cuts[0].size.x = 4.0 * kHalfEdge;
  scene.cuts[0].size.y = 2.0 * kHalfEdge;
  scene.cuts[0].centre.x = 0.5 * scene::copyGrid(scene.model).step.x;
  protectType(*scene.cuts[0].membrane, protectableTypes(*scene.model.data, "CA").at(0));
  settleMembranes(scene, {}, sProgress);
  std::vector<std::uint8_t> kept = render::keptInstances(scene);
  std::size_t count = scene.model.data->instances.size();
  ASSERT_EQ(kept.size(), 2 * count);
  for (std::size_t copy : {0, 1})
    for (std::size_t i = 0; i < 500; ++i) ASSERT_TRUE(kept[copy * count + i]) << copy << ", " << i;
}

/// A grey volume, in which nothing stands out, with an edge of `voxels` voxels about the origin.
Volume greyVolume(int voxels, double edge) {
  Volume volume;
  volume.dims = glm::ivec3(voxels);
  volume.worldFromVoxel = glm::dmat4(edge / voxels);
  volume.worldFromVoxel[3] = glm::dvec4(glm::dvec3(0.5 * edge / voxels - 0.5 * edge), 1.0);
  volume.lengthUnit = LengthUnit::Angstrom;
  volume.voxels.assign(voxelCount(volume), std::byte(80));
  return volume;
}

// A shell that is thinner than a voxel is protected without gaps.
TEST_F(ModelMembranesGL, TypesAreProtectedInAVolumeOfCoarseVoxels) {
  scene::Scene scene = sceneOfShell();
  scene.volume.data = Shared<Volume>(greyVolume(28, 2.4 * kHalfEdge));
  protectType(*scene.cuts[0].membrane, "root.capsid.CA");
  auto report = settleMembranes(scene, {true, false}, sProgress).at(0);
  EXPECT_GT(keptShare(scene, "CA"), 0.95) << "it reaches out of its voxels by less than one";
  EXPECT_EQ(report.kept->cutAreaMembrane, 0);
}

// The volume holds the model, or only its middle: then there are voxels around the volume, in which the model's types
// are protected as well.
TEST_F(ModelMembranesGL, TypesAreProtectedBesideAVolume) {
  for (double edge : {2.4 * kHalfEdge, 1.2 * kShell}) {
    scene::Scene scene = sceneOfShell();
    scene.volume.data = Shared<Volume>(greyVolume(edge > kHalfEdge ? 100 : 40, edge));
    EXPECT_NEAR(keptShare(scene, "CA"), 0.5, 0.05) << "a flat sheet halves it";
    expectModelInReach(scene);
    protectType(*scene.cuts[0].membrane, "root.capsid.CA");
    auto report = settleMembranes(scene, {true, false}, sProgress).at(0);
    EXPECT_TRUE(report.atRest);
    EXPECT_EQ(keptShare(scene, "CA"), 1.0) << edge;
    EXPECT_EQ(report.kept->cutAreaMembrane, 0);
    EXPECT_NEAR(keptShare(scene, "albumin"), 0.5, 0.06);
  }
}

TEST_F(ModelMembranesGL, WhatIsProtectedByValueStaysSoWhereAModelReachesOutOfTheVolume) {
  scene::Scene alone = sceneOfShell();
  Volume volume = greyVolume(40, kShell);
  for (std::size_t i = 0; i < volume.voxels.size(); ++i) volume.voxels[i] = std::byte(i * 2654435761u >> 24);
  alone.volume.data = Shared<Volume>(std::move(volume));
  scene::Scene beside = alone;
  alone.model = {};
  scene::ForceField field;
  field.byValue = {{100, 0}, {120, 50}, {200, 90}};
  field.leastPiece = 1;
  membrane::Potential own(alone), wide(beside);
  glm::ivec3 from(glm::round(glm::dvec3(glm::inverse(wide.worldFromVoxel()) * own.worldFromVoxel()[3])));
  ASSERT_TRUE(glm::all(glm::greaterThan(from, glm::ivec3(0))));
  EXPECT_EQ(wide.computeStrengths(field, {from, from + own.dims()}, sProgress),
            own.computeStrengths(field, {glm::ivec3(0), own.dims()}, sProgress));
  auto whole = wide.computeStrengths(field, {glm::ivec3(0), wide.dims()}, sProgress);
  auto inner = own.computeStrengths(field, {glm::ivec3(0), own.dims()}, sProgress);
  auto some = [](float strength) { return strength != 0.0f; };
  EXPECT_EQ(std::count_if(whole.begin(), whole.end(), some), std::count_if(inner.begin(), inner.end(), some));
}

TEST_F(ModelMembranesGL, AModelOfAnotherScaleThanTheVolumeIsToBeBroughtToSizeFirst) {
  scene::Scene scene = sceneOfShell();
  scene.volume.data = Shared<Volume>(greyVolume(200, 4.0));
  EXPECT_THROW(expectModelInReach(scene), ArgumentError);
  scene.volume.data = Shared<Volume>(greyVolume(50, 1e6));
  EXPECT_THROW(expectModelInReach(scene), ArgumentError);
  scene.model = {};
  EXPECT_THROW(expectModelInReach(scene), ArgumentError);
}

// Scenes were written so while types could be protected of a model that is alone.
TEST_F(ModelMembranesGL, TypesThatWereLabelsBecomeTypes) {
  scene::Scene scene = sceneOfShell();
  scene.cuts[0].membrane->field.byLabel = {{2, 70}, {9, 10}};
  scene::typesFromLabels(scene);
  EXPECT_TRUE(scene.cuts[0].membrane->field.byLabel.empty());
  EXPECT_EQ(scene.cuts[0].membrane->field.byType, (std::vector<scene::TypeStrength>{{"root.plasma.albumin", 70}}));
}

TEST_F(ModelMembranesGL, OfTwoStrengthsThatLeadToATypeTheNearerOneCounts) {
  scene::Membrane membrane;
  membrane.field.byType = {{"root.capsid.CA", 0}, {"root", 40}, {"root.cap", 9}, {"root.capsid", 60}};
  EXPECT_EQ(scene::strengthOf(membrane.field, "root.capsid.CA"), 0.0);
  EXPECT_EQ(scene::strengthOf(membrane.field, "root.capsid.MA"), 60.0);
  EXPECT_EQ(scene::strengthOf(membrane.field, "root.plasma.albumin"), 40.0);
  EXPECT_EQ(scene::strengthOf(membrane.field, "other"), 0.0);
  protectType(membrane, "root.capsid.MA", 0.0);
  EXPECT_EQ(scene::strengthOf(membrane.field, "root.capsid.MA"), 0.0);
  protectType(membrane, "root.capsid.MA", 60.0);
  EXPECT_EQ(membrane.field.byType.size(), 4u) << "what the compartment says need not be said again";
}

TEST_F(ModelMembranesGL, TypesAreFoundByWholeNames) {
  Model model = shellInPlasma();
  using Paths = std::vector<std::string>;
  EXPECT_EQ(protectableTypes(model, "root.capsid"), Paths{"root.capsid.CA"});
  EXPECT_EQ(protectableTypes(model, "root"), (Paths{"root.capsid.CA", "root.plasma.albumin"}));
  EXPECT_TRUE(protectableTypes(model, "caps").empty());
  EXPECT_TRUE(protectableTypes(model, "").empty());
}

}  // namespace

}  // namespace velum::session
