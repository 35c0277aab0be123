#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>
#include <fstream>
#include <random>

#include "TestFiles.h"
#include "core/Error.h"
#include "io/meshes/ReadMesh.h"
#include "io/volumes/Readers.h"
#include "io/volumes/WriteVolume.h"

namespace velum::io {
namespace {

Volume noise(glm::ivec3 dims, SampleType type, int channels) {
  Volume v;
  v.dims = dims;
  v.type = type;
  v.channels = channels;
  v.voxels.resize(voxelCount(v) * std::size_t(channels) * sampleSize(type));
  std::mt19937 random(11);
  visitSamples(v, [&](auto* p) {
    using T = std::remove_cvref_t<decltype(*p)>;
    auto* to = reinterpret_cast<T*>(v.voxels.data());
    for (std::size_t i = 0; i < voxelCount(v) * std::size_t(channels); ++i) to[i] = T(random() % 200);
  });
  // Oblique and left-handed, far from the origin.
  double a = 0.3, b = 0.5;
  glm::dmat3 turn = glm::dmat3(std::cos(a), std::sin(a), 0, -std::sin(a), std::cos(a), 0, 0, 0, 1) *
                    glm::dmat3(1, 0, 0, 0, std::cos(b), std::sin(b), 0, std::sin(b), -std::cos(b));
  v.worldFromVoxel = glm::dmat4(turn * glm::dmat3(0.7, 0, 0, 0, 0.8, 0, 0, 0, 2.5));
  v.worldFromVoxel[3] = glm::dvec4(-120.5, 33.25, 1000, 1);
  computeRange(v);
  return v;
}

void expectSamePlace(const Volume& a, const Volume& b) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) EXPECT_NEAR(a.worldFromVoxel[c][r], b.worldFromVoxel[c][r], 1e-6) << c << r;
}

scene::Source sourceOf(const std::filesystem::path& path) {
  scene::Source source;
  source.path = path.string();
  return source;
}

TEST(Vti, RoundTripKeepsSamplesPlaceAndScale) {
  TempFolder folder;
  Progress progress;
  for (int type = 0; type < 8; ++type)
    for (int channels : {1, 3}) {
      Volume v = noise({9, 8, 7}, SampleType(type), channels);
      v.scale = 0.5;
      v.offset = -1024;
      v.isOrientationKnown = type % 2;
      writeVolume(v, folder / "a.vti", progress);
      Volume back = readVti(sourceOf(folder / "a.vti"), progress);
      EXPECT_EQ(back.dims, v.dims);
      EXPECT_EQ(back.type, v.type);
      EXPECT_EQ(back.channels, channels);
      EXPECT_TRUE(back.voxels == v.voxels) << type;
      EXPECT_EQ(back.scale, 0.5);
      EXPECT_EQ(back.offset, -1024);
      EXPECT_EQ(back.isOrientationKnown, v.isOrientationKnown);
      expectSamePlace(v, back);
    }
}

TEST(Vti, AsciiWithExtentDirectionAndCells) {
  TempFolder folder;
  Progress progress;
  std::ofstream(folder / "a.vti")
      << "<VTKFile type=\"ImageData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<ImageData WholeExtent=\"2 4 0 1 0 "
         "1\" Origin=\"10 0 0\" "
         "Spacing=\"2 1 1\" Direction=\"0 1 0 1 0 0 0 0 1\">\n<Piece Extent=\"2 4 0 1 0 1\"><CellData><DataArray "
         "type=\"Int16\" Name=\"v\" "
         "format=\"ascii\">-5 300</DataArray></CellData></Piece></ImageData></VTKFile>";
  Volume v = readVti(sourceOf(folder / "a.vti"), progress);
  EXPECT_EQ(v.dims, glm::ivec3(2, 1, 1));
  EXPECT_EQ(valueAt(v, {0, 0, 0}), -5);
  EXPECT_EQ(valueAt(v, {1, 0, 0}), 300);
  EXPECT_TRUE(v.isOrientationKnown);
  // x of the grid runs along y of the world; the centre of the first cell lies half a step in.
  EXPECT_NEAR(v.worldFromVoxel[0].y, 2, 1e-12);
  EXPECT_NEAR(v.worldFromVoxel[3].x, 10.5, 1e-12);
  EXPECT_NEAR(v.worldFromVoxel[3].y, 5, 1e-12);
}

