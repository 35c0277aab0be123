// The picture is that of the values, however they are stored, and of the channel and time step that the scene names.
#include <fmt/format.h>

#include <cstdlib>

#include "RenderFixture.h"

namespace velum {
namespace {

constexpr glm::ivec3 kUploadDims(36, 33, 38);

double valueOf(glm::ivec3 p) {
  return 100.0 + std::floor(90.0 * std::sin(p.x * 0.3) * std::cos(p.y * 0.25 + 1) * std::sin(p.z * 0.2 + 2));
}

class UploadGL : public RenderTest {
 protected:
  static void style(scene::Scene& scene) {
    scene.volume.transfer.colors = {{0, {0.1f, 0.3f, 1}}, {200, {1, 0.8f, 0.2f}}};
    scene.volume.transfer.opacities = {{110, 0}, {170, 0.7}};
    lookAlong(scene, {0.3, -1, 0.4}, 100);
  }
};

TEST_F(UploadGL, EverySampleTypeShowsTheSameValuesAlike) {
  for (int mode = 0; mode < 3; ++mode)
    for (bool shaded : {false, true}) {
      if (shaded && mode == 1) continue;  // the maximum has no light
      std::optional<Image> bytes, wide;
      for (int type = 0; type < 8; ++type) {
        SampleType sample = SampleType(type);
        bool isByte = sample == SampleType::Int8 || sample == SampleType::UInt8;
        // int8 holds 0..200 only with an offset; the others get a scale that must not matter.
        double offset = sample == SampleType::Int8 ? 100.0 : sample == SampleType::UInt8 ? 0.0 : -50.0;
        scene::Scene scene =
            sceneOf(makeVolume(kUploadDims, sample, valueOf, centredFrame(kUploadDims), isByte ? 1.0 : 0.5, offset));
        style(scene);
        scene.lighting.shaded = shaded;
        scene.lighting.shadow = scene.lighting.occlusion = 0;
        scene.rayCast.mode = scene::RenderMode(mode);
        scene.rayCast.isoValue = 150;
        Image image = draw(scene, {56, 56});
        EXPECT_GT(coverageOf(image), 0.1);
        auto& first = isByte ? bytes : wide;
        if (!first) first = image;
        // Shading may turn a grey level on the rounding of a gradient.
        expectSame(image, *first, shaded ? 2.0 : 1.0, std::string(enumName(sample)) + ", mode " + std::to_string(mode));
      }
      // Some drivers interpolate bytes in steps of a byte, which turns the value between voxels by up to half a unit.
      EXPECT_LT(differenceOf(*bytes, *wide).mean, 1.5) << "mode " << mode;
    }
}

TEST_F(UploadGL, ThinVolumesShowTheSameValuesInAllTypes) {
  for (glm::ivec3 dims : {glm::ivec3(1, 9, 7), {9, 1, 7}, {9, 7, 1}, {1, 1, 8}, {1, 1, 1}, {2, 3, 2}}) {
    std::optional<Image> first;
    for (SampleType type : {SampleType::Float32, SampleType::UInt8, SampleType::UInt16, SampleType::Int16}) {
      scene::Scene scene = sceneOf(makeVolume(
          dims, type, [](glm::ivec3 p) { return 120 + 7 * p.x + 13 * p.y - 5 * p.z; }, centredFrame(dims)));
      style(scene);
      lookAlong(scene, {0.3, -1, 0.4}, 14);
      Image image = draw(scene, {56, 56});
      EXPECT_GT(coverageOf(image), 0.001);
      if (!first) first = image;
      expectSame(image, *first, 2.0, fmt::format("{} x {} x {}, {}", dims.x, dims.y, dims.z, enumName(type)));
    }
  }
}

TEST_F(UploadGL, ADriverWithSmallBuffersShowsTheSame) {
  glm::ivec3 dims(48, 45, 50);  // more than the 65536 texels that every driver's buffers have
  scene::Scene scene = sceneOf(makeVolume(dims, SampleType::Int16, valueOf, centredFrame(dims)));
  style(scene);
  Image usual = draw(scene, {72, 72});
  ::setenv("VELUM_MAX_TEXTURE_BUFFER", "65536", 1);
  auto small = gpu::Context::create(gpu::ContextKind::Auto);
  ::unsetenv("VELUM_MAX_TEXTURE_BUFFER");
  {
    render::Renderer other(*small);
    expectSame(drawWith(other, scene, {72, 72}), usual, 1.0, "small buffers");
  }
}

TEST_F(UploadGL, ANegativeScaleShowsTheSameValues) {
  scene::Scene plain = sceneOf(makeVolume(kUploadDims, SampleType::Int16, valueOf, centredFrame(kUploadDims)));
  scene::Scene turned =
      sceneOf(makeVolume(kUploadDims, SampleType::Int16, valueOf, centredFrame(kUploadDims), -1.0, 7.0));
  for (int mode = 0; mode < 3; ++mode)
    for (auto* scene : {&plain, &turned}) {
      style(*scene);
      scene->rayCast.mode = scene::RenderMode(mode);
      scene->rayCast.isoValue = 150;
      if (scene == &turned)
        expectSame(draw(turned, {72, 72}), draw(plain, {72, 72}), 1.0, "mode " + std::to_string(mode));
    }
}

TEST_F(UploadGL, ChannelAndFrameAreTheOnesThatTheSceneNames) {
  // Two channels and three time steps, each a scaled copy.
  Volume v;
  v.dims = kUploadDims;
  v.type = SampleType::UInt16;
  v.channels = 2;
  v.timeSteps = 3;
  v.worldFromVoxel = centredFrame(kUploadDims);
  v.voxels.resize(timeStepBytes(v) * 3);
  auto* out = reinterpret_cast<std::uint16_t*>(v.voxels.data());
  auto at = [](glm::ivec3 p, int channel, int frame) {
    return std::round(valueOf(p) * (1.0 - 0.2 * channel) * (1.0 - 0.15 * frame));
  };
  for (int frame = 0; frame < 3; ++frame)
    for (int z = 0; z < kUploadDims.z; ++z)
      for (int y = 0; y < kUploadDims.y; ++y)
        for (int x = 0; x < kUploadDims.x; ++x)
          for (int channel = 0; channel < 2; ++channel) *out++ = std::uint16_t(at({x, y, z}, channel, frame));
  computeRange(v);
  scene::Scene all = sceneOf(std::move(v));
  style(all);
  all.volume.windowLevel = 100;
  all.volume.windowWidth = 200;
  for (int frame = 0; frame < 3; ++frame)
    for (int channel = 0; channel < 2; ++channel) {
      scene::Scene one = sceneOf(makeVolume(
          kUploadDims, SampleType::UInt16, [&](glm::ivec3 p) { return at(p, channel, frame); },
          centredFrame(kUploadDims)));
      style(one);
      one.volume.windowLevel = 100;
      one.volume.windowWidth = 200;
      all.volume.timeStep = frame;
      all.volume.channel = channel;
      expectSame(draw(all, {64, 64}), draw(one, {64, 64}), 1.0,
                 "channel " + std::to_string(channel) + " of frame " + std::to_string(frame));
    }
}

TEST_F(UploadGL, ColourVolumesShowTheirColours) {
  Volume v;
  v.dims = {20, 20, 20};
  v.channels = 3;
  v.isColor = true;
  v.worldFromVoxel = centredFrame(v.dims);
  for (int z = 0; z < 20; ++z)
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 20; ++x)
        for (int c = 0; c < 3; ++c) v.voxels.push_back(std::byte(x < 10 ? (c == 0 ? 240 : 60) : (c == 2 ? 240 : 60)));
  computeRange(v);
  scene::Scene scene = sceneOf(std::move(v));
  makeSolid(scene, {1, 1, 1});
  Image image = draw(scene, {64, 64});
  EXPECT_NEAR(colorOf(image, {22, 32}).r, 240.0 / 255, 0.01);
  EXPECT_NEAR(colorOf(image, {22, 32}).b, 60.0 / 255, 0.01);
  EXPECT_NEAR(colorOf(image, {42, 32}).b, 240.0 / 255, 0.01);
}

TEST_F(UploadGL, ADriverWithSmallTexturesShowsLessDetailAndSaysSo) {
  scene::Scene scene = sceneOf(makeVolume(kUploadDims, SampleType::UInt8, valueOf, centredFrame(kUploadDims)));
  style(scene);
  Image whole = draw(scene, {72, 72});
  EXPECT_EQ(renderer().stats().reduction, "");
  ::setenv("VELUM_MAX_TEXTURE_3D", "20", 1);
  auto small = gpu::Context::create(gpu::ContextKind::Auto);
  ::unsetenv("VELUM_MAX_TEXTURE_3D");
  {
    render::Renderer other(*small);
    Image reduced = drawWith(other, scene, {72, 72});
    std::string reduction = other.stats().reduction;
    EXPECT_NE(reduction.find("1/2"), std::string::npos) << reduction;
    EXPECT_NE(reduction.find("20"), std::string::npos) << reduction;
    Difference difference = differenceOf(whole, reduced);
    EXPECT_LT(difference.mean, 12.0);
    EXPECT_GT(difference.mean, 0.0);
    EXPECT_NEAR(coverageOf(reduced), coverageOf(whole), 0.08);
  }
  small.reset();
}

TEST_F(UploadGL, WhereThereIsNoRoomToBeSmoothThatIsSaid) {
  scene::Scene scene = sceneOf(makeVolume(kUploadDims, SampleType::UInt8, valueOf, centredFrame(kUploadDims)));
  style(scene);
  ::setenv("VELUM_MAX_TEXTURE_3D", "50", 1);
  auto small = gpu::Context::create(gpu::ContextKind::Auto);
  ::unsetenv("VELUM_MAX_TEXTURE_3D");
  {
    render::Renderer other(*small);
    drawWith(other, scene, {32, 32});
    EXPECT_EQ(other.stats().reduction, "");
    scene.volume.smooth = true;
    drawWith(other, scene, {32, 32});
    EXPECT_NE(other.stats().reduction.find("not as smooth"), std::string::npos) << other.stats().reduction;
  }
  small.reset();
}

TEST_F(UploadGL, ADriverWithLittleMemoryShowsLessDetailAndSaysSo) {
  glm::ivec3 dims(128, 128, 128);  // 8 MiB as float
  scene::Scene scene = sceneOf(makeVolume(
      dims, SampleType::Float32, [](glm::ivec3 p) { return 50 + 50 * std::sin(p.x * 0.1) * std::sin(p.y * 0.1); },
      centredFrame(dims)));
  scene.volume.transfer.opacities = {{60, 0}, {90, 0.5}};
  ::setenv("VELUM_GPU_MEMORY_MB", "4", 1);
  auto small = gpu::Context::create(gpu::ContextKind::Auto);
  ::unsetenv("VELUM_GPU_MEMORY_MB");
  {
    render::Renderer other(*small);
    Image image = drawWith(other, scene, {48, 48});
    EXPECT_NE(other.stats().reduction.find("MiB"), std::string::npos) << other.stats().reduction;
    EXPECT_GT(coverageOf(image), 0.05);
  }
}

TEST_F(UploadGL, NotANumberHurtsNoNeighbourhood) {
  float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  scene::Scene scene = sceneOf(makeVolume(
      kUploadDims, SampleType::Float32,
      [&](glm::ivec3 p) {
        return p == glm::ivec3(10, 10, 10) ? double(nan) : p == glm::ivec3(20, 20, 20) ? double(inf) : valueOf(p);
      },
      centredFrame(kUploadDims)));
  style(scene);
  for (int mode = 0; mode < 3; ++mode) {
    scene.rayCast.mode = scene::RenderMode(mode);
    scene.rayCast.isoValue = 150;
    Image image = draw(scene, {48, 48});
    for (float sample : image.pixels) ASSERT_TRUE(std::isfinite(sample));
    EXPECT_GT(coverageOf(image), 0.1);
  }
}

}  // namespace
}  // namespace velum
