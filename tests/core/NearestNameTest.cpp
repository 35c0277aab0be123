#include "core/NearestName.h"

#include <gtest/gtest.h>

namespace velum {
namespace {

const std::vector<std::string> kNames{"RNA", "HIV1_envelope_ENV_4nco", "ENV_trimer", "Envelope", "capsid", "render"};

TEST(NearestName, APartOfANameIsMeantBeforeANameThatIsSpeltAlike) {
  EXPECT_EQ(nearestName("ENV", kNames), "Envelope");
  EXPECT_EQ(nearestName("env_", kNames), "ENV_trimer");
  EXPECT_EQ(nearestName("4NCO", kNames), "HIV1_envelope_ENV_4nco");
}

TEST(NearestName, MistypedLettersAreForgivenUpToAThird) {
  EXPECT_EQ(nearestName("rendre", kNames), "render");
  EXPECT_EQ(nearestName("Capsit", kNames), "capsid");
  EXPECT_EQ(nearestName("haemoglobin", kNames), "");
}

TEST(NearestName, OneThatIsNearIsAskedFor) {
  EXPECT_EQ(meantText("rendre", kNames), " (is 'render' meant?)");
  EXPECT_EQ(meantText("haemoglobin", kNames), "");
}

TEST(NearestName, TwoLettersAreInNamesByChance) { EXPECT_EQ(nearestName("an", kNames), ""); }

}  // namespace
}  // namespace velum
