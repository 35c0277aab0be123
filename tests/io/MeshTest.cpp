#include <cstdint>
#include <cstring>
#include <string>

#include "Damage.h"
#include "PeakMemory.h"
#include "TestFiles.h"
#include "core/Error.h"
#include "io/meshes/ReadMesh.h"
#include "io/meshes/WriteMesh.h"

namespace velum::io {
namespace {

Mesh readAs(const char* name, const std::string& bytes) {
  TempFolder folder;
  Progress progress;
  writeText(folder / name, bytes);
  return readMesh(folder / name, progress);
}

/// A tetrahedron of any corners.
Mesh tetrahedron() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}};
  mesh.indices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  return mesh;
}

std::string binaryStl(const std::string& title, std::uint32_t count) {
  std::string bytes = title + std::string(80 - title.size(), ' ');
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  Mesh mesh = tetrahedron();
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    bytes += std::string(12, '\0');
    for (std::size_t c = 0; c < 3; ++c)
      bytes.append(reinterpret_cast<const char*>(&mesh.positions[mesh.indices[i + c]]), 12);
    bytes += std::string(2, '\0');
  }
  return bytes;
}

TEST(Mesh, WhatIsWrittenIsReadBack) {
  TempFolder folder;
  Progress progress;
  for (const char* name : {"a.ply", "a.stl", "a.obj", "a.vtp"}) {
    SCOPED_TRACE(name);
    writeMesh(tetrahedron(), folder / name);
    Mesh back = readMesh(folder / name, progress);
    EXPECT_EQ(back.positions.size(), 4u);
    ASSERT_EQ(back.indices.size(), 12u);
    for (std::size_t i = 0; i < 12; ++i)
      EXPECT_EQ(back.positions[back.indices[i]], tetrahedron().positions[tetrahedron().indices[i]]);
    EXPECT_EQ(back.name, "a");
  }
}

TEST(Mesh, DamageOfAnyFormatIsReadOrRefused) {
  TempFolder folder;
  Progress progress;
  for (const char* name : {"a.ply", "a.stl", "a.obj", "a.vtp"}) {
    SCOPED_TRACE(name);
    auto path = folder / name;
    writeMesh(tetrahedron(), path);
    std::string good = bytesOf(path);
    auto growth = peakGrowth([&] { expectReadOrRefused(good, path, 1000, [&] { readMesh(path, progress); }); });
    EXPECT_LT(growth, std::size_t(64) << 20);
  }
}

TEST(Stl, BinaryThatBeginsLikeTextIsBinary) {
  Mesh mesh = readAs("a.stl", binaryStl("solid made by a scanner", 4));
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.indices.size(), 12u);
}

TEST(Stl, TrianglesThatAreNotThereAreRefused) {
  EXPECT_THROW(readAs("a.stl", binaryStl("x", 5)), InputError);
  EXPECT_THROW(readAs("a.stl", binaryStl("x", 0xffffffff)), InputError);
  std::string facet =
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
  EXPECT_EQ(readAs("a.stl", facet + "endsolid a").indices.size(), 3u);
  EXPECT_EQ(readAs("a.stl", facet).warnings.size(), 1u);
  EXPECT_THROW(readAs("a.stl", facet.substr(0, 70)), InputError);
  EXPECT_THROW(readAs("a.stl",
                      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 nan\nvertex 1 0 0\nvertex 0 1 0\n"
                      "endloop\nendfacet\nendsolid"),
               InputError);
}

TEST(Stl, EqualCornersAreOnePoint) {
  std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 -0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
  std::string other = "facet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n";
  std::string flat = "facet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
  Mesh mesh = readAs("a.stl", "solid facet of vertex\n" + facet + other + flat + "endsolid\n");
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.indices.size(), 6u);
}

