// Every program that a frame or a sheet can ask for is one that the driver takes.
#include <algorithm>
#include <map>
#include <set>

#include "GlFixture.h"
#include "allPrograms.h"
#include "gpu/Gl.h"
#include "render/passes/Variants.h"
#include "shared/frame.h"

namespace velum {
namespace {

class ShaderGL : public GlTest {
 protected:
  /// The driver's compiler alone.
  static void expectCompiles(const std::string& file, const gpu::Defines& defines) {
    using gpu::gl;
    GLenum stage = file.ends_with(".comp")   ? GL_COMPUTE_SHADER
                   : file.ends_with(".vert") ? GL_VERTEX_SHADER
                                             : GL_FRAGMENT_SHADER;
    std::string text = gpu::expandedShader(file, defines), log(16384, '\0');
    const char* start = text.c_str();
    GLuint shader = gl().CreateShader(stage);
    gl().ShaderSource(shader, 1, &start, nullptr);
    gl().CompileShader(shader);
    GLint isCompiled = 0;
    gl().GetShaderiv(shader, GL_COMPILE_STATUS, &isCompiled);
    GLsizei length = 0;
    gl().GetShaderInfoLog(shader, GLsizei(log.size()), &length, log.data());
    gl().DeleteShader(shader);
    EXPECT_TRUE(isCompiled) << log.substr(0, std::size_t(length));
  }
};

gpu::Program make(const gpu::ProgramSource& source) {
  return source.files.size() == 1 ? gpu::Program({source.files[0]}, source.defines)
                                  : gpu::Program({source.files[0], source.files[1]}, source.defines);
}

using Pairs = std::set<std::pair<std::string, std::string>>;

/// Each two of the words that a program is made with, and of those that others of its file are and it is not. All sets
/// of flags are one word: they only take away.
Pairs pairsOf(const gpu::ProgramSource& source, const std::set<std::string>& names) {
  std::vector<std::string> words{source.files[0]};
  for (const std::string& name : names) {
    auto is = std::find_if(source.defines.begin(), source.defines.end(), [&](auto& d) { return d.first == name; });
    words.push_back(name + (is == source.defines.end() ? " none" : name == "FLAGS" ? " some" : "=" + is->second));
  }
  Pairs pairs;
  for (const std::string& a : words)
    for (const std::string& b : words) pairs.emplace(source.files[0] + ": " + a, b);
  return pairs;
}

/// Some of the programs, with all pairs of words that any of them has.
std::vector<gpu::ProgramSource> coverPairs(const std::vector<gpu::ProgramSource>& all) {
  std::map<std::string, std::set<std::string>> names;
  for (const auto& source : all)
    for (const auto& [name, value] : source.defines) names[source.files[0]].insert(name);
  std::vector<Pairs> pairs;
  for (const auto& source : all) pairs.push_back(pairsOf(source, names[source.files[0]]));
  std::vector<gpu::ProgramSource> cover;
  for (Pairs seen;;) {
    // Take the first of those that bring most that is new.
    std::size_t best = 0, most = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      auto count = std::size_t(
          std::count_if(pairs[i].begin(), pairs[i].end(), [&](const auto& pair) { return !seen.contains(pair); }));
      if (count > most) most = count, best = i;
    }
    if (most == 0) return cover;
    cover.push_back(all[best]);
    seen.insert(pairs[best].begin(), pairs[best].end());
  }
}

TEST_F(ShaderGL, EveryEntryPointCompilesInEveryVariant) {
  for (const auto& source : allPrograms()) {
    SCOPED_TRACE(textOf(source));
    for (const std::string& file : source.files) expectCompiles(file, source.defines);
  }
}

/// Mesa takes seconds for some, so that software drivers are asked for those that cover all pairs of words; others for
/// each.
TEST_F(ShaderGL, EveryEntryPointLinksWithEachPairOfItsWords) {
  auto all = allPrograms(), asked = context().limits().isSoftware ? coverPairs(all) : all;
  // Drivers that can compile them side by side.
  std::vector<gpu::Program> programs;
  for (const auto& source : asked) {
    SCOPED_TRACE(textOf(source));
    EXPECT_NO_THROW(programs.push_back(make(source)));
  }
  for (const auto& program : programs) EXPECT_NO_THROW(program.use());
}

TEST(Programs, EveryEntryPointIsAskedForBySomebody) {
  std::set<std::string> known;
  for (const auto& source : allPrograms()) known.insert(source.files.begin(), source.files.end());
  for (const std::string& file : gpu::shaderEntryPoints()) EXPECT_TRUE(known.contains(file)) << file;
}

TEST(Programs, VariantsDifferInTheWordsThatTheyAreCompiledWith) {
  auto rays = render::allRayVariants();
  EXPECT_EQ(std::set(rays.begin(), rays.end()).size(), rays.size());
  std::set<gpu::Defines> words;
  for (const auto& variant : rays) words.insert(render::definesOf(variant));
  EXPECT_EQ(words.size(), rays.size());
  for (const char* word : {"MODE", "LABELS", "COLOR", "PACKED"}) {
    std::set<std::string> values;
    for (const auto& defines : words)
      for (const auto& [name, value] : defines)
        if (name == word) values.insert(value);
    EXPECT_EQ(values, (std::set<std::string>{"0", "1", "2"})) << word;
  }
}

TEST(Programs, EachFlagIsAmongTheSetsThatAreTried) {
  std::set<std::string> sets;
  for (const auto& source : allPrograms())
    for (const auto& [name, value] : source.defines)
      if (name == "FLAGS" && source.files[0] == "render/ray_cast.comp") sets.insert(value);
  for (std::uint32_t flag = 1; flag != 0; flag *= 2)
    EXPECT_NE(sets.contains(std::to_string(flag) + "u"), (flag & shared::kSwitches) != 0) << flag;
  EXPECT_TRUE(sets.contains(std::to_string((2 * shared::kFlagLast - 1) & ~shared::kSwitches) + "u")) << "all of them";
}

}  // namespace
}  // namespace velum
