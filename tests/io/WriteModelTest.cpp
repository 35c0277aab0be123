#include "io/models/WriteModel.h"

#include <fstream>
#include <map>
#include <sstream>

#include "Glb.h"
#include "ModelFiles.h"
#include "makeModel.h"

/// Models as glTF and as lists of points; mmCIF is in VirionTest.cpp.
namespace velum::io {
namespace {

using Json = nlohmann::json;

const Model& made() {
  static const Model model = ModelMaker{.types = 4, .atoms = 900, .instances = 403, .moleculeRadius = 30.0f}.make();
  return model;
}

std::vector<std::string> write(const Model& model, const std::filesystem::path& path, const ModelWriting& how = {}) {
  Progress progress;
  return writeModel(model, path, progress, how);
}

glm::vec3 shownMiddle(const Model& model, const Instance& instance) {
  return instance.position + instance.rotation * model.molecules[instance.molecule].centre;
}

/// What any reader of glTF may rely on.
void expectValid(const Glb& glb) {
  const Json& json = glb.json;
  EXPECT_EQ(json["asset"]["version"], "2.0");
  std::size_t end = 0;
  for (const Json& view : json["bufferViews"]) {
    EXPECT_EQ(view["byteOffset"].get<std::size_t>(), end) << "one behind the other";
    end += view["byteLength"].get<std::size_t>();
  }
  EXPECT_EQ(end, glb.binary.size());
  std::map<int, std::size_t> widths{{5126, 4}, {5123, 2}};
  std::map<std::string, std::size_t> counts{{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
  for (const Json& accessor : json["accessors"]) {
    const Json& view = json["bufferViews"].at(accessor["bufferView"].get<std::size_t>());
    EXPECT_GT(accessor["count"].get<std::size_t>(), 0u);
    EXPECT_EQ(
        view["byteLength"].get<std::size_t>(),
        accessor["count"].get<std::size_t>() * widths.at(accessor["componentType"]) * counts.at(accessor["type"]));
  }
  std::vector<int> parents(json["nodes"].size(), 0);
  for (const Json& node : json["nodes"])
    if (node.contains("children"))
      for (const Json& child : node["children"]) ++parents.at(child.get<std::size_t>());
  EXPECT_EQ(parents[0], 0);
  EXPECT_TRUE(std::all_of(parents.begin() + 1, parents.end(), [](int count) { return count == 1; })) << "a tree";
  for (const Json& mesh : json["meshes"]) {
    const Json& part = mesh["primitives"].at(0);
    auto points = glb.read<glm::vec3>(part["attributes"]["POSITION"]);
    auto normals = glb.read<glm::vec3>(part["attributes"]["NORMAL"]);
    auto corners = glb.read<std::uint16_t>(part["indices"]);
    EXPECT_EQ(normals.size(), points.size());
    EXPECT_EQ(corners.size() % 3, 0u);
    for (const glm::vec3& normal : normals) ASSERT_NEAR(glm::length(normal), 1.0f, 1e-5f);
    glm::vec3 low = points.at(0), high = low;
    for (const glm::vec3& p : points) low = glm::min(low, p), high = glm::max(high, p);
    const Json& accessor = json["accessors"][part["attributes"]["POSITION"].get<std::size_t>()];
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(accessor["min"][std::size_t(axis)].get<float>(), low[axis]);
      EXPECT_EQ(accessor["max"][std::size_t(axis)].get<float>(), high[axis]);
    }
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
      ASSERT_LT(std::max({corners[i], corners[i + 1], corners[i + 2]}), points.size());
      glm::vec3 a = points[corners[i]], b = points[corners[i + 1]], c = points[corners[i + 2]];
      ASSERT_GT(glm::dot(glm::cross(b - a, c - a), normals[corners[i]]), 0.0f) << "counter-clockwise from outside";
    }
  }
}

/// The nodes that have instances, by name.
std::map<std::string, Json> instancedNodes(const Glb& glb) {
  std::map<std::string, Json> nodes;
  for (const Json& node : glb.json["nodes"])
    if (node.contains("extensions")) {
      EXPECT_TRUE(nodes.emplace(node["name"], node).second) << node["name"];
    }
  return nodes;
}

TEST(ModelGltf, CarriesAllInstancesOfAllTypesByTheirPaths) {
  TempFolder folder;
  std::vector<std::string> losses =
      write(made(), folder / "a.glb", {.colors = std::vector<glm::vec3>(4, glm::vec3(0.5f))});
  EXPECT_EQ(losses.size(), 1u);
  Glb glb(bytesOf(folder / "a.glb"));
  expectValid(glb);
  EXPECT_EQ(glb.json["extensionsUsed"], Json::array({"EXT_mesh_gpu_instancing"}));
  EXPECT_EQ(glb.json["asset"]["extras"]["unit"], "nanometre");
  EXPECT_EQ(glb.json["nodes"][0]["scale"][0], 0.1) << "of angstrom";
  EXPECT_NEAR(glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"][1].get<double>(), 0.2140, 1e-3);
  auto nodes = instancedNodes(glb);
  ASSERT_EQ(nodes.size(), made().types.size());
  for (const MoleculeType& type : made().types) {
    ASSERT_TRUE(nodes.contains(pathOf(made(), type)));
    const Json& node = nodes[pathOf(made(), type)];
    EXPECT_EQ(node["extras"]["instances"], type.instanceCount);
    const Json& attributes = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    auto places = glb.read<glm::vec3>(attributes["TRANSLATION"]);
    auto rotations = glb.read<glm::vec4>(attributes["ROTATION"]);
    ASSERT_EQ(places.size(), type.instanceCount);
    ASSERT_EQ(rotations.size(), type.instanceCount);
    for (std::uint32_t i = 0; i < type.instanceCount; ++i) {
      const Instance& instance = made().instances[type.firstInstance + i];
      glm::vec4 q = rotations[i];
      ASSERT_EQ(places[i], instance.position);
      ASSERT_NEAR(glm::length(q), 1.0f, 1e-6f);
      ASSERT_GT(std::abs(glm::dot(glm::quat(q.w, q.x, q.y, q.z), instance.rotation)), 1.0f - 1e-6f) << "x, y, z, w";
    }
  }
}

TEST(ModelGltf, ShapesAreOfTheFinestLevelWithFewEnoughBalls) {
  TempFolder folder;
  Model model = ModelMaker{.types = 1, .atoms = 50, .instances = 3}.make();
  LevelSet levels;
  for (std::uint32_t count : {50u, 12u, 1u}) {
    levels.levels.push_back({std::uint32_t(levels.balls.size()), count, 0.0f, 2.0f});
    for (std::uint32_t i = 0; i < count; ++i) levels.balls.push_back({{float(9 * i), 0, 0}, 2.0f, kResidue, 0});
  }
  levels.firstLevel = {0, 3};
  auto pointsWith = [&](std::uint32_t most) {
    write(model, folder / "a.glb", {.levels = &levels, .mostBalls = most});
    Glb glb(bytesOf(folder / "a.glb"));
    expectValid(glb);
    return glb.read<glm::vec3>(glb.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"]);
  };
  EXPECT_EQ(pointsWith(400).size(), 50u * 42u);
  EXPECT_EQ(pointsWith(50).size(), 50u * 42u);
  EXPECT_EQ(pointsWith(49).size(), 12u * 42u);
  EXPECT_EQ(pointsWith(0).size(), 42u);
  // A mesh of a ball is as large as it.
  auto points = pointsWith(1);
  for (const glm::vec3& p : points) {
    EXPECT_GT(glm::length(p), 2.0f);
    EXPECT_LT(glm::length(p), 2.2f);
  }
}

TEST(ModelGltf, MoleculesOfOneTypeStandBelowItsNode) {
  ModelBuilder builder("shapes");
  MoleculeType lipid;
  lipid.name = "lipid";
  std::uint32_t type = builder.addType(lipid);
  for (int m = 0; m < 3; ++m) {
    std::uint32_t molecule = builder.addMolecule(type, randomAtoms(20, 5.0f, unsigned(m)));
    for (int i = 0; i <= m; ++i) builder.addInstance(molecule, {i, m, 0}, {1, 0, 0, 0});
  }
  TempFolder folder;
  Model model = builder.build();
  write(model, folder / "a.glb");
  Glb glb(bytesOf(folder / "a.glb"));
  expectValid(glb);
  EXPECT_EQ(instancedNodes(glb).size(), 3u);
  const Json& node = glb.json["nodes"][glb.json["nodes"][0]["children"].at(0).get<std::size_t>()];
  EXPECT_EQ(node["name"], "root.lipid");
  EXPECT_EQ(node["children"].size(), 3u);
  EXPECT_EQ(node["extras"]["instances"], 6);
}

/// Fields of a line of CSV.
std::vector<std::string> fieldsOf(const std::string& line) {
  std::vector<std::string> fields(1);
  bool isQuoted = false;
  for (char c : line) {
    if (c == '"') isQuoted = !isQuoted;
    if (c == ',' && !isQuoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

TEST(ModelPoints, ALineOfCsvIsAnInstance) {
  TempFolder folder;
  Model model = made();
  model.types[1].name = "a \"name\", with\nall";
  std::vector<std::uint32_t> numbers(model.instances.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = std::uint32_t(1000 + 3 * i);
  ModelWriting how;
  how.colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5f, 0.5f, 0.5f}};
  how.numbers = numbers;
  write(model, folder / "a.csv", how);
  std::istringstream in(bytesOf(folder / "a.csv"));
  std::string line;
  std::getline(in, line);
  std::size_t columns = fieldsOf(line).size();
  ASSERT_EQ(columns, 15u);
  EXPECT_NE(line.find("x_angstrom"), std::string::npos);
  for (std::size_t i = 0; i < model.instances.size(); ++i) {
    ASSERT_TRUE(std::getline(in, line));
    auto fields = fieldsOf(line);
    ASSERT_EQ(fields.size(), columns) << line;
    const Instance& instance = model.instances[i];
    std::uint32_t type = model.molecules[instance.molecule].type;
    if (type == 1)
      ASSERT_EQ(fields[0], "\"a \"\"name\"\", with all\"");
    else
      ASSERT_EQ(fields[0], "\"" + model.types[type].name + "\"");
    ASSERT_TRUE(fields[1] == "\"root.a\"" || fields[1] == "\"root.b\"") << fields[1];
    ASSERT_EQ(fields[2], std::to_string(numbers[i]));
    auto number = [&](std::size_t field) { return std::stof(fields[field]); };
    ASSERT_EQ(glm::vec3(number(3), number(4), number(5)), instance.position);
    ASSERT_EQ(glm::quat(number(6), number(7), number(8), number(9)), instance.rotation);
    ASSERT_EQ(glm::vec3(number(10), number(11), number(12)), shownMiddle(model, instance));
    ASSERT_EQ(number(13), model.molecules[instance.molecule].radius);
    ASSERT_EQ(fields[14], type == 0 ? "#ff0000" : type == 1 ? "#00ff00" : type == 2 ? "#0000ff" : "#808080");
  }
  EXPECT_FALSE(std::getline(in, line));
}

TEST(ModelPoints, APointOfPlyIsAnInstance) {
  TempFolder folder;
  write(made(), folder / "a.ply");
  std::string bytes = bytesOf(folder / "a.ply");
  std::size_t head = bytes.find("end_header\n") + 11, point = 8 * 4 + 3 + 8;
  ASSERT_EQ(bytes.size(), head + point * made().instances.size());
  EXPECT_NE(bytes.find("comment type 3 " + pathOf(made(), made().types[3]) + "\n"), std::string::npos);
  for (std::size_t i = 0; i < made().instances.size(); ++i) {
    const Instance& instance = made().instances[i];
    float numbers[8];
    std::uint32_t words[2];
    std::memcpy(numbers, &bytes[head + i * point], sizeof numbers);
    std::memcpy(words, &bytes[head + i * point + 35], sizeof words);
    ASSERT_EQ(glm::vec3(numbers[0], numbers[1], numbers[2]), shownMiddle(made(), instance));
    ASSERT_EQ(numbers[3], made().molecules[instance.molecule].radius);
    ASSERT_EQ(glm::quat(numbers[4], numbers[5], numbers[6], numbers[7]), instance.rotation);
    ASSERT_EQ(words[0], made().molecules[instance.molecule].type);
    ASSERT_EQ(words[1], i);
  }
}

TEST(WriteModel, EveryRefusalIsALine) {
  TempFolder folder;
  Progress progress;
  for (const char* name : {"a.xyz", "a", "none/a.cif", "", ".glb", "a.glb/b.csv"}) {
    try {
      writeModel(made(), folder / name, progress);
      FAIL() << name;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
  EXPECT_THROW(writeModel(Model{}, folder / "a.csv", progress), InputError);
  progress.cancel();
  for (const char* name : {"a.cif", "a.glb", "a.csv", "a.ply"})
    EXPECT_THROW(writeModel(made(), folder / name, progress), Cancelled);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(WriteModel, WhatIsLostIsSaid) {
  TempFolder folder;
  ModelBuilder builder("rare");
  std::uint32_t type = builder.addType({.name = "x"});
  builder.addInstance(builder.addMolecule(type, {{glm::vec3(0), 26, 0}}), {}, {1, 0, 0, 0});
  builder.addInstance(builder.addMolecule(type, {}, {{{0, 0, 0, 5}}, {{0, 0, 0, 9}}}), {}, {1, 0, 0, 0});
  Model model = builder.build();
  auto says = [](const std::vector<std::string>& lines, const char* word) {
    return std::any_of(lines.begin(), lines.end(), [&](auto& line) { return line.find(word) != std::string::npos; });
  };
  auto cif = write(model, folder / "a.cif", {.colors = {glm::vec3(1)}});
  for (const char* word : {"colours", "carbon", "without an element", "coarser"}) EXPECT_TRUE(says(cif, word)) << word;
  EXPECT_TRUE(says(write(model, folder / "a.glb"), "nanometre"));
  EXPECT_TRUE(says(write(model, folder / "a.csv"), "atoms"));
  EXPECT_TRUE(says(write(model, folder / "a.ply"), "angstrom"));
  EXPECT_TRUE(write(made(), folder / "b.cif").empty());
}

}  // namespace
}  // namespace velum::io
