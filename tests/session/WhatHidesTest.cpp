#include "session/model/WhatHides.h"

#include <gtest/gtest.h>

#include <set>

#include "core/Error.h"
#include "makeModel.h"
#include "render/kept/KeptInstances.h"
#include "scene/Navigate.h"
#include "scene/Scene.h"
#include "session/cut/CutEdit.h"
#include "session/model/CountFiles.h"
#include "session/model/ModelEdit.h"

namespace velum::session {

namespace {

scene::Scene modelScene() {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(ModelMaker{.types = 4, .atoms = 8, .instances = 40}.make());
  return scene;
}

/// So many that some are cleared out of the view of the first type, and some are not.
scene::Scene crowdedScene() {
  scene::Scene scene = modelScene();
  scene.model.data = Shared<Model>(ModelMaker{.types = 4, .atoms = 8, .instances = 800}.make());
  scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, 1.0);
  clearTheWay(scene, "type0");
  return scene;
}

/// A row of pixels. @param types  -1: nothing
Image pixels(const std::vector<int>& types) {
  Image image{int(types.size()), 1, {"R", "instance", "type"}, {}};
  for (int type : types) image.pixels.insert(image.pixels.end(), {0.0f, type < 0 ? -1.0f : 1.0f, float(type)});
  return image;
}

}  // namespace

TEST(WhatHides, CountsWhoHasThePixels) {
  scene::Scene scene = modelScene();
  Image alone = pixels({1, 1, 1, 1, 1, 1, 1, 1, -1, -1}), whole = pixels({1, 1, 2, 2, 2, 0, 0, -1, 3, 3});
  Hiding hiding = whatHides(scene, "type1", alone, whole);
  EXPECT_EQ(hiding.path, "root.b.type1");
  EXPECT_EQ(hiding.pixels, 8u);
  EXPECT_EQ(hiding.seen, 2u);
  ASSERT_EQ(hiding.hiders.size(), 3u);
  EXPECT_EQ(hiding.hiders[0].path, "root.a.type2");
  EXPECT_EQ(hiding.hiders[0].pixels, 3u);
  EXPECT_DOUBLE_EQ(hiding.hiders[0].share, 3.0 / 8.0);
  EXPECT_EQ(hiding.hiders[2].path, "");
  EXPECT_EQ(hiding.words, "75 % of type1 is hidden: 38 % by type2, 25 % by type0, 12 % by what is no model");
  EXPECT_EQ(whatHides(scene, "type1", alone, alone).words, "nothing hides type1");
  EXPECT_EQ(whatHides(scene, "type1", pixels({-1}), pixels({2})).words,
            "type1 is not drawn, or outside of the picture");
}

TEST(WhatHides, TheTypeStandsAlone) {
  scene::Scene scene = modelScene();
  scene.surfaces.emplace_back();
  scene::Scene alone = aloneScene(scene, "root.b");
  EXPECT_EQ(visibleTypes(alone.model), (std::vector<bool>{false, true, false, true}));
  EXPECT_FALSE(alone.surfaces[0].visible);
  EXPECT_THROW(aloneScene(scene, "nobody"), InputError);
}

TEST(WhatHides, WhatIsClearedForAViewIsNotAskedForWhateverThePicturesShape) {
  scene::Scene scene = crowdedScene();
  const Model& model = *scene.model.data;
  std::set<std::uint64_t> counts;
  for (glm::ivec2 size : {glm::ivec2(40, 20), glm::ivec2(20, 40)}) {
    auto states = render::instanceStates(scene, {}, double(size.x) / size.y);
    // Each instance has a pixel of its own.
    Image alone{size.x, size.y, {"R", "instance", "type"}, {}};
    std::uint64_t wanted = 0;
    for (std::size_t i = 0; i < model.instances.size(); ++i) {
      bool isAsked = model.molecules[model.instances[i].molecule].type == 1;
      alone.pixels.insert(alone.pixels.end(), {0.0f, isAsked ? float(i + 1) : -1.0f, isAsked ? 1.0f : -1.0f});
      wanted += isAsked && states[i] != render::InstanceState::Cleared;
    }
    EXPECT_EQ(whatHides(scene, "type1", alone, alone).pixels, wanted) << size.x;
    counts.insert(wanted);
  }
  EXPECT_EQ(counts.size(), 2u) << "a wide picture shows more of what hides than a tall one";
}

