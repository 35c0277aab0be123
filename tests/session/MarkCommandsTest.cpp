// Marks are added, hidden, copied and removed by commands, and lettering takes a style by its name.
#include "session/command/MarkCommands.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/Error.h"
#include "scene/PlateStyles.h"
#include "session/command/Command.h"
#include "session/document/Document.h"

namespace velum::session {
namespace {

class MarkCommand : public testing::Test {
 protected:
  void SetUp() override {
    scene::Scene scene;
    scene.labels.structures = {{.id = 4, .name = "heart"}, {.id = 7, .name = "left kidney"}};
    mDocument.replace(scene);
  }
  void run(const std::string& line) { edit(mDocument, parseCall(line)); }
  std::string whyNot(const std::string& line) {
    scene::Scene before = mDocument.scene();
    try {
      run(line);
    } catch (const ArgumentError& error) {
      EXPECT_TRUE(mDocument.scene() == before) << line;
      EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos);
      return error.what();
    }
    ADD_FAILURE() << line;
    return {};
  }
  const std::vector<scene::Mark>& marks() { return mDocument.scene().lettering.marks; }
  Document mDocument;
};

TEST_F(MarkCommand, PlacesAreTypedWithSemicolonsBetweenThem) {
  run("mark.add angle 1,2,3;4,5,6;7,8,9.5");
  ASSERT_EQ(marks().size(), 1u);
  EXPECT_EQ(marks()[0].kind, scene::MarkKind::Angle);
  EXPECT_EQ(marks()[0].points, (std::vector<glm::dvec3>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9.5}}));
  EXPECT_EQ(mDocument.undoLabel(), "Add angle");
  run("mark.add label 1,2,3 \"Two words; and, more\"");
  EXPECT_EQ(marks()[1].points, (std::vector<glm::dvec3>{{1, 2, 3}})) << "a place stands for a list of one";
  EXPECT_EQ(marks()[1].text, "Two words; and, more");
  run("set lettering.marks[#1].points 0,0,0;0,0,1;0,1,0");
  EXPECT_EQ(marks()[0].points[2], glm::dvec3(0, 1, 0));
}

TEST_F(MarkCommand, TheLineThatAHandLeavesMakesTheMarkAgain) {
  AddMark add{scene::MarkKind::Path, {{0.1, 1.0 / 3.0, -2e-7}, {1e5, 0, 0}, {2, 2, 2}}, "Say \"when\"\nnow"};
  edit(mDocument, add);
  scene::Mark first = marks()[0];
  run(mDocument.lastCommandLines().back());
  ASSERT_EQ(marks().size(), 2u);
  EXPECT_EQ(marks()[1].id, 2);
  first.id = 2;
  EXPECT_EQ(marks()[1], first);
}

TEST_F(MarkCommand, ANameIsOfAStructureByNameOrNumber) {
  run("mark.add name structure=heart");
  run("mark.add name 1,2,3 structure=7");
  run("mark.add region structure=\"left kidney\"");
  ASSERT_EQ(marks().size(), 3u);
  EXPECT_EQ(marks()[0].structure, 4);
  EXPECT_EQ(marks()[1].structure, 7);
  EXPECT_EQ(marks()[2].structure, 7);
  EXPECT_NE(whyNot("mark.add name structure=hart").find("heart"), std::string::npos);
  EXPECT_NE(whyNot("mark.add name 1,2,3").find("structure=NAME"), std::string::npos);
  EXPECT_NE(whyNot("mark.add region").find("structure=NAME"), std::string::npos);
  whyNot("mark.add name type=root.capsid");
}

TEST_F(MarkCommand, TooFewAndTooManyPointsAreRefused) {
  EXPECT_NE(whyNot("mark.add angle 1,2,3;4,5,6").find("3 points, not 2"), std::string::npos);
  EXPECT_NE(whyNot("mark.add distance 1,2,3").find("2 points, not 1"), std::string::npos);
  EXPECT_NE(whyNot("mark.add area 1,2,3").find("3 to 1000"), std::string::npos);
  whyNot("mark.remove 1");
  whyNot("mark.duplicate 3");
}

TEST_F(MarkCommand, CopiesHaveIdsOfTheirOwnAndGoAlone) {
  run("mark.add distance 0,0,0;1,0,0");
  run("mark.add arrow 0,0,0;0,1,0");
  run("mark.duplicate 1,2");
  ASSERT_EQ(marks().size(), 4u);
  EXPECT_EQ(marks()[2].id, 3);
  EXPECT_EQ(marks()[3].id, 4);
  EXPECT_EQ(marks()[3].kind, scene::MarkKind::Arrow);
  EXPECT_EQ(mDocument.undoLabel(), "Duplicate 2 marks");
  run("mark.show 1,#4 false");
  EXPECT_FALSE(marks()[0].visible);
  EXPECT_TRUE(marks()[1].visible);
  EXPECT_FALSE(marks()[3].visible);
  run("mark.remove 1,3");
  ASSERT_EQ(marks().size(), 2u);
  EXPECT_EQ(marks()[0].id, 2);
  EXPECT_EQ(marks()[1].id, 4);
  run("mark.remove 4");
  EXPECT_EQ(mDocument.undoLabel(), "Remove arrow");
}

TEST_F(MarkCommand, AStyleIsKnownAgainWhateverTheWidthOfItsPage) {
  EXPECT_EQ(scene::plateStyleName(mDocument.scene().lettering), "screen");
  for (const scene::PlateStyle& style : scene::plateStyles()) {
    run(fmt::format("lettering.style {}", style.name));
    EXPECT_EQ(scene::plateStyleName(mDocument.scene().lettering), style.name);
    EXPECT_EQ(mDocument.scene().lettering.pageWidth > 0.0, style.name != "screen");
  }
  run("lettering.style screen");
  run("lettering.style journal");
  EXPECT_EQ(mDocument.scene().lettering.pageWidth, 174.0);
  run("set lettering.pageWidth 85");
  EXPECT_EQ(scene::plateStyleName(mDocument.scene().lettering), "journal");
  run("lettering.style atlas");
  EXPECT_EQ(mDocument.scene().lettering.pageWidth, 85.0) << "the page stays";
  run("set lettering.bold true");
  EXPECT_EQ(scene::plateStyleName(mDocument.scene().lettering), "") << "of nobody's table";
  EXPECT_NE(whyNot("lettering.style jornal").find("journal"), std::string::npos);
}

}  // namespace
}  // namespace velum::session
