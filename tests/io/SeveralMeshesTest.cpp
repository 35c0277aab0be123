#include "Glb.h"
#include "TestFiles.h"
#include "io/meshes/ReadMesh.h"
#include "io/meshes/WriteMesh.h"

/// Several surfaces in one file.
namespace velum::io {
namespace {

using Json = nlohmann::json;

Mesh tetrahedron(const char* name, glm::vec3 at, glm::vec3 color) {
  Mesh mesh;
  mesh.positions = {at, at + glm::vec3(2, 0, 0), at + glm::vec3(0, 3, 0), at + glm::vec3(0, 0, 4)};
  mesh.indices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  mesh.normals = {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.name = name;
  mesh.color = color;
  return mesh;
}

std::vector<Mesh> two() {
  return {tetrahedron("aorta \"1\" \xc3\xa9", {-1, 5, 7}, {1, 0.5f, 0}),
          tetrahedron("liver", {30, 20, 10}, {0.2f, 0.4f, 0.6f})};
}

TEST(Gltf, HoldsEachSurfaceWithNameMaterialAndBounds) {
  TempFolder folder;
  EXPECT_TRUE(writeMeshes(two(), folder / "a.glb").empty());
  Glb glb(bytesOf(folder / "a.glb"));
  EXPECT_EQ(glb.json["asset"]["version"], "2.0");
  const Json& root = glb.json["nodes"][glb.json["scenes"][0]["nodes"][0].get<std::size_t>()];
  ASSERT_EQ(root["children"].size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    Mesh wanted = two()[i];
    const Json& node = glb.json["nodes"][root["children"][i].get<std::size_t>()];
    EXPECT_EQ(node["name"], wanted.name);
    const Json& part = glb.json["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0];
    EXPECT_EQ(glb.read<glm::vec3>(part["attributes"]["POSITION"]), wanted.positions);
    EXPECT_EQ(glb.read<glm::vec3>(part["attributes"]["NORMAL"]), wanted.normals);
    EXPECT_EQ(glb.read<std::uint32_t>(part["indices"]), wanted.indices);
    const Json& accessor = glb.json["accessors"][part["attributes"]["POSITION"].get<std::size_t>()];
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(accessor["min"][std::size_t(c)].get<float>(), wanted.positions[0][c]);
      EXPECT_EQ(accessor["max"][std::size_t(c)].get<float>(), wanted.positions[std::size_t(c + 1)][c]);
    }
    const Json& material = glb.json["materials"][part["material"].get<std::size_t>()];
    EXPECT_EQ(material["name"], wanted.name);
    EXPECT_EQ(material["pbrMetallicRoughness"]["baseColorFactor"].size(), 4u);
  }
  // Linear: half of sRGB is a fifth.
  EXPECT_NEAR(glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"][1].get<double>(), 0.2140, 1e-3);
}

TEST(Gltf, TheHeadIsUpAndLengthsAreMetres) {
  TempFolder folder;
  for (LengthUnit unit : {LengthUnit::Millimetre, LengthUnit::Angstrom}) {
    writeMeshes(two(), folder / "a.glb", unit);
    Glb glb(bytesOf(folder / "a.glb"));
    const Json& root = glb.json["nodes"][0];
    auto q = root["rotation"].get<std::vector<double>>();
    auto scale = root["scale"].get<std::vector<double>>();
    glm::dvec3 axis(q[0], q[1], q[2]), superior(0, 0, 1), anterior(0, -1, 0);
    auto turned = [&](glm::dvec3 v) { return v + 2.0 * glm::cross(axis, glm::cross(axis, v) + q[3] * v); };
    EXPECT_LT(glm::length(turned(superior) - glm::dvec3(0, 1, 0)), 1e-12);
    EXPECT_LT(glm::length(turned(anterior) - glm::dvec3(0, 0, 1)), 1e-12);
    EXPECT_EQ(scale[0], millimetresPer(unit) * 1e-3);
  }
}

TEST(SeveralMeshes, AreReadBackAsOneOfAllTriangles) {
  TempFolder folder;
  Progress progress;
  const std::vector<Mesh> parts = two();
  for (const char* name : {"a.ply", "a.stl", "a.obj", "a.vtp"}) {
    SCOPED_TRACE(name);
    writeMeshes(two(), folder / name);
    Mesh back = readMesh(folder / name, progress);
    ASSERT_EQ(back.indices.size(), 24u);
    for (std::size_t i = 0; i < 24; ++i) {
      const Mesh& part = parts[i / 12];
      EXPECT_EQ(back.positions[back.indices[i]], part.positions[part.indices[i % 12]]);
    }
  }
  EXPECT_NE(bytesOf(folder / "a.obj").find("o liver\n"), std::string::npos);
}

TEST(SeveralMeshes, ColoursAreKeptOrSaid) {
  TempFolder folder;
  Progress progress;
  Mesh one = two()[0];
  for (const char* name : {"a.ply", "a.stl", "a.obj", "a.vtp"}) {
    SCOPED_TRACE(name);
    auto lines = writeMesh(one, folder / name);
    Mesh back = readMesh(folder / name, progress);
    bool isSaid = std::any_of(lines.begin(), lines.end(), [](auto& l) { return l.find("colours") != l.npos; });
    EXPECT_NE(isSaid, back.color.has_value());
    EXPECT_LT(glm::length(back.color.value_or(*one.color) - *one.color), 0.01f);
  }
  EXPECT_EQ(writeMeshes(two(), folder / "a.stl").size(), 3u) << "normals, colours and names";
}

TEST(SeveralMeshes, EmptyOnesAreRefused) {
  TempFolder folder;
  EXPECT_THROW(writeMeshes({}, folder / "a.glb"), InputError);
  auto meshes = two();
  meshes[1].indices.clear();
  EXPECT_THROW(writeMeshes(meshes, folder / "a.glb"), InputError);
  EXPECT_THROW(writeMeshes(two(), folder / "a.gltf"), InputError);
}

}  // namespace
}  // namespace velum::io
