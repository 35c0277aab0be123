// Several channels in one picture: the mixture's extinction is the sum of the channels', its colour their mean by
// extinction.
#include <functional>

#include "RenderFixture.h"
#include "render/upload/TransferTable.h"
#include "scene/Presets.h"

namespace velum {
namespace {

constexpr glm::ivec3 kChannelsDims(44, 40, 36);

class ChannelsGL : public RenderTest {
 protected:
  using ValueOf = std::function<double(glm::ivec3)>;

  /// Channels interleaved, values 0..200.
  static Volume interleaved(const std::vector<ValueOf>& channels, SampleType type = SampleType::UInt8) {
    int count = int(channels.size());
    Volume wide = makeVolume({kChannelsDims.x * count, kChannelsDims.y, kChannelsDims.z}, type, [&](glm::ivec3 p) {
      return channels[std::size_t(p.x % count)]({p.x / count, p.y, p.z});
    });
    wide.dims = kChannelsDims;
    wide.channels = count;
    wide.worldFromVoxel = centredFrame(kChannelsDims);
    wide.range = {0, 200};
    return wide;
  }
  static scene::Scene mixed(const std::vector<ValueOf>& channels, SampleType type = SampleType::UInt8) {
    scene::Scene scene = sceneOf(interleaved(channels, type));
    scene::completeChannels(scene.volume);
    for (auto& look : scene.volume.channels) {
      look.transfer.opacities = {{30, 0}, {190, 0.25}};
      look.transfer.unitDistance = 1.0;
    }
    lookAlong(scene, {0.5, -1, 0.35}, 110);
    scene.camera.fieldOfViewDeg = 32;
    return scene;
  }
  /// One channel of a mixed scene as a volume of its own.
  static scene::Scene alone(const scene::Scene& mixed, int channel) {
    scene::Scene scene = mixed;
    const Volume& all = *mixed.volume.data;
    Volume one = makeVolume(
        all.dims, all.type, [&](glm::ivec3 p) { return valueAt(all, p, channel); }, all.worldFromVoxel);
    one.range = all.range;
    scene.volume.data = Shared<Volume>(std::move(one));
    scene.volume.transfer = mixed.volume.channels[std::size_t(channel)].transfer;
    scene.volume.channels.clear();
    return scene;
  }
  static void showOnly(scene::Scene& scene, std::vector<int> shown) {
    for (int c = 0; c < int(scene.volume.channels.size()); ++c)
      scene.volume.channels[std::size_t(c)].visible = std::find(shown.begin(), shown.end(), c) != shown.end();
  }
};

double ballAt(glm::ivec3 p, glm::dvec3 centre, double radius) {
  return 200.0 * std::clamp((radius + 4 - glm::length(glm::dvec3(p) - centre)) / 8.0, 0.0, 1.0);
}
double left(glm::ivec3 p) { return ballAt(p, {15, 20, 18}, 9); }
double right(glm::ivec3 p) { return ballAt(p, {28, 20, 18}, 9); }
double ramp(glm::ivec3 p) { return 200.0 * p.z / (kChannelsDims.z - 1); }

TEST_F(ChannelsGL, OneVisibleChannelIsTheSameTransferFunctionOnThatChannelAlone) {
  // Texels of a mixture hold the root of the extinction in eight bits, and what lies between two voxels is mixed from
  // them rather than looked up: a few steps of 255, where the transfer function is as gentle as this one.
  for (auto type : {SampleType::UInt8, SampleType::UInt16, SampleType::Float32}) {
    scene::Scene scene = mixed({left, right, ramp}, type);
    for (int channel : {0, 1, 2}) {
      showOnly(scene, {channel});
      Image mixture = draw(scene), single = draw(alone(scene, channel));
      Difference difference = differenceOf(mixture, single);
      EXPECT_LE(difference.largest, 9) << channel;
      EXPECT_LE(difference.mean, 1.0) << channel;
      EXPECT_GT(coverageOf(single), 0.05);
    }
  }
}

TEST_F(ChannelsGL, InvisibleAndEmptyChannelsChangeNothing) {
  scene::Scene scene = mixed({left, right});
  showOnly(scene, {0});
  Image before = draw(scene);
  scene.volume.channels[1].transfer.opacities = {{0, 0.9}};
  scene.volume.channels[1].color = {1, 1, 1};
  expectIdentical(before, draw(scene), "an invisible channel that would be solid");
  // A channel that is visible and has no opacity anywhere is no other than an invisible one.
  scene.volume.channels[1].visible = true;
  scene.volume.channels[1].transfer.opacities = {{0, 0}};
  expectIdentical(before, draw(scene), "a visible channel without opacity");
  showOnly(scene, {});
  EXPECT_EQ(coverageOf(draw(scene)), 0.0);
}

TEST_F(ChannelsGL, TheChosenChannelChangesNoPicture) {
  scene::Scene scene = mixed({left, right});
  Image before = draw(scene);
  scene.volume.channel = 1;
  expectIdentical(before, draw(scene), "another channel is edited");
  scene.volume.transfer.opacities = {{0, 1}};
  expectIdentical(before, draw(scene), "the layer's own transfer function");
}

TEST_F(ChannelsGL, ExtinctionsAddAsInBeersLaw) {
  // Constant channels: alpha through a path of d mm is 1 - exp(-(s0 + s1) d), the colour their mean by s.
  scene::Scene scene = mixed({[](glm::ivec3) { return 100.0; }, [](glm::ivec3) { return 150.0; }});
  double sigma[2] = {0.012, 0.03};
  glm::dvec3 colors[2] = {{1, 0.2, 0.1}, {0.1, 0.4, 1}};
  for (int c = 0; c < 2; ++c) {
    auto& look = scene.volume.channels[std::size_t(c)];
    look.transfer.opacities = {{0, 1 - std::exp(-sigma[c])}};
    look.transfer.colors = {{0, glm::vec3(colors[c])}};
  }
  scene.camera.projection = scene::Projection::Orthographic;
  scene.camera.height = 30;
  lookAlong(scene, {0, -1, 0});
  Image image = draw(scene, {33, 33});
  double total = sigma[0] + sigma[1];
  double alpha = 1 - std::exp(-total * kChannelsDims.y);
  glm::dvec3 color = (colors[0] * sigma[0] + colors[1] * sigma[1]) / total;
  glm::vec4 middle = colorOf(image, {16, 16});
  // Eight bits of the root: two thousandths of the extinction, here four of alpha.
  EXPECT_NEAR(middle.a, alpha, 0.008);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(middle[c], color[c], 0.012) << c;
  for (int shown : {0, 1}) {
    showOnly(scene, {shown});
    EXPECT_NEAR(colorOf(draw(scene, {33, 33}), {16, 16}).a, 1 - std::exp(-sigma[shown] * kChannelsDims.y), 0.008);
  }
}

TEST_F(ChannelsGL, EachKeepsItsColourWhereItIsAlone) {
  scene::Scene scene =
      mixed({[](glm::ivec3 p) { return p.x < 18 ? 180.0 : 0.0; }, [](glm::ivec3 p) { return p.x > 26 ? 180.0 : 0.0; }});
  for (auto& look : scene.volume.channels) look.transfer.opacities = {{60, 0}, {120, 0.3}};
  scene.volume.channels[0].transfer.colors = {{0, {0, 1, 0}}};
  scene.volume.channels[1].transfer.colors = {{0, {1, 0, 1}}};
  lookAlong(scene, {0, -1, 0});
  scene.camera.projection = scene::Projection::Orthographic;
  scene.camera.height = 44;
  Image image = draw(scene, {44, 44});
  int greens = 0, magentas = 0;
  for (int x = 0; x < 44; ++x) {
    glm::vec4 c = colorOf(image, {x, 22});
    if (c.a < 0.3f) continue;
    bool green = c.g > 0.99f && c.r < 0.01f && c.b<0.01f, magenta = c.r> 0.99f && c.b > 0.99f && c.g < 0.01f;
    EXPECT_TRUE(green || magenta) << x << ": " << c.r << " " << c.g << " " << c.b;
    greens += green, magentas += magenta;
  }
  EXPECT_GT(greens, 10);
  EXPECT_GT(magentas, 10);
}

TEST_F(ChannelsGL, LeapingStoppingEarlyAndLightEqualBruteForce) {
  for (bool shaded : {false, true}) {
    scene::Scene scene = mixed({left, right, [](glm::ivec3 p) { return p.y == 12 ? 190.0 : 0.0; }});
    scene.lighting.shaded = shaded;
    for (auto& look : scene.volume.channels) look.transfer.opacities = {{60, 0}, {150, 0.6}};
    Image fast = draw(scene);
    scene.rayCast.skipEmpty = scene.rayCast.stopOpaque = false;
    Image slow = draw(scene);
    expectSame(fast, slow, 1.0, shaded ? "shaded" : "plain");
    EXPECT_GT(coverageOf(slow), 0.1);
  }
}

TEST_F(ChannelsGL, EmptySpaceOfAMixtureIsEmpty) {
  // Else every cell would count as full, and a ray would stop in each.
  scene::Scene scene = mixed({left, right});
  render::TransferTable table = render::makeTransferTable(scene);
  EXPECT_GT(table.shownFrom, 0);
  EXPECT_LE(double(table.shownFrom) / double(table.gradientFactors.size()), 1.0 / 255.0);
}

TEST_F(ChannelsGL, TheMaximumIsWhereTheMixtureIsDensest) {
  scene::Scene scene = mixed({left, right});
  scene.rayCast.mode = scene::RenderMode::Mip;
  scene.volume.channels[0].transfer.colors = {{0, {0, 1, 0}}};
  scene.volume.channels[1].transfer.colors = {{0, {1, 0, 0}}};
  scene.camera.projection = scene::Projection::Orthographic;
  scene.camera.height = 44;
  lookAlong(scene, {0, -1, 0});
  Image image = draw(scene, {44, 44});
  // Seen from the front the left ball, x small, is on the left.
  EXPECT_GT(colorOf(image, {11, 22}).g, 0.8f);
  EXPECT_LT(colorOf(image, {11, 22}).r, 0.1f);
  EXPECT_GT(colorOf(image, {32, 22}).r, 0.8f);
  scene.rayCast.skipEmpty = scene.rayCast.stopOpaque = false;
  expectSame(image, draw(scene, {44, 44}), 1.0, "maximum without leaping");
}

TEST_F(ChannelsGL, AQuickCopyShowsTheSame) {
  scene::Scene scene = mixed({left, right});
  Image whole = draw(scene, {48, 48});
  render::Renderer other(context());
  render::Frame frame = frameOf(scene, {48, 48});
  frame.isPreview = true;
  Progress progress;
  other.render(frame, progress);
  Difference difference = differenceOf(whole, other.read());
  EXPECT_LE(difference.largest, 4);
}

}  // namespace
}  // namespace velum
