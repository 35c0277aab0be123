// Drivers differ in what they let pass: every variant of every shader is also compiled by Khronos' reference compiler.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <fstream>

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
