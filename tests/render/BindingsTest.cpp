// shaders/shared/bindings.h keeps what its first sentence promises, and shaders bind by its names alone.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "SourceFolder.h"
#include "allPrograms.h"
#include "shared/bindings.h"

namespace velum {
namespace {

/// What OpenGL 4.5 promises at least: tables 23.60 to 23.68.
constexpr unsigned kUnits = 96, kUniformBlocks = 84, kStorageBlocks = 8, kImages = 8;

std::string readText(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// The lines that match, as (name, value) or (name, kind of block).
std::multimap<std::string, std::string> matchesIn(const std::string& text, const char* pattern) {
  std::multimap<std::string, std::string> found;
  std::regex regex(pattern);
  for (std::sregex_iterator i(text.begin(), text.end(), regex), end; i != end; ++i) found.emplace((*i)[1], (*i)[2]);
  return found;
}

/// The constants of the header whose names end like that.
std::map<std::string, unsigned> constantsOf(const std::string& kind) {
  std::map<std::string, unsigned> constants;
  std::string header = readText(sourceFolder() / "shaders/shared/bindings.h");
  for (const auto& [name, value] : matchesIn(header, ("SHARED_CONST uint (k\\w+" + kind + ") = (\\d+)u;").c_str()))
    constants[name] = unsigned(std::stoul(value));
  return constants;
}

/// Names of the blocks that a text has, std140 or std430.
std::set<std::string> blocksIn(const std::string& text, const std::string& layout) {
  std::set<std::string> blocks;
  for (const auto& [name, end] : matchesIn(text, ("\n\\s*layout\\(" + layout + ", binding = (\\w+)(\\))").c_str()))
    blocks.insert(name);
  return blocks;
}

void expectApart(const std::map<std::string, unsigned>& constants, unsigned most) {
  std::map<unsigned, std::string> takenBy;
  for (const auto& [name, place] : constants) {
    EXPECT_LT(place, most) << name << ": more than OpenGL promises";
    auto [taken, isNew] = takenBy.emplace(place, name);
    EXPECT_TRUE(isNew) << name << " and " << taken->second << " want one place";
  }
}

/// The texts of all shaders that a picture is made by, with all that any variant has. Sheets' cloth is worked on
/// between pictures, by the list of shared/cloth.h.
std::vector<std::string> texts() {
  std::set<std::string> files;
  for (const auto& program : allPrograms()) files.insert(program.files.begin(), program.files.end());
  std::vector<std::string> texts;
  for (const std::string& file : files) {
    std::string text = gpu::expandedShader(file);
    bool isOfPictures = !file.starts_with("bench/") && text.find("kClothBinding") == std::string::npos;
    if (isOfPictures) texts.push_back("\n" + text);
  }
  return texts;
}

TEST(Bindings, NoUnitIsGivenTwice) {
  auto units = constantsOf("Unit");
  ASSERT_GT(units.size(), 30u);
  expectApart(units, kUnits);
}

TEST(Bindings, NoBlockOfAFrameHasItsPlaceFromAnother) {
  auto places = constantsOf("Binding");
  std::set<std::string> uniform, storage;
  for (const std::string& text : texts()) {
    uniform.merge(blocksIn(text, "std140"));
    storage.merge(blocksIn(text, "std430"));
  }
  ASSERT_GT(uniform.size(), 4u);
  ASSERT_GT(storage.size(), 10u);
  std::map<std::string, unsigned> ofUniform, ofFrame;
  for (const auto& [name, place] : places) {
    if (uniform.contains(name)) ofUniform[name] = place;
    if (storage.contains(name) && place < shared::kFirstLent) ofFrame[name] = place;
    if (storage.contains(name)) {
      EXPECT_LT(place, kStorageBlocks) << name;
    }
  }
  EXPECT_EQ(ofUniform.size(), uniform.size()) << "each by its name";
  EXPECT_EQ(ofFrame.size(), shared::kFirstLent);
  expectApart(ofUniform, kUniformBlocks);
  expectApart(ofFrame, shared::kFirstLent);
}

TEST(Bindings, NoProgramWantsTwoBlocksInOnePlace) {
  auto places = constantsOf("Binding");
  for (const std::string& text : texts()) {
    std::map<std::string, unsigned> own;
    for (const std::string& name : blocksIn(text, "std430")) {
      ASSERT_TRUE(places.contains(name)) << name;
      own[name] = places[name];
    }
    expectApart(own, kStorageBlocks);
  }
}

TEST(Bindings, ImagesAreAsManyAsArePromised) {
  auto images = constantsOf("Image");
  ASSERT_GT(images.size(), 10u);
  for (const auto& [name, place] : images) EXPECT_LT(place, kImages) << name;
}

TEST(Bindings, NoShaderBindsByANumber) {
  for (const std::string& text : texts())
    for (const auto& [number, end] : matchesIn(text, "\n\\s*layout\\([^)]*binding = (\\d+)([^\n]*)"))
      ADD_FAILURE() << "binding = " << number << end;
}

}  // namespace
}  // namespace velum
