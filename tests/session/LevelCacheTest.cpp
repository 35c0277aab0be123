#include "session/model/LevelCache.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <random>

#include "SmallDisk.h"
#include "TempFolder.h"
#include "core/Error.h"
#include "core/ModelBuilder.h"
#include "model/Levels.h"

namespace velum::session {
namespace {

namespace fs = std::filesystem;

/// A molecule of atoms and one of beads.
Model modelOf(unsigned seed, std::size_t atoms = 600) {
  std::mt19937 random(seed);
  auto place = [&] {
    auto number = [&] { return float(random() % 10000) * 0.006f; };
    float x = number(), y = number(), z = number();
    return glm::vec3(x, y, z);
  };
  ModelBuilder builder("balls");
  MoleculeType type;
  type.name = "one";
  std::uint32_t number = builder.addType(type);
  std::vector<Atom> all;
  for (std::size_t i = 0; i < atoms; ++i) all.push_back({place(), std::uint8_t(6 + i % 3), std::uint16_t(i / 100)});
  builder.addInstance(builder.addMolecule(number, all), {}, {1, 0, 0, 0});
  std::vector<glm::vec4> beads;
  for (int i = 0; i < 50; ++i) beads.emplace_back(place(), 5.0f);
  builder.addInstance(builder.addMolecule(number, {}, {beads}), {100, 0, 0}, {1, 0, 0, 0});
  return builder.build();
}

std::string bytesOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}
void put(const fs::path& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

std::size_t filesIn(const fs::path& folder) {
  return std::size_t(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

LevelSet computed(const Model& model) {
  Progress progress;
  return model::computeLevels(model, progress);
}
LevelSet cached(const Model& model, const fs::path& folder, std::uint64_t most = kMostLevelCacheBytes) {
  Progress progress;
  return cachedLevels(model, folder, progress, most);
}

/// Whether levels come from the file: one with another ball, and a check sum that fits, would need to know ours, so
/// the time tells when it was used.
bool isUsed(const Model& model, const fs::path& folder) {
  fs::path file = levelFile(model, folder);
  auto old = fs::file_time_type::clock::now() - std::chrono::hours(5);
  auto before = bytesOf(file);
  ::link(file.c_str(), (folder / "same").c_str());  // a file that is written anew is another one
  fs::last_write_time(file, old);
  cached(model, folder);
  bool isSame = fs::equivalent(file, folder / "same");
  fs::remove(folder / "same");
  return isSame && fs::last_write_time(file) > old && bytesOf(file) == before;
}

TEST(LevelCache, ColdAndWarmAreTheSameAsComputed) {
  TempFolder folder;
  Model model = modelOf(1);
  LevelSet wanted = computed(model);
  ASSERT_GT(wanted.levels.size(), 4u);
  EXPECT_EQ(cached(model, folder / "a/b"), wanted);
  EXPECT_TRUE(fs::exists(levelFile(model, folder / "a/b")));
  EXPECT_EQ(cached(model, folder / "a/b"), wanted);
  EXPECT_TRUE(isUsed(model, folder / "a/b"));
  EXPECT_EQ(filesIn(folder / "a/b"), 1u);
}

TEST(LevelCache, ItsFileIsNamedByWhatLevelsAreMadeOf) {
  Model model = modelOf(1), moved = model, colored = model, larger = model, of = model;
  moved.instances[0].position.x = 7;
  EXPECT_EQ(levelFile(moved, ""), levelFile(model, "")) << "not by instances";
  colored.molecules[0].atoms[5].chain += 1;
  larger.molecules[1].beads[0][3].w = 6;
  of.molecules[0].atoms[5].position.y += 1e-4f;
  EXPECT_NE(levelFile(colored, ""), levelFile(model, ""));
  EXPECT_NE(levelFile(larger, ""), levelFile(model, ""));
  EXPECT_NE(levelFile(of, ""), levelFile(model, ""));
}

TEST(LevelCache, FilesThatAreCutAlteredOrForeignAreIgnoredAndReplaced) {
  TempFolder folder;
  Model model = modelOf(1);
  LevelSet wanted = cached(model, folder.path());
  fs::path file = levelFile(model, folder.path());
  const std::string whole = bytesOf(file);
  std::vector<std::string> wrong{"", "VELUMLOD", whole + "x", std::string(whole.size(), '\0')};
  std::mt19937 random(3);
  for (int i = 0; i < 30; ++i) wrong.push_back(whole.substr(0, random() % whole.size()));
  for (int i = 0; i < 200; ++i) {
    std::string one = whole;
    one[i < 70 ? std::size_t(i) : random() % one.size()] ^= char(1 + random() % 255);
    wrong.push_back(one);
  }
  TempFolder other;
  Model another = modelOf(2);
  cached(another, other.path());
  wrong.push_back(bytesOf(levelFile(another, other.path())));  // whole, and of another model of the same sizes
  for (const std::string& bytes : wrong) {
    put(file, bytes);
    ASSERT_EQ(cached(model, folder.path()), wanted);
    ASSERT_EQ(bytesOf(file), whole);
  }
}

TEST(LevelCache, HoldsAsMuchAsItMayAndWhatWasUsedLast) {
  TempFolder folder;
  cached(modelOf(1), folder.path());
  const std::uint64_t one = fs::file_size(levelFile(modelOf(1), folder.path())), most = one * 7 / 2;
  fs::file_time_type when = fs::file_time_type::clock::now() - std::chrono::hours(9);
  put(folder / "note.txt", std::string(one * 9, 'x'));  // not its own: left alone, and not counted
  for (unsigned seed = 1; seed <= 3; ++seed) {
    cached(modelOf(seed), folder.path(), most);
    fs::last_write_time(levelFile(modelOf(seed), folder.path()), when += std::chrono::minutes(1));
  }
  cached(modelOf(1), folder.path(), most);  // used again
  cached(modelOf(4), folder.path(), most);
  EXPECT_FALSE(fs::exists(levelFile(modelOf(2), folder.path())));
  for (unsigned seed : {1u, 3u, 4u}) EXPECT_TRUE(fs::exists(levelFile(modelOf(seed), folder.path()))) << seed;
  EXPECT_TRUE(fs::exists(folder / "note.txt"));
  // One that is larger than all may be is not kept, and nothing goes for it.
  Model large = modelOf(5, 8000);
  EXPECT_EQ(cached(large, folder.path(), most), computed(large));
  EXPECT_FALSE(fs::exists(levelFile(large, folder.path())));
  EXPECT_TRUE(fs::exists(levelFile(modelOf(4), folder.path())));
}

TEST(LevelCache, WithoutAFolderThatTakesItLevelsAreComputed) {
  TempFolder folder;
  Model model = modelOf(1);
  LevelSet wanted = computed(model);
  EXPECT_EQ(cached(model, ""), wanted);
  put(folder / "file", "no folder");
  EXPECT_EQ(cached(model, folder / "file"), wanted);
  EXPECT_EQ(cached(model, folder / "file/below"), wanted);
  EXPECT_EQ(cached(model, "/proc/none/levels"), wanted);
  fs::create_directories(levelFile(model, folder / "odd"));  // a folder has its name
  put(levelFile(model, folder / "odd") / "x", "x");
  EXPECT_EQ(cached(model, folder / "odd"), wanted);
  {
    SmallDisk disk(100);
    EXPECT_EQ(cached(model, folder / "full"), wanted);
  }
  EXPECT_EQ(filesIn(folder / "full"), 0u) << "no half of it stays";
}

TEST(LevelCache, WhatIsCancelledIsNotKept) {
  TempFolder folder;
  Progress progress;
  progress.cancel();
  EXPECT_THROW(cachedLevels(modelOf(1), folder.path(), progress), Cancelled);
  EXPECT_EQ(filesIn(folder.path()), 0u);
}

}  // namespace
}  // namespace velum::session
