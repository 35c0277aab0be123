#include "session/model/ModelExport.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "GemmiAssembly.h"
#include "Glb.h"
#include "TempFolder.h"
#include "core/Error.h"
#include "io/models/ReadModel.h"
#include "makeModel.h"
#include "model/Levels.h"
#include "render/kept/KeptInstances.h"
#include "scene/Scene.h"

namespace velum::session {
namespace {

namespace fs = std::filesystem;

/// A plane removes a half, and one type is hidden.
scene::Scene cutScene() {
  Progress progress;
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  Model model = ModelMaker{.types = 5, .instances = 500}.make();
  scene.model.levels = Shared<LevelSet>(model::computeLevels(model, progress));
  scene.model.data = Shared<Model>(std::move(model));
  scene.cuts.emplace_back().shape = scene::CutShape::Plane;
  scene::TypeLook look;
  look.type = pathOf(*scene.model.data, scene.model.data->types[2]);
  look.visible = false;
  scene.model.types = {look};
  return scene;
}

std::string bytesOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

ModelExport writeTo(const scene::Scene& scene, const fs::path& path) {
  Progress progress;
  return exportModel(scene, path, progress);
}

/// Numbers of what shows, told apart from what exports do.
std::vector<std::uint32_t> shownNumbers(const scene::Scene& scene) {
  const Model& model = *scene.model.data;
  auto kept = render::keptInstances(scene);
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < model.instances.size(); ++i) {
    const MoleculeType& type = model.types[model.molecules[model.instances[i].molecule].type];
    if (kept[i] && scene::typeLook(scene.model, pathOf(model, type)).visible) numbers.push_back(i);
  }
  return numbers;
}

TEST(ModelExport, WhatShowsIsReadBack) {
  TempFolder folder;
  scene::Scene scene = cutScene();
  const Model& model = *scene.model.data;
  auto numbers = shownNumbers(scene);
  ASSERT_GT(numbers.size(), 100u);
  ASSERT_LT(numbers.size(), 300u);
  for (const char* name : {"a.cif", "a.cif.gz"}) {
    ModelExport written = writeTo(scene, folder / name);
    EXPECT_EQ(written.types, 4u);
    EXPECT_EQ(written.instances, numbers.size());
    Progress progress;
    Model back = io::readModel(folder / name, progress, {.completes = false});
    ASSERT_EQ(back.instances.size(), numbers.size());
    ASSERT_EQ(back.types.size(), 4u);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const Instance &a = model.instances[numbers[i]], &b = back.instances[i];
      ASSERT_LT(glm::length(a.position - b.position), 0.01f);
      ASSERT_GT(std::abs(glm::dot(a.rotation, b.rotation)), 1.0f - 1e-4f);
      ASSERT_EQ(back.types[back.molecules[b.molecule].type].name, model.types[model.molecules[a.molecule].type].name);
    }
  }
  GemmiAssembly assembly = readByGemmi(bytesOf(folder / "a.cif"));
  ASSERT_EQ(assembly.operators.size(), numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    glm::vec3 p = model.instances[numbers[i]].position;
    const double* shift = assembly.operators[i].shift;
    ASSERT_LT(glm::length(p - glm::vec3(shift[0], shift[1], shift[2])), 0.01f);
  }
}

TEST(ModelExport, PointsHaveTheNumbersAndColoursOfThePicture) {
  TempFolder folder;
  scene::Scene scene = cutScene();
  scene::TypeLook red;
  red.type = pathOf(*scene.model.data, scene.model.data->types[3]);
  red.color = glm::vec3(1, 0, 0);
  scene.model.types.push_back(red);
  writeTo(scene, folder / "a.csv");
  std::istringstream in(bytesOf(folder / "a.csv"));
  std::string line;
  std::getline(in, line);
  std::size_t reds = 0, wanted = 0;
  for (std::uint32_t number : shownNumbers(scene)) {
    ASSERT_TRUE(std::getline(in, line));
    ASSERT_NE(line.find("," + std::to_string(number) + ","), std::string::npos) << line;
    reds += line.ends_with("#ff0000");
    wanted += scene.model.data->molecules[scene.model.data->instances[number].molecule].type == 3;
  }
  EXPECT_GT(wanted, 10u);
  EXPECT_EQ(reds, wanted);
}

TEST(ModelExport, ShapesAreThoseOfTheirMolecules) {
  TempFolder folder;
  scene::Scene scene = cutScene();
  for (bool hasLevels : {true, false}) {
    if (!hasLevels) scene.model.levels = {};
    writeTo(scene, folder / "a.glb");
    Glb glb(bytesOf(folder / "a.glb"));
    std::size_t instances = 0;
    int compared = 0;
    for (const auto& node : glb.json["nodes"]) {
      if (!node.contains("extensions")) continue;
      instances += node["extras"]["instances"].get<std::size_t>();
      auto points = glb.read<glm::vec3>(
          glb.json["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0]["attributes"]["POSITION"]);
      for (const MoleculeType& type : scene.model.data->types)
        if (pathOf(*scene.model.data, type) == node["name"].get<std::string>()) {
          const auto& atoms = scene.model.data->molecules[type.firstMolecule].atoms;
          ASSERT_EQ(points.size(), 42 * atoms.size()) << "sixty atoms are a level of their own";
          EXPECT_LT(glm::length(points[0] - atoms[0].position), 2.0f);
          ++compared;
        }
    }
    EXPECT_EQ(instances, shownNumbers(scene).size());
    EXPECT_GE(compared, 2) << "types by their names";
  }
}

TEST(ModelExport, WhatCannotBeWrittenIsSaidInALine) {
  TempFolder folder;
  auto expectLine = [&](const scene::Scene& scene, const fs::path& path) {
    try {
      writeTo(scene, path);
      FAIL() << path;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  };
  scene::Scene scene = cutScene();
  expectLine({}, folder / "a.cif");
  for (const char* name : {"a.nrrd", "a", "\n.cif/a.cif", "none/a.glb", ".csv"}) expectLine(scene, folder / name);
  fs::create_directory(folder / "b.ply");
  expectLine(scene, folder / "b.ply");
  scene.model.visible = false;
  expectLine(scene, folder / "a.cif");
  scene.model.visible = true;
  scene.cuts[0].centre = glm::dvec3(0);
  scene.cuts.push_back(scene.cuts[0]);
  scene.cuts[1].axis = -scene.cuts[1].axis;
  expectLine(scene, folder / "a.cif");
  EXPECT_FALSE(fs::exists(folder / "a.cif"));
}

TEST(ModelExport, CopiesAndShadesThatAreLeftOutAreSaid) {
  TempFolder folder;
  scene::Scene scene = cutScene();
  std::size_t before = writeTo(scene, folder / "a.ply").losses.size();
  scene.model.copies = 3;
  scene.model.palette = scene::Palette::Chain;
  EXPECT_EQ(writeTo(scene, folder / "a.ply").losses.size(), before + 2);
}

TEST(ModelExport, KnowsItsFiles) {
  for (const char* name : {"a.cif", "a.CIF", "a.cif.gz", "a.glb", "a.csv", "a.ply"}) EXPECT_TRUE(isModelFile(name));
  for (const char* name : {"a.gz", "a.stl", "a.json", "cif", "a."}) EXPECT_FALSE(isModelFile(name));
}

}  // namespace
}  // namespace velum::session
