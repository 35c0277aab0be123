#include <algorithm>
#include <functional>
#include <iterator>
#include <random>
#include <vector>

#include "SmallDisk.h"
#include "TestFiles.h"
#include "core/Error.h"
#include "core/Mesh.h"
#include "io/images/ImageFile.h"
#include "io/looks/TransferFile.h"
#include "io/meshes/WriteMesh.h"
#include "io/models/WriteModel.h"
#include "makeModel.h"
#include "makeVolume.h"

/// On a disk that fills up at any byte, each writer leaves the file that was there, says so in one line, and leaves
/// nothing else.
namespace velum::io {
namespace {

namespace fs = std::filesystem;

/// Too rough to be deflated to less than a few pieces of every library's buffers.
Volume roughVolume() {
  std::mt19937 random(7);
  return makeVolume({40, 30, 20}, SampleType::Int16, [&](glm::ivec3) { return int(random() % 30000); });
}

LabelVolume roughLabels() {
  std::mt19937 random(7);
  LabelVolume labels({40, 30, 20}, glm::dmat4(1.0));
  std::vector<std::uint16_t> ids(40 * 30 * 20);
  for (auto& id : ids) id = std::uint16_t(random() % 200);
  labels.write({0, 0, 0}, {40, 30, 20}, ids);
  return labels;
}

Image roughPicture() {
  std::mt19937 random(7);
  Image image{90, 70, {"R", "G", "B"}, {}};
  image.pixels.resize(90 * 70 * 3);
  for (float& v : image.pixels) v = float(random() % 256) / 255.0f;
  return image;
}

Mesh fan() {
  Mesh mesh;
  constexpr std::uint32_t kCorners = 800;
  for (std::uint32_t i = 0; i < kCorners; ++i) {
    mesh.positions.emplace_back(std::cos(float(i)) * 10.0f, std::sin(float(i)) * 10.0f, float(i) * 0.37f);
    mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
    if (i > 1) mesh.indices.insert(mesh.indices.end(), {0, i - 1, i});
  }
  return mesh;
}

struct Writer {
  const char* name;  ///< Of the file.
  std::function<void(const fs::path&)> write;
};

std::vector<Writer> everyWriter() {
  std::vector<Writer> all;
  for (const char* name : {"v.nrrd", "v.nii", "v.nii.gz", "v.vti", "v.vdb"})
    all.push_back({name, [](const fs::path& path) { write(roughVolume(), path); }});
  for (const char* name : {"l.seg.nrrd", "l.nii.gz", "l.dcm"})
    all.push_back({name, [](const fs::path& path) {
                     Progress progress;
                     writeLabels(roughLabels(), path, progress);
                   }});
  for (const char* name : {"p.png", "p.tif", "p.exr"})
    all.push_back({name, [](const fs::path& path) { writeImage(roughPicture(), path, "a scene"); }});
  for (const char* name : {"m.obj", "m.ply", "m.vtp", "m.stl", "m.glb"})
    all.push_back({name, [](const fs::path& path) { writeMesh(fan(), path); }});
  for (const char* name : {"i.cif", "i.cif.gz", "i.glb", "i.csv", "i.ply"})
    all.push_back({name, [](const fs::path& path) {
                     Progress progress;
                     writeModel(ModelMaker{.instances = 300}.make(), path, progress);
                   }});
  for (const char* name : {"t.velum-transfer.json", "t.vp.json", "t.vp"})
    all.push_back({name, [](const fs::path& path) { writeTransferFile({}, {}, 1.0, path); }});
  return all;
}

std::ptrdiff_t filesIn(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

/// Writes onto a disk that takes `bytes`. @return what was said; empty when it was written
std::string trySmallDisk(const Writer& writer, const fs::path& path, std::uintmax_t bytes) {
  SmallDisk disk(bytes);
  try {
    writer.write(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

class FullDisk : public testing::TestWithParam<std::size_t> {};

TEST_P(FullDisk, TheOldFileStaysWhole) {
  Writer writer = everyWriter()[GetParam()];
  TempFolder folder;
  fs::path path = folder / writer.name;
  writer.write(path);
  std::uintmax_t size = fs::file_size(path);
  const std::string old = "a file that was good";
  constexpr int kTimes = 60;
  std::mt19937 random(11);
  for (int i = 0; i < kTimes; ++i) {
    // The last bytes are those that libraries write when they close.
    std::uintmax_t room = i < 10 ? size - 1 - std::uintmax_t(i) : random() % size;
    writeText(path, old);
    std::string said = trySmallDisk(writer, path, room);
    ASSERT_TRUE(said.starts_with(path.string() + ": ")) << room << " of " << size << " bytes: '" << said << "'";
    ASSERT_EQ(std::count(said.begin(), said.end(), '\n'), 0) << said;
    ASSERT_EQ(bytesOf(path), old) << room << " of " << size << " bytes";
    ASSERT_EQ(filesIn(folder.path()), 1);
  }
  EXPECT_EQ(trySmallDisk(writer, path, size), "") << "the disk has room for all of it";
  EXPECT_EQ(fs::file_size(path), size);
}

INSTANTIATE_TEST_SUITE_P(EveryWriter, FullDisk, testing::Range(std::size_t(0), everyWriter().size()),
                         [](const testing::TestParamInfo<std::size_t>& p) {
                           std::string name = everyWriter()[p.param].name;
                           std::replace_if(
                               name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
                           return name;
                         });

}  // namespace
}  // namespace velum::io