TEST(Obj, EveryWayToNameACornerIsRead) {
  std::string points = "# made by hand\nmtllib a.mtl\no thing\nv 0 0 0\nv 1 0 0 1\nv 0 1 0\nvt 0 0\nvn 0 0 2\n";
  for (const char* face : {"f 1 2 3", "f 1/1 2/1 3/1", "f 1//1 2//1 3//1", "f 1/1/1 2/1/1 3/1/1", "f -3 -2 -1",
                           "f -3//-1 \\\n-2//-1 -1//-1", "f 1/ 2/ 3/", "f 1 2 3\r", "\tf\t1 2 3"}) {
    Mesh mesh = readAs("a.obj", points + face);
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2})) << face;
    for (glm::vec3 n : mesh.normals) EXPECT_EQ(n, glm::vec3(0, 0, 1)) << face;
  }
  for (const char* face : {"f 1 2 4", "f 0 1 2", "f -4 1 2", "f 1 2 x", "f 1//1 2//1 3//2", "f 1//0 2//1 3//1",
                           "f 1 2 99999999999999999999", "f 1 2", ""})
    EXPECT_THROW(readAs("a.obj", points + face), InputError) << face;
  EXPECT_THROW(readAs("a.obj", "v 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3"), InputError);
}

TEST(Obj, APointWithTwoNormalsIsTwo) {
  Mesh mesh =
      readAs("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1//2 4//2 2//2\n");
  EXPECT_EQ(mesh.positions.size(), 6u);
  ASSERT_EQ(mesh.indices.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(mesh.normals[mesh.indices[i]], i < 3 ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0));
}

TEST(Obj, OneColourIsTheSurfaces) {
  Mesh mesh = readAs("a.obj", "v 0 0 0 1 0.5 0\nv 1 0 0 1 0.5 0\nv 0 1 0 1 0.5 0\nf 1 2 3\n");
  ASSERT_TRUE(mesh.color);
  EXPECT_EQ(*mesh.color, glm::vec3(1, 0.5f, 0));
}

std::string textVtp(const std::string& polys, const std::string& more = "") {
  return "<?xml version=\"1.0\"?>\n<!-- a > b -->\n<VTKFile type=\"PolyData\" version=\"1.0\" "
         "byte_order=\"LittleEndian\">"
         "<PolyData><FieldData><DataArray type=\"Rubbish\" Name=\"x\" format=\"strange\"/></FieldData>"
         "<Piece NumberOfPoints=\"4\" NumberOfVerts=\"0\" NumberOfPolys=\"2\"><PointData/><Points>"
         "<DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 1 1 "
         "0</DataArray></Points>" +
         polys + more + "</Piece></PolyData></VTKFile>";
}
std::string polysOf(const std::string& corners, const std::string& ends) {
  return "<Polys><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" + corners +
         "</DataArray><DataArray type='Int64' Name='offsets' format='ascii'>" + ends + "</DataArray></Polys>";
}

TEST(Vtp, FacesAreReadAndThoseThatAreNotThereRefused) {
  EXPECT_EQ(readAs("a.vtp", textVtp(polysOf("0 1 2 1 3 2", "3 6"))).indices,
            (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2}));
  for (auto [corners, ends] : {std::pair{"0 1 2 1 3 4", "3 6"},
                               {"0 1 2 1 3 -1", "3 6"},
                               {"0 1 2 1 3 2", "3 9"},
                               {"0 1 2 1 3 2", "6 3"},
                               {"0 1 2 1 3 2", "3 nan"},
                               {"0 1 2 1 3 2", "3 9e12"},
                               {"0 1 2", "3"}})
    EXPECT_THROW(readAs("a.vtp", textVtp(polysOf(corners, ends))), InputError) << corners << ", " << ends;
  EXPECT_THROW(readAs("a.vtp", textVtp("")), InputError);
  EXPECT_THROW(readAs("a.vtp", "<VTKFile type=\"ImageData\"><ImageData/></VTKFile>"), InputError);
}

TEST(Vtp, CountsAreHeldAgainstTheFile) {
  auto growth = peakGrowth([] {
    std::string good = textVtp(polysOf("0 1 2 1 3 2", "3 6"));
    for (const char* count : {"99999999999", "4294967294", "1e300", "-1", "nan", "", "x"})
      for (const char* key : {"NumberOfPoints=\"4", "NumberOfPolys=\"2", "NumberOfComponents=\"3"}) {
        std::string bad = good;
        std::string wanted = key;
        bad.replace(bad.find(wanted), wanted.size(), wanted.substr(0, wanted.size() - 1) + count);
        EXPECT_THROW(readAs("a.vtp", bad), InputError) << key << " " << count;
      }
  });
  EXPECT_LT(growth, std::size_t(32) << 20);
}

}  // namespace
}  // namespace velum::io