TEST(Vti, EveryCutIsRefused) {
  TempFolder folder;
  Progress progress;
  Volume v = noise({40, 30, 20}, SampleType::UInt8, 1);
  writeVolume(v, folder / "a.vti", progress);
  std::string bytes = bytesOf(folder / "a.vti");
  for (std::size_t keep = 0; keep + 300 < bytes.size(); keep += 499) {
    std::ofstream(folder / "b.vti", std::ios::binary) << bytes.substr(0, keep);
    EXPECT_THROW(readVti(sourceOf(folder / "b.vti"), progress), InputError) << keep;
  }
}

TEST(Vti, DamagedVoxelsAreRefusedAndNotShown) {
  TempFolder folder;
  Progress progress;
  writeVolume(noise({40, 30, 20}, SampleType::UInt8, 1), folder / "a.vti", progress);
  std::string bytes = bytesOf(folder / "a.vti");
  std::size_t voxels = bytes.find('_', bytes.find("<AppendedData"));
  // Behind our notes, which are some 400 bytes.
  for (std::size_t at = voxels + 600; at + 300 < bytes.size(); at += 1511) {
    std::string bad = bytes;
    bad[at] = char(bad[at] ^ 0x55);
    std::ofstream(folder / "b.vti", std::ios::binary) << bad;
    EXPECT_THROW(readVti(sourceOf(folder / "b.vti"), progress), InputError) << at;
  }
}

TEST(Vti, AHostileExtentAllocatesNothing) {
  TempFolder folder;
  Progress progress;
  Volume v = noise({4, 4, 4}, SampleType::UInt8, 1);
  writeVolume(v, folder / "a.vti", progress);
  std::string bytes = bytesOf(folder / "a.vti");
  for (std::size_t at; (at = bytes.find("0 3 0 3 0 3")) != bytes.npos;)
    bytes.replace(at, 11, "0 99999 0 99999 0 99999");
  std::ofstream(folder / "a.vti", std::ios::binary) << bytes;
  EXPECT_THROW(readVti(sourceOf(folder / "a.vti"), progress), InputError);
}

TEST(Vti, CancelStops) {
  TempFolder folder;
  Progress progress;
  writeVolume(noise({64, 64, 64}, SampleType::UInt16, 1), folder / "a.vti", progress);
  Progress stopped;
  stopped.cancel();
  EXPECT_THROW(readVti(sourceOf(folder / "a.vti"), stopped), Cancelled);
}

TEST(VtkLegacy, AsciiAndBinary) {
  TempFolder folder;
  Progress progress;
  std::string head = "# vtk DataFile Version 3.0\ntitle\n";
  std::string grid =
      "DATASET STRUCTURED_POINTS\nDIMENSIONS 3 2 1\nORIGIN 1 2 3\nSPACING 0.5 1 2\nPOINT_DATA 6\nSCALARS s short "
      "1\nLOOKUP_TABLE default\n";
  std::ofstream(folder / "a.vtk") << head << "ASCII\n" << grid << "1 -2 3\n4 5 600";
  Volume a = readVtkLegacy(sourceOf(folder / "a.vtk"), progress);
  std::string samples;
  for (int value : {1, -2, 3, 4, 5, 600}) samples += {char(std::uint16_t(value) >> 8), char(value & 0xff)};
  std::ofstream(folder / "b.vtk", std::ios::binary) << head << "BINARY\n" << grid << samples << "\n";
  Volume b = readVtkLegacy(sourceOf(folder / "b.vtk"), progress);
  EXPECT_EQ(a.dims, glm::ivec3(3, 2, 1));
  EXPECT_TRUE(a.voxels == b.voxels);
  EXPECT_EQ(valueAt(a, {2, 1, 0}), 600);
  EXPECT_EQ(spacingOf(a), glm::dvec3(0.5, 1, 2));
  std::ofstream(folder / "c.vtk") << head << "ASCII\n" << grid << "1 -2 3\n4 5";
  EXPECT_THROW(readVtkLegacy(sourceOf(folder / "c.vtk"), progress), InputError);
}

TEST(Vdb, RoundTripKeepsValuesPlaceAndShape) {
  TempFolder folder;
  Progress progress;
  for (auto type : {SampleType::UInt8, SampleType::Int16, SampleType::Float32}) {
    Volume v = noise({19, 8, 21}, type, 1);
    std::memset(v.voxels.data(), 0, v.voxels.size() / 2);  // background at an edge must not shrink the grid
    v.scale = 0.5;
    v.offset = 3;
    computeRange(v);
    writeVolume(v, folder / "a.vdb", progress);
    Volume back = readVdb(sourceOf(folder / "a.vdb"), progress);
    ASSERT_EQ(back.dims, v.dims);
    for (int z = 0; z < 21; ++z)
      for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 19; ++x) ASSERT_EQ(valueAt(back, {x, y, z}), valueAt(v, {x, y, z}));
    expectSamePlace(v, back);
    EXPECT_TRUE(back.isOrientationKnown);
  }
}

