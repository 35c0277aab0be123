#include "core/ImageChannels.h"

#include <gtest/gtest.h>

namespace velum {
namespace {

TEST(ImageChannels, ChannelsComeInTheOrderNamedAndThoseThatAreNotThereDoNot) {
  Image image{2, 1, {"R", "G", "A"}, {1, 2, 3, 4, 5, 6}};
  Image picked = channelsOf(image, {"A", "Z", "R"});
  EXPECT_EQ(picked.channels, (std::vector<std::string>{"A", "R"}));
  EXPECT_EQ(picked.pixels, (std::vector<float>{3, 1, 6, 4}));
  EXPECT_EQ(channelIndex(image, "G"), 1);
  EXPECT_EQ(channelIndex(image, "Z"), -1);
}

}  // namespace
}  // namespace velum