TEST(WhatHides, AnInstanceIsLeftOutWhenItIsClearedAndNotItsNeighbour) {
  scene::Scene scene = crowdedScene();
  const Model& model = *scene.model.data;
  auto states = render::instanceStates(scene, {}, 1.0);
  for (std::size_t surfaces : {0, 2}) {
    scene.surfaces.resize(surfaces);
    int asked[2] = {0, 0};
    for (std::size_t i = 0; i < model.instances.size(); i += 7) {
      if (model.molecules[model.instances[i].molecule].type != 1) continue;
      Image alone{1, 1, {"R", "instance", "type"}, {0.0f, float(surfaces + i + 1), 1.0f}};
      bool isCleared = states[i] == render::InstanceState::Cleared;
      EXPECT_EQ(whatHides(scene, "type1", alone, alone).pixels, isCleared ? 0u : 1u) << i << " after " << surfaces;
      ++asked[isCleared];
    }
    EXPECT_GT(std::min(asked[0], asked[1]), 2);
  }
}

TEST(WhatHides, NothingIsClearedOfACompartmentThatHoldsTheFocusAndWhoHidesIt) {
  scene::Scene scene = modelScene();
  scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, 1.0);
  clearTheWay(scene, "type0");
  auto isCleared = [](const scene::Scene& of) {
    auto states = render::instanceStates(of);
    return std::count(states.begin(), states.end(), render::InstanceState::Cleared) > 0;
  };
  EXPECT_TRUE(isCleared(scene));
  EXPECT_FALSE(isCleared(aloneScene(scene, "root.a"))) << "all of it is seen alone";
}

TEST(ClearTheWay, AddsOneCutThatRemovesNothingElse) {
  scene::Scene scene = modelScene();
  int id = clearTheWay(scene, "type1");
  EXPECT_EQ(clearTheWay(scene, "root.a.type2"), id);
  EXPECT_EQ(clearTheWay(scene, "type1"), id);
  ASSERT_EQ(scene.cuts.size(), 1u);
  EXPECT_EQ(scene.cuts[0].shape, scene::CutShape::Everywhere);
  ASSERT_EQ(scene.cuts[0].model.focus->types.size(), 2u);
  EXPECT_EQ(scene.cuts[0].model.focus->types[0].type, "root.b.type1");
  ASSERT_EQ(scene.cuts[0].model.spares.size(), 1u);
  EXPECT_EQ(scene.cuts[0].model.spares[0].type, "root");
  EXPECT_EQ(scene.cuts[0].model.spares[0].share, 1.0);
}

TEST(ClearTheWay, EndsWithTheCutWhereThatDidNothingElse) {
  scene::Scene scene = modelScene();
  scene::addCut(scene, makeCut(scene, scene::CutShape::Sphere));
  scene::Scene before = scene;
  clearTheWay(scene, "type1");
  clearTheWay(scene, "type2");
  EXPECT_TRUE(isKeptInView(scene, "root.b.type1"));
  EXPECT_FALSE(isKeptInView(scene, "root.b.type3"));
  endKeepInView(scene, "root.b.type1");
  EXPECT_FALSE(isKeptInView(scene, "root.b.type1"));
  EXPECT_TRUE(isKeptInView(scene, "root.a.type2")) << "the other one stays";
  scene::Scene thinned = scene;
  endKeepInView(scene, "root.a.type2");
  EXPECT_EQ(scene.cuts, before.cuts) << "nothing is left of it";
  // Where it takes some of what there is it goes on with that.
  setTypeShare(thinned.cuts.back(), "root.a", 0.5);
  endKeepInView(thinned, "root.a.type2");
  ASSERT_EQ(thinned.cuts.size(), 2u);
  EXPECT_FALSE(thinned.cuts.back().model.focus);
  // A cut with a shape cuts without a focus, too.
  scene.cuts[0].model.focus.emplace().types = {{"root.b"}};
  EXPECT_TRUE(isKeptInView(scene, "root.b"));
  scene.cuts[0].enabled = false;
  EXPECT_FALSE(isKeptInView(scene, "root.b")) << "a cut that is off keeps nothing";
  endKeepInView(scene, "root.b");
  ASSERT_EQ(scene.cuts.size(), 1u);
  EXPECT_FALSE(scene.cuts[0].model.focus);
}

