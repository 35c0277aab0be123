// Drivers differ in what they let pass: every variant of every shader is also compiled by Khronos' reference compiler.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <vector>

#include "SourceFolder.h"
#include "TempFolder.h"
#include "allPrograms.h"

namespace velum::gpu {
namespace {

struct Answer {
  std::string text;
  int status = 0;
};

Answer run(const std::string& command) {
  Answer answer;
  FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  if (!pipe) return {"cannot be started", -1};
  std::array<char, 4096> part;
  while (std::size_t count = std::fread(part.data(), 1, part.size(), pipe)) answer.text.append(part.data(), count);
  answer.status = ::pclose(pipe);
  return answer;
}

class ReferenceCompiler : public testing::Test {
 protected:
  void SetUp() override {
    if (run("glslangValidator --version").status != 0)
      GTEST_SKIP() << "glslangValidator is not there: install Debian's glslang-tools";
  }
};

/// Writes one variant's text, whole, as the drivers see it.
void write(const std::filesystem::path& path, const std::string& file, const Defines& defines) {
  std::ofstream(path) << expandedShader(file, defines);
}

TEST_F(ReferenceCompiler, AcceptsEveryVariantOfEveryShader) {
  TempFolder folder;
  std::string command = "cd " + folder.path().string() + " && glslangValidator", list;
  int variants = 0;
  for (const ProgramSource& program : allPrograms())
    for (const std::string& file : program.files) {
      std::string name = std::to_string(variants++) + file.substr(file.rfind('.'));
      write(folder / name, file, program.defines);
      command += " " + name;
      list += name + ": " + textOf(program) + "\n";
    }
  Answer answer = run(command);
  EXPECT_EQ(answer.status, 0) << list << answer.text;
  EXPECT_GE(variants, 124);
}

/// How often a word stands in a text.
int countWord(const std::string& text, const std::string& word) {
  auto isPart = [&](std::size_t at) { return at < text.size() && (std::isalnum(text[at]) || text[at] == '_'); };
  int count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    count += !isPart(at - 1) && !isPart(at + word.size());
  return count;
}

/// Of what OpenGL promises few of: how many a shader has.
struct Wants {
  int samplers = 0, images = 0, storageBlocks = 0, uniformBlocks = 0;
};

/// @param text  preprocessed. What is declared and not used by any function does not count.
Wants wantsOf(const std::string& text) {
  static const std::regex kSampler(R"(uniform [iu]?sampler\w+ +(\w+))"), kImage(R"(uniform .*[iu]?image\w+ +(\w+))");
  Wants wants;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("layout")) continue;
    std::smatch found;
    if (line.find(" buffer ") != std::string::npos)
      ++wants.storageBlocks;
    else if (line.find("std140") != std::string::npos)
      ++wants.uniformBlocks;
    else if (std::regex_search(line, found, kSampler))
      wants.samplers += countWord(text, found[1]) > 1;
    else if (std::regex_search(line, found, kImage))
      wants.images += countWord(text, found[1]) > 1;
  }
  return wants;
}

TEST_F(ReferenceCompiler, NoShaderWantsMoreThanOpenGlPromises) {
  TempFolder folder;
  std::string command = "cd " + folder.path().string() + " && glslangValidator -E";
  std::vector<std::string> names;
  for (const ProgramSource& program : allPrograms())
    for (const std::string& file : program.files) {
      std::string name = std::to_string(names.size()) + file.substr(file.rfind('.'));
      write(folder / name, file, program.defines);
      command += " " + name;
      names.push_back(file + " of " + textOf(program));
    }
  // One text after the other, each from its version on.
  std::string all = run(command).text;
  std::size_t shader = 0;
  Wants most;
  for (std::size_t at = all.find("#version"); at != std::string::npos; ++shader) {
    std::size_t end = all.find("#version", at + 1);
    ASSERT_LT(shader, names.size());
    Wants wants = wantsOf(all.substr(at, end - at));
    at = end;
    // OpenGL 4.5, tables 23.59 to 23.72: of a fragment or a compute shader; a vertex shader is promised less.
    bool isOfVertices = names[shader].find(".vert of") != std::string::npos;
    EXPECT_LE(wants.samplers, 16) << names[shader];
    EXPECT_LE(wants.images, isOfVertices ? 0 : 8) << names[shader];
    EXPECT_LE(wants.storageBlocks, isOfVertices ? 0 : 8) << names[shader];
    EXPECT_LE(wants.uniformBlocks, 12) << names[shader];
    most = {std::max(most.samplers, wants.samplers), std::max(most.images, wants.images),
            std::max(most.storageBlocks, wants.storageBlocks), std::max(most.uniformBlocks, wants.uniformBlocks)};
  }
  EXPECT_EQ(shader, names.size());
  // Patterns that find nothing would let everything pass.
  EXPECT_GE(most.samplers, 10);
  EXPECT_GE(most.images, 4);
  EXPECT_GE(most.storageBlocks, 5);
  EXPECT_GE(most.uniformBlocks, 3);
}

TEST(Bindings, AreThoseThatOpenGlPromises) {
  // OpenGL 4.5, tables 23.69 to 23.72. Of uniform blocks there may be more.
  std::regex row(R"(SHARED_CONST uint k\w+(Binding|Image|Unit) = (\d+)u;)");
  int rows = 0;
  for (const auto& entry : std::filesystem::directory_iterator(sourceFolder() / "shaders" / "shared")) {
    std::ifstream in(entry.path());
    for (std::string line; std::getline(in, line);) {
      std::smatch found;
      if (!std::regex_search(line, found, row)) continue;
      ++rows;
      EXPECT_LT(std::stoi(found[2]), found[1] == "Unit" ? 96 : 8) << entry.path() << ": " << line;
    }
  }
  EXPECT_GT(rows, 50);
}

TEST_F(ReferenceCompiler, RefusesWhatIsWrong) {
  TempFolder folder;
  std::ofstream(folder / "a.comp") << "#version 450 core\nlayout(local_size_x = 1) in;\nvoid main() {}\n";
  std::ofstream(folder / "b.comp") << "#version 450 core\nlayout(local_size_x = 1) in;\nvoid main() { int i = 1.5; }\n";
  std::string in = "cd " + folder.path().string() + " && glslangValidator ";
  EXPECT_EQ(run(in + "a.comp").status, 0);
  EXPECT_NE(run(in + "a.comp b.comp").status, 0);
  EXPECT_NE(run(in + "b.comp a.comp").status, 0);
}

}  // namespace
}  // namespace velum::gpu
