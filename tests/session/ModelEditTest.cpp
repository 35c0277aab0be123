#include "session/model/ModelEdit.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/Error.h"
#include "core/Units.h"
#include "makeModel.h"
#include "scene/json/Json.h"
#include "session/command/Command.h"
#include "session/command/LetteringCommands.h"
#include "session/command/ModelCommands.h"
#include "session/cut/CutEdit.h"
#include "session/document/Document.h"
#include "session/picture/ModelPictures.h"
#include "session/section/InstanceOutlines.h"

namespace velum::session {

namespace {

scene::Scene modelScene(ModelMaker maker = {.types = 5}) {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(maker.make());
  return scene;
}

std::string path(const scene::Scene& scene, std::uint32_t type) {
  return pathOf(*scene.model.data, scene.model.data->types[type]);
}

}  // namespace

TEST(ModelEdit, ANameIsSavedAndTheFilesComesBackWithUndoAndWithNone) {
  Document document;
  document.replace(modelScene());
  std::string type = path(document.scene(), 2);
  edit(document, RenameType{type, "  Capsid\n protein "});
  edit(document, RenameType{"root.a", "Inside"});
  EXPECT_EQ(scene::shownName(document.scene().model, type, "type2"), "Capsid protein");
  EXPECT_EQ(nameAt(document.scene(), "root.a"), "Inside");
  EXPECT_EQ(document.undoLabel(), "Rename a to Inside");
  scene::Scene read = scene::fromJson(scene::toJson(document.scene()));
  EXPECT_EQ(read.model.types, document.scene().model.types);
  EXPECT_EQ(scene::ownName(read.model, type), "Capsid protein");
  EXPECT_EQ(visibleTypes(document.scene().model), std::vector<bool>(5, true)) << "a name changes no look";
  resetTypes(read, {2});
  EXPECT_EQ(scene::ownName(read.model, type), "Capsid protein");
  edit(document, RenameType{type, ""});
  EXPECT_EQ(scene::shownName(document.scene().model, type, "[type_2](https://x)"), "type 2");
  EXPECT_EQ(document.scene().model.types.size(), 1u) << "an entry that says nothing is none";
  document.undo();
  EXPECT_EQ(nameAt(document.scene(), type), "Capsid protein");
  EXPECT_THROW(edit(document, RenameType{"root.a.typo2", "x"}), ArgumentError);
}

TEST(ModelEdit, NamesAndLetteringChangeNoPictureOfTheDataAlone) {
  scene::Scene scene = modelScene(), before = scene;
  rename(scene, path(scene, 1), "x");
  rename(scene, "root.b", "y");
  scene.lettering.legend = scene.lettering.scaleBar = true;
  EXPECT_EQ(scene::pictureScene(scene), scene::pictureScene(before));
}

TEST(ModelEdit, WhatIsHiddenAndShownAgainLeavesNoTrace) {
  scene::Scene scene = modelScene();
  scene::Scene before = scene;
  setTypesVisible(scene, {1, 3, 99}, false);
  EXPECT_EQ(visibleTypes(scene.model), (std::vector<bool>{true, false, true, false, true}));
  EXPECT_EQ(scene.model.types.size(), 2u);
  setTypesVisible(scene, {3, 1}, true);
  EXPECT_EQ(scene, before);
}

TEST(ModelEdit, AColourStaysWhenTheTypeIsHiddenAndGoesWithAReset) {
  scene::Scene scene = modelScene();
  setTypesColor(scene, {2}, glm::vec3(1, 0, 0));
  setTypesVisible(scene, {2}, false);
  setTypesVisible(scene, {2}, true);
  EXPECT_EQ(scene::typeColors(scene.model)[2], glm::vec3(1, 0, 0));
  EXPECT_TRUE(ownColors(scene.model)[2]);
  resetTypes(scene, {2});
  EXPECT_TRUE(scene.model.types.empty());
}

TEST(ModelEdit, EntriesOfTypesThatTheModelLacksStay) {
  scene::Scene scene = modelScene();
  scene.model.types.push_back({.type = "root.elsewhere", .visible = false});
  setTypesVisible(scene, {0}, false);
  resetTypes(scene, {0, 1, 2, 3, 4});
  ASSERT_EQ(scene.model.types.size(), 1u);
  EXPECT_EQ(scene.model.types[0].type, "root.elsewhere");
}

TEST(ModelEdit, ACompartmentHasTheTypesBelowIt) {
  scene::Scene scene = modelScene();
  const Model& model = *scene.model.data;
  EXPECT_EQ(typesBelow(model, 0), (TypeNumbers{0, 1, 2, 3, 4}));
  std::uint32_t a = model.types[0].compartment;
  EXPECT_EQ(typesBelow(model, a), (TypeNumbers{0, 2, 4}));
  EXPECT_EQ(compartmentPath(model, a) + "." + model.types[0].name, path(scene, 0));
}

TEST(ModelEdit, SoloGoesFromOneToAnotherAndBackToWhatWasShown) {
  scene::Scene scene = modelScene();
  setTypesVisible(scene, {4}, false);
  scene::Scene before = scene;
  TypeSoloMemory memory = toggleSoloTypes(scene, {}, {1});
  EXPECT_TRUE(isSolo(scene, {1}));
  memory = toggleSoloTypes(scene, memory, {2, 0});
  EXPECT_TRUE(isSolo(scene, {0, 2}));
  toggleSoloTypes(scene, memory, {0, 2});
  EXPECT_EQ(visibleTypes(scene.model), visibleTypes(before.model));
}

TEST(ModelEdit, SoloFromAFileEndsWithAllShown) {
  scene::Scene scene = modelScene();
  setTypesVisible(scene, {0, 1, 2, 3}, false);
  toggleSoloTypes(scene, {}, {4});
  EXPECT_TRUE(scene.model.types.empty());
}

TEST(ModelEdit, StepsAreNamedAfterTheTypeOrTheirNumber) {
  scene::Scene scene = modelScene();
  EXPECT_EQ(typesLabel(scene, "Hide", {3}), "Hide type3");
  EXPECT_EQ(typesLabel(scene, "Hide", {3, 1}), "Hide 2 types");
}

TEST(ModelEdit, AnInstanceOfACopyStandsOneStepFurther) {
  scene::Scene scene = modelScene();
  scene.model.copies = 2;
  auto count = std::uint32_t(scene.model.data->instances.size());
  auto first = instancePlace(scene, 7), second = instancePlace(scene, 7 + count);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(second->copy, 1u);
  EXPECT_EQ(first->type, second->type);
  EXPECT_NEAR(glm::distance(second->middle - first->middle, glm::dvec3(scene::copyGrid(scene.model).step.x, 0, 0)), 0.0,
              1e-9);
  EXPECT_FALSE(instancePlace(scene, 2 * count));
  scene.unit = LengthUnit::Millimetre;
  EXPECT_NEAR(instancePlace(scene, 7)->radius, first->radius * unitsPer(LengthUnit::Angstrom, scene.unit), 1e-15);
}

TEST(ModelEdit, TheBallAroundTypesHoldsAllOfTheirInstancesInAllCopies) {
  scene::Scene scene = modelScene();
  for (auto unit : {LengthUnit::Angstrom, LengthUnit::Millimetre})
    for (int copies : {1, 2, 7})
      for (const TypeNumbers& types : {TypeNumbers{3}, TypeNumbers{0, 4}}) {
        scene.unit = unit;
        scene.model.copies = copies;
        InstancePlace ball = ballAround(scene, types);
        ASSERT_GT(ball.radius, 0.0);
        double reach = 0.0, all = double(copies) * double(scene.model.data->instances.size());
        for (std::uint32_t i = 0; double(i) < all; ++i) {
          InstancePlace place = instancePlace(scene, i).value();
          if (std::find(types.begin(), types.end(), place.type) != types.end())
            reach = std::max(reach, glm::distance(place.middle, ball.middle) + place.radius);
        }
        // With seven copies in blocks of eight there is room for one more.
        EXPECT_LT(reach, ball.radius * (1.0 + 1e-6)) << copies;
        EXPECT_GT(reach, 0.75 * ball.radius) << copies;
      }
  EXPECT_EQ(ballAround(scene, {}).radius, 0.0);
}

TEST(ModelEdit, ASmallPictureHasTheMiddleWithEveryTypeInItsPlace) {
  scene::Scene scene = modelScene({.types = 4, .instances = 400});
  Shared<Model> small = middleOfModel(scene.model.data, 100);
  EXPECT_EQ(small->instances.size(), 100u);
  ASSERT_EQ(small->types.size(), 4u);
  std::uint32_t sum = 0;
  for (const MoleculeType& type : small->types) {
    EXPECT_EQ(type.firstInstance, sum);
    for (std::uint32_t i = 0; i < type.instanceCount; ++i)
      EXPECT_EQ(&small->types[small->molecules[small->instances[sum + i].molecule].type], &type);
    sum += type.instanceCount;
  }
  EXPECT_EQ(sum, 100u);
  EXPECT_EQ(middleOfModel(scene.model.data, 400).id(), scene.model.data.id());
}

TEST(TypeSpares, TheNearestAboveHoldsUntilThereIsOneOfItsOwn) {
  scene::Cut cut;
  EXPECT_EQ(typeSpareFor(cut, "root.a.x").share, 0.0);
  setTypeShare(cut, "root", 0.5);
  cut.model.spares[0].falloff = 20.0;
  EXPECT_EQ(typeSpareFor(cut, "root.a.x").share, 0.5);
  setTypeShare(cut, "root.a", 0.25);
  EXPECT_EQ(typeSpareFor(cut, "root.a.x").share, 0.25);
  EXPECT_EQ(typeSpareFor(cut, "root.a.x").falloff, 20.0) << "a new row begins with what held before";
  EXPECT_EQ(typeSpareFor(cut, "root.ab").share, 0.5) << "a path is no prefix of letters";
  removeTypeSpare(cut, "root.a");
  EXPECT_EQ(typeSpareFor(cut, "root.a.x").share, 0.5);
  EXPECT_EQ(cut.model.spares.size(), 1u);
  setTypeShare(cut, "root", 7.0);
  EXPECT_EQ(cut.model.spares[0].share, 1.0);
}

TEST(TypeSpares, ACommandSetsAnyOfTheirFieldsOfTheTypesThatItNames) {
  Document document;
  scene::Scene scene = modelScene();
  scene::addCut(scene, {});
  document.replace(scene);
  std::string first = path(scene, 0), second = path(scene, 1);
  edit(document, LeaveTypesBy{{first, second}, "falloff", "20", ""});
  edit(document, parseCall("model.leaveBy " + first + " share 0.25"));
  const scene::Cut& cut = document.scene().cuts[0];
  EXPECT_EQ(typeSpareFor(cut, first).falloff, 20.0);
  EXPECT_EQ(typeSpareFor(cut, second).falloff, 20.0);
  EXPECT_EQ(typeSpareFor(cut, first).share, 0.25);
  EXPECT_EQ(typeSpareFor(cut, second).share, 0.0);
  for (const char* wrong : {"model.leaveBy root type x", "model.leaveBy root shared 1", "model.leaveBy root share 2",
                            "model.leaveBy rood share 1"})
    EXPECT_THROW(edit(document, parseCall(wrong)), ArgumentError) << wrong;
}

TEST(InstanceOutlines, AreTheCirclesOfThoseThatThePlaneMeets) {
  scene::Scene scene = modelScene();
  scene::SectionPlane plane;
  plane.size = {400, 400};
  plane.lengthPerPixel = 1.0;
  const Model& model = *scene.model.data;
  std::size_t expected = 0;
  for (const Instance& one : model.instances) {
    const Molecule& molecule = model.molecules[one.molecule];
    double z = (one.rotation * molecule.centre + one.position).z;
    expected += std::abs(z) < std::sqrt(double(molecule.radius) * molecule.radius - 0.35 * 0.35);
  }
  InstanceOutlines all = outlineInstances(scene, plane, 1000000);
  EXPECT_NEAR(double(all.circles.size()), double(expected), 2.0);  // some are beside the view
  EXPECT_GT(all.circles.size(), 5u);
  EXPECT_EQ(all.missing, 0u);
  InstanceOutlines few = outlineInstances(scene, plane, 5);
  EXPECT_EQ(few.circles.size(), 5u);
  EXPECT_EQ(few.missing, all.circles.size() - 5);
  setTypesVisible(scene, {0, 1, 2, 3, 4}, false);
  EXPECT_TRUE(outlineInstances(scene, plane, 1000000).circles.empty());
}

TEST(InstanceOutlines, AreTheSameInScenesOfAnotherUnit) {
  scene::Scene scene = modelScene();
  scene.model.copies = 3;
  scene::SectionPlane plane;
  plane.size = {400, 400};
  auto circlesIn = [&](LengthUnit unit) {
    scene.unit = unit;
    plane.lengthPerPixel = unitsPer(LengthUnit::Angstrom, unit);
    return outlineInstances(scene, plane, 1000000).circles;
  };
  auto wanted = circlesIn(LengthUnit::Angstrom), found = circlesIn(LengthUnit::Millimetre);
  ASSERT_EQ(found.size(), wanted.size());
  EXPECT_GT(wanted.size(), 5u);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_LT(glm::distance(found[i].middle, wanted[i].middle), 1e-6);
    EXPECT_NEAR(found[i].radius, wanted[i].radius, 1e-6);
  }
}

