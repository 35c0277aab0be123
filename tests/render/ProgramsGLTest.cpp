// Every program that a frame or a sheet can ask for is one that the driver takes.
#include <algorithm>
#include <set>

#include "GlFixture.h"
#include "allPrograms.h"
#include "passes/Variants.h"
#include "shared/frame.h"

namespace velum {
namespace {

constexpr int kShares = 4;

class ShaderGL : public GlTest, public testing::WithParamInterface<int> {};

gpu::Program make(const gpu::ProgramSource& source) {
  return source.files.size() == 1 ? gpu::Program({source.files[0]}, source.defines)
                                  : gpu::Program({source.files[0], source.files[1]}, source.defines);
}

TEST_P(ShaderGL, EveryEntryPointCompilesInEveryVariant) {
  auto all = allPrograms();
  for (std::size_t i = std::size_t(GetParam()); i < all.size(); i += kShares) {
    SCOPED_TRACE(textOf(all[i]));
    EXPECT_NO_THROW(make(all[i]));
  }
}
INSTANTIATE_TEST_SUITE_P(Share, ShaderGL, testing::Range(0, kShares));

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
  for (std::uint32_t flag = 1; flag <= shared::kFlagLast; flag *= 2)
    EXPECT_TRUE(sets.contains(std::to_string(flag) + "u")) << flag;
  EXPECT_TRUE(sets.contains(std::to_string(2 * shared::kFlagLast - 1) + "u")) << "all of them";
}

}  // namespace
}  // namespace velum