TEST(Vdb, EveryCutIsRefused) {
  TempFolder folder;
  Progress progress;
  writeVolume(noise({24, 24, 24}, SampleType::UInt8, 1), folder / "a.vdb", progress);
  std::string bytes = bytesOf(folder / "a.vdb");
  for (std::size_t keep = 0; keep + 64 < bytes.size(); keep += 997) {
    std::ofstream(folder / "b.vdb", std::ios::binary) << bytes.substr(0, keep);
    EXPECT_THROW(readVdb(sourceOf(folder / "b.vdb"), progress), InputError) << keep;
  }
}

TEST(Writers, RefuseWhatTheFormatCannotHold) {
  TempFolder folder;
  Progress progress;
  Volume v = noise({4, 4, 4}, SampleType::UInt8, 3);
  EXPECT_THROW(writeVolume(v, folder / "a.vdb", progress), InputError);
  v.timeSteps = 2;
  EXPECT_THROW(writeVolume(v, folder / "a.vti", progress), InputError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Raw, LayoutsAndTheirSizes) {
  TempFolder folder;
  Progress progress;
  std::ofstream(folder / "a.raw", std::ios::binary) << std::string("HDR\x01\x02\x03\x04\x05\x06\x07\x08", 11);
  scene::Source source = sourceOf(folder / "a.raw");
  source.raw = {{2, 2, 1}, SampleType::UInt16, 1, true, 3};
  Volume v = readRaw(source, progress);
  EXPECT_EQ(valueAt(v, {1, 0, 0}), 0x0304);
  EXPECT_FALSE(v.isSpacingKnown);
  source.raw.headerBytes = 2;
  try {
    readRaw(source, progress);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("10 bytes"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("has 11"), std::string::npos) << error.what();
  }
  source.raw = {{65535, 65535, 65535}, SampleType::Float64, 4, false, 0};
  EXPECT_THROW(readRaw(source, progress), InputError);
}

TEST(Raw, GzipIsReadAndMeasured) {
  TempFolder folder;
  Progress progress;
  gzFile out = gzopen((folder / "a.raw.gz").c_str(), "wb");
  gzwrite(out, "12345678", 8);
  gzclose(out);
  scene::Source source = sourceOf(folder / "a.raw.gz");
  source.raw = {{2, 2, 2}, SampleType::UInt8, 1, false, 0};
  EXPECT_EQ(valueAt(readRaw(source, progress), {1, 1, 1}), '8');
  for (int z : {1, 3}) {
    source.raw.dims.z = z;
    EXPECT_THROW(readRaw(source, progress), InputError);
  }
}

TEST(Mesh, EveryFormatGivesTrianglesWithUnitNormals) {
  TempFolder folder;
  Progress progress;
  std::ofstream(folder / "a.obj") << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
  std::ofstream(folder / "a.ply")
      << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face "
         "1\n"
         "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  std::ofstream(folder / "a.stl") << "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
                                     "0\nendloop\nendfacet\nendsolid a\n";
  for (auto [name, triangles] : {std::pair{"a.obj", 2u}, {"a.ply", 1u}, {"a.stl", 1u}}) {
    Mesh mesh = readMesh(folder / name, progress);
    EXPECT_EQ(mesh.indices.size(), 3 * triangles) << name;
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size()) << name;
    for (auto n : mesh.normals) EXPECT_NEAR(n.z, 1.0f, 1e-6) << name;
  }
}

TEST(Mesh, DamageIsRefused) {
  TempFolder folder;
  Progress progress;
  std::ofstream(folder / "a.ply") << "ply\nformat binary_little_endian 1.0\nelement vertex 999999999\nproperty float "
                                     "x\nproperty float y\nproperty float "
                                     "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  std::ofstream(folder / "b.ply")
      << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face "
         "1\n"
         "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 70000\n";
  std::ofstream(folder / "a.stl", std::ios::binary)
      << std::string(80, 'x') << "\xff\xff\xff\x7f" << std::string(50, 'x');
  std::ofstream(folder / "a.obj") << "nothing\n";
  std::ofstream(folder / "a.vtp") << "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"99999999999\"";
  for (const char* name : {"a.ply", "b.ply", "a.stl", "a.obj", "a.vtp", "none.stl"})
    EXPECT_THROW(readMesh(folder / name, progress), InputError) << name;
}

}  // namespace
}  // namespace velum::io