/// By commands, each one step that undo takes back.
TEST(ModelEdit, SoloComesBackToWhatIsSaidToHaveBeenShown) {
  Document document;
  document.replace(modelScene());
  const scene::Scene& scene = document.scene();
  edit(document, ShowTypes{{path(scene, 3)}, false});
  scene::Scene before = scene;
  std::vector<std::string> shown = typeNames(before, {0, 1, 2, 4});
  edit(document, SoloTypes{{path(scene, 1)}, {}});
  EXPECT_EQ(visibleTypes(scene.model), (std::vector<bool>{false, true, false, false, false}));
  edit(document, SoloTypes{{path(scene, 1)}, shown});
  EXPECT_EQ(visibleTypes(scene.model), (std::vector<bool>{true, true, true, false, true}));
  EXPECT_EQ(document.undoLabels().front().find("End solo of"), 0u);
  document.undo();
  document.undo();
  EXPECT_EQ(scene, before);
}

TEST(ModelEdit, WhatIsLeftAsAboveHasNoRowOfItsOwnAndTypesAreProtectedByTheirPaths) {
  Document document;
  scene::Scene start = modelScene();
  scene::Cut sheet;
  sheet.shape = scene::CutShape::Membrane;
  scene::addCut(start, sheet);
  scene::completeItems(start);
  document.replace(start);
  edit(document, LeaveTypes{{path(start, 2)}, 0.5, ""});
  EXPECT_NE(findTypeSpare(document.scene().cuts[0], path(start, 2)), nullptr);
  edit(document, LeaveAsAbove{{path(start, 2)}, ""});
  EXPECT_EQ(findTypeSpare(document.scene().cuts[0], path(start, 2)), nullptr);
  edit(document, ProtectTypes{{path(start, 2)}, 60.0, ""});
  EXPECT_EQ(document.scene().cuts[0].membrane->field.byType,
            (std::vector<scene::TypeStrength>{{path(start, 2), 60.0}}));
  EXPECT_THROW(edit(document, parseCall("model.meetTargets")), ArgumentError) << "no number is wanted";
  EXPECT_THROW(edit(document, parseCall("model.letSee root.nothing 3")), ArgumentError);
}

}  // namespace velum::session
