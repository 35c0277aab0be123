#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "Damage.h"
#include "PeakMemory.h"
#include "TestFiles.h"
#include "core/Error.h"
#include "io/meshes/ReadMesh.h"

namespace velum::io {
namespace {

const std::string kPoints = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kFaces = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kBody = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

std::string textPly(const std::string& header, const std::string& body) {
  return "ply\nformat ascii 1.0\n" + header + "end_header\n" + body;
}

Mesh readText(const std::string& text) {
  static TempFolder folder;
  Progress progress;
  writeText(folder / "a.ply", text);
  return readMesh(folder / "a.ply", progress);
}

void expectRefused(const std::string& text, const std::string& word) {
  try {
    readText(text);
    FAIL() << text;
  } catch (const InputError& error) {
    std::string said = error.what();
    EXPECT_NE(said.find(word), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  }
}

void expectTriangle(const Mesh& mesh) {
  ASSERT_EQ(mesh.positions.size(), 3u);
  EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(mesh.positions[1], glm::vec3(1, 0, 0));
  EXPECT_EQ(mesh.positions[2], glm::vec3(0, 1, 0));
  ASSERT_EQ(mesh.normals.size(), 3u);
  for (glm::vec3 n : mesh.normals) EXPECT_EQ(n, glm::vec3(0, 0, 1));
}

/// Areas of the triangles, seen from above: negative for one that is turned over.
std::vector<float> areasOf(const Mesh& mesh) {
  std::vector<float> areas;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    glm::vec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
              c = mesh.positions[mesh.indices[i + 2]];
    areas.push_back(glm::cross(b - a, c - a).z / 2);
  }
  return areas;
}

template <class T>
void put(std::string& to, T value, bool isBig) {
  auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (isBig != (std::endian::native == std::endian::big)) std::reverse(raw.begin(), raw.end());
  to.append(raw.data(), raw.size());
}

void putAs(std::string& to, const std::string& type, double value, bool isBig) {
  if (type == "char" || type == "int8") return put(to, std::int8_t(value), isBig);
  if (type == "uchar" || type == "uint8") return put(to, std::uint8_t(value), isBig);
  if (type == "short" || type == "int16") return put(to, std::int16_t(value), isBig);
  if (type == "ushort" || type == "uint16") return put(to, std::uint16_t(value), isBig);
  if (type == "int" || type == "int32") return put(to, std::int32_t(value), isBig);
  if (type == "uint" || type == "uint32") return put(to, std::uint32_t(value), isBig);
  if (type == "float" || type == "float32") return put(to, float(value), isBig);
  put(to, value, isBig);
}

/// The triangle in binary, with things before, between and behind that are none of ours.
std::string binaryPly(const std::string& type, const std::string& index, bool isBig) {
  std::string text = std::string("ply\nformat binary_") + (isBig ? "big" : "little") +
                     "_endian 1.0\ncomment made by hand\nobj_info nothing\nelement camera 1\nproperty double far\n" +
                     "property list uchar short lens\nelement vertex 3\n";
  for (const char* name : {"x", "confidence", "y", "z"}) text += "property " + type + " " + name + "\n";
  text += "element face 1\nproperty uchar flags\nproperty list " + index + " " + index +
          " vertex_indices\nproperty list uchar float texcoord\nelement more 2\nproperty int x\nend_header\n";
  put(text, 1e9, isBig);
  put(text, std::uint8_t(2), isBig);
  for (int i = 0; i < 2; ++i) put(text, std::int16_t(-5), isBig);
  for (auto p : {glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)})
    for (double value : {p.x, 77.0, p.y, p.z}) putAs(text, type, value, isBig);
  put(text, std::uint8_t(9), isBig);
  for (double value : {3.0, 0.0, 1.0, 2.0}) putAs(text, index, value, isBig);
  put(text, std::uint8_t(1), isBig);
  put(text, 0.5f, isBig);
  for (int i = 0; i < 2; ++i) put(text, std::int32_t(i), isBig);
  return text;
}

TEST(Ply, AFileWithoutItsLastNewlineIsRead) {
  std::string text = textPly(kPoints + kFaces, kBody);
  text.pop_back();
  expectTriangle(readText(text));
}

TEST(Ply, BlankLinesAndAnyEndOfLinesAreRead) {
  std::string text = textPly("\n" + kPoints + "\n  \n" + kFaces + "\n", "\n" + kBody + "\n\n");
  expectTriangle(readText(text));
  std::string dos, mac;
  for (char c : text) {
    if (c == '\n') dos += '\r';
    dos += c;
    mac += c == '\n' ? '\r' : c;
  }
  expectTriangle(readText(dos));
  expectTriangle(readText(mac));
}

TEST(Ply, FacesWithoutAListAreRefused) {
  expectRefused(textPly(kPoints + "element face 1\nproperty int a\n", "0 0 0\n1 0 0\n0 1 0\n5\n"), "vertex_indices");
  expectRefused(textPly(kPoints + "element face 1\n", "0 0 0\n1 0 0\n0 1 0\n"), "vertex_indices");
  expectRefused(textPly(kPoints, "0 0 0\n1 0 0\n0 1 0\n"), "no faces");
}

TEST(Ply, ADamagedHeaderLineIsRefusedAndQuoted) {
  for (const char* line : {"property float", "property flaot x", "property list uchar int", "proprty float x",
                           "property list float int vertex_indices", "element vertex three", "element vertex -1",
                           "element vertex", "property", "format ascii_"})
    expectRefused(textPly(kPoints + kFaces + line + "\n", kBody), line);
  expectRefused("ply\n" + kPoints + kFaces + "end_header\n" + kBody, "format");
  expectRefused("ply\nformat ascii 1.0\n" + kPoints, "end of its header");
  expectRefused(textPly("element vertex 3\nproperty float x\nproperty float y\n" + kFaces, "0 0\n1 0\n0 1\n3 0 1 2\n"),
                "x, y or z");
}

TEST(Ply, BothByteOrdersAndAllTypesReadAlike) {
  for (bool isBig : {false, true}) {
    for (const char* type : {"char", "int8", "uchar", "uint8", "short", "int16", "ushort", "uint16", "int", "int32",
                             "uint", "uint32", "float", "float32", "double", "float64"}) {
      SCOPED_TRACE(type);
      expectTriangle(readText(binaryPly(type, "uchar", isBig)));
    }
    for (const char* index : {"char", "short", "ushort", "int", "uint"})
      expectTriangle(readText(binaryPly("float", index, isBig)));
  }
}

TEST(Ply, ABinaryBodyMayBeginLikeAnEndOfLine) {
  std::string text =
      "ply\rformat binary_little_endian 1.0\relement vertex 3\rproperty char x\rproperty char y\r"
      "property char z\relement face 1\rproperty list uchar uchar vertex_indices\rend_header\r";
  for (int value : {10, 0, 0, 13, 0, 0, 10, 13, 0, 3, 0, 1, 2}) text += char(value);
  Mesh mesh = readText(text);
  EXPECT_EQ(mesh.positions[0], glm::vec3(10, 0, 0));
  EXPECT_EQ(mesh.positions[2], glm::vec3(10, 13, 0));
}

TEST(Ply, NormalsOfTheFileAreKeptWhereTheyAreUsable) {
  std::string points = kPoints + "property float nx\nproperty float ny\nproperty float nz\n";
  Mesh mesh = readText(textPly(points + kFaces, "0 0 0 0 3 4\n1 0 0 0 0 0\n0 1 0 nan 0 1\n3 0 1 2\n"));
  ASSERT_EQ(mesh.normals.size(), 3u);
  EXPECT_NEAR(mesh.normals[0].y, 0.6f, 1e-6);
  EXPECT_NEAR(mesh.normals[0].z, 0.8f, 1e-6);
  EXPECT_EQ(mesh.normals[1], glm::vec3(0, 0, 1));
  EXPECT_EQ(mesh.normals[2], glm::vec3(0, 0, 1));
}

TEST(Ply, OneColourIsTheSurfacesAndManyAreToldOf) {
  std::string points =
      kPoints + "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n";
  Mesh one = readText(textPly(points + kFaces, "0 0 0 255 51 0 9\n1 0 0 255 51 0 9\n0 1 0 255 51 0 9\n3 0 1 2\n"));
  ASSERT_TRUE(one.color);
  EXPECT_EQ(*one.color, glm::vec3(1.0f, 0.2f, 0.0f));
  EXPECT_TRUE(one.warnings.empty());
  Mesh many = readText(textPly(points + kFaces, "0 0 0 255 51 0 9\n1 0 0 255 50 0 9\n0 1 0 255 51 0 9\n3 0 1 2\n"));
  EXPECT_FALSE(many.color);
  EXPECT_EQ(many.warnings.size(), 1u);
  EXPECT_FALSE(readText(textPly(kPoints + kFaces, kBody)).color);
}

TEST(Ply, PolygonsKeepTheirAreaConvexOrNot) {
  std::string points = "element vertex 8\nproperty float x\nproperty float y\nproperty float z\n";
  // An arrow: two of its corners turn inwards; as a fan it would be drawn over its outline.
  std::string arrow = "0 0 0\n4 2 0\n0 4 0\n1 2.5 0\n-3 2.5 0\n-3 1.5 0\n1 1.5 0\n9 9 9\n";
  auto concave = areasOf(readText(textPly(points + kFaces, arrow + "7 0 1 2 3 4 5 6\n")));
  EXPECT_EQ(concave.size(), 5u);
  for (float area : concave) EXPECT_GT(area, 0);
  EXPECT_NEAR(std::accumulate(concave.begin(), concave.end(), 0.0f), 9.5f, 1e-5);
  std::string octagon = "2 0 0\n2 1 0\n1 2 0\n0 2 0\n-1 1 0\n-1 0 0\n0 -1 0\n1 -1 0\n";
  auto convex = areasOf(readText(textPly(points + kFaces, octagon + "8 0 1 2 3 4 5 6 7\n")));
  EXPECT_NEAR(std::accumulate(convex.begin(), convex.end(), 0.0f), 7.0f, 1e-5);
}

TEST(Ply, TrianglesOfAStripAllTurnLikeTheFirst) {
  std::string points = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
  Mesh mesh = readText(textPly(points + "element tristrips 1\nproperty list int int vertex_indices\n",
                               "0 0 0\n1 0 0\n0 1 0\n1 1 0\n8 0 1 2 3 -1 0 1 2\n"));
  EXPECT_EQ(areasOf(mesh), (std::vector<float>{0.5f, 0.5f, 0.5f}));
}

TEST(Ply, WhatIsNotThereIsRefused) {
  for (const char* face :
       {"3 0 1 3", "3 0 1 -1", "3 0 1 1.5", "3 0 1 nan", "3 0 1 4294967295", "-3 0 1 2", "3 0 1", "4 0 1 2"})
    EXPECT_THROW(readText(textPly(kPoints + kFaces, "0 0 0\n1 0 0\n0 1 0\n" + std::string(face))), InputError) << face;
  for (const char* point : {"nan", "inf", "-inf", "1e39", "1e999", "x"})
    EXPECT_THROW(readText(textPly(kPoints + kFaces, "0 0 " + std::string(point) + "\n1 0 0\n0 1 0\n3 0 1 2\n")),
                 InputError)
        << point;
}

TEST(Ply, PromisesAreHeldAgainstTheFileBeforeAnythingIsMade) {
  auto growth = peakGrowth([] {
    for (const char* count : {"4294967295", "999999999999", "18446744073709551615", "18446744073709551616"}) {
      std::string n = count;
      for (const char* coding : {"ascii", "binary_little_endian"}) {
        std::string start = std::string("ply\nformat ") + coding + " 1.0\n";
        std::string points = "element vertex " + n + "\nproperty float x\nproperty float y\nproperty float z\n";
        std::string faces = "element face " + n + "\nproperty list uchar int vertex_indices\n";
        EXPECT_THROW(readText(start + points + kFaces + "end_header\n" + kBody), InputError);
        EXPECT_THROW(readText(start + kPoints + faces + "end_header\n" + kBody), InputError);
        EXPECT_THROW(readText(start + "element other " + n + "\nproperty uchar a\nend_header\n" + kBody), InputError);
      }
    }
    std::string lists = kPoints + "element face 1\nproperty list int int vertex_indices\n";
    EXPECT_THROW(readText(textPly(lists, "0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n")), InputError);
  });
  EXPECT_LT(growth, std::size_t(32) << 20);
}

TEST(Ply, TwoElementsOfOneNameAreRefused) {
  // The normals of the second would have become those of the first.
  EXPECT_THROW(readText(textPly(kPoints + kPoints + kFaces, kBody)), InputError);
}

TEST(Ply, EveryCutIsRefused) {
  for (bool isBig : {false, true}) {
    std::string whole = binaryPly("float", "int", isBig);
    for (std::size_t keep = 0; keep < whole.size(); ++keep)
      EXPECT_THROW(readText(whole.substr(0, keep)), InputError) << keep;
  }
}

TEST(Ply, DamageIsReadOrRefused) {
  TempFolder folder;
  Progress progress;
  auto path = folder / "a.ply";
  for (const std::string& good : {textPly(kPoints + kFaces, kBody), binaryPly("float", "int", false)})
    expectReadOrRefused(good, path, 2000, [&] { readMesh(path, progress); });
}

}  // namespace
}  // namespace velum::io
