#include "core/Fields.h"

#include <gtest/gtest.h>

#include <cctype>

#include "core/Volume.h"

namespace velum {
namespace {

TEST(EnumValue, IsTheInverseOfEnumName) {
  for (int i = 0; i < 8; ++i) EXPECT_EQ(enumValue<SampleType>(enumName(SampleType(i))), SampleType(i));
}

TEST(EnumValue, UnknownNamesHaveNone) {
  EXPECT_EQ(enumValue<SampleType>("uint9"), std::nullopt);
  EXPECT_EQ(enumValue<SampleType>(""), std::nullopt);
  EXPECT_EQ(enumValue<Modality>("ct"), std::nullopt);
}

TEST(EnumValue, ComparesAsItIsTold) {
  auto isSame = [](std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
  };
  EXPECT_EQ(enumValue<Modality>("ct", isSame), Modality::CT);
}

}  // namespace
}  // namespace velum