TEST(CountFiles, RowsAreTheTreeAndCompartmentsTheSumsOfIt) {
  scene::Scene scene = modelScene();
  std::vector<Counts> types{{1, 2, 7}, {0, 0, 10}, {10, 0, 0}, {3, 3, 4}};
  std::vector<CountRow> rows = countRows(scene.model, types);
  std::vector<std::string> paths;
  for (const CountRow& row : rows) paths.push_back(row.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"root", "root.a", "root.a.type0", "root.a.type2", "root.b", "root.b.type1",
                                             "root.b.type3"}));
  EXPECT_EQ(rows[0].count, (Counts{14, 5, 21}));
  EXPECT_EQ(rows[1].count, (Counts{11, 2, 7}));
  EXPECT_EQ(rows[2].depth, 2);
  std::string csv = countsCsv(rows);
  EXPECT_NE(csv.find("compartment,root,root,14,5,21,40\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find("type,root.b.type1,type1,0,0,10,10\n"), std::string::npos) << csv;
}

TEST(CountFiles, NamesThatATableWouldTakeApartAreQuoted) {
  auto csvOf = [](const char* name) { return countsCsv({{"root.a", name, false, 1, {1, 2, 3}}}); };
  EXPECT_NE(csvOf("so \"called\"").find(",\"so \"\"called\"\"\","), std::string::npos) << csvOf("so \"called\"");
  EXPECT_NE(csvOf("a, b").find(",\"a, b\","), std::string::npos);
  EXPECT_NE(csvOf("plain").find(",plain,"), std::string::npos);
}

TEST(CountFiles, BarsAreAsLongAsTheirNumbers) {
  CountRow row{"root.<a>", "<a>", false, 1, {100, 300, 600}};
  std::string svg = countsSvg({row}, "A & B");
  EXPECT_NE(svg.find("A &amp; B"), std::string::npos);
  EXPECT_EQ(svg.find("<a>"), std::string::npos);
  std::vector<double> widths;
  for (std::size_t at = 0; (at = svg.find("height=\"14\"", at)) != std::string::npos; ++at) {
    std::size_t width = svg.rfind("width=\"", at);
    widths.push_back(std::atof(svg.c_str() + width + 7));
  }
  ASSERT_EQ(widths.size(), 3u);
  EXPECT_NEAR(widths[1], 3.0 * widths[0], 0.02);
  EXPECT_NEAR(widths[2], 6.0 * widths[0], 0.05);
}

TEST(CountFiles, EachInstanceHasOneState) {
  scene::Scene scene = modelScene();
  render::InstanceBits bits{40, {0b1001u, 0u}, {0b0110u, 0u}};
  std::string csv = instancesCsv(*scene.model.data, bits);
  EXPECT_TRUE(csv.starts_with("instance,type,state\n0,root.a.type0,clipped\n1,root.a.type0,visible\n")) << csv;
  EXPECT_NE(csv.find("\n3,root.a.type0,clipped\n4,root.a.type0,hidden\n"), std::string::npos) << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 41);
}

}  // namespace velum::session
