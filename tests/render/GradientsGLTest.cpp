// Gradients: what they do to opacity, by a formula, and that both ways to take them draw the same.
#include <cstdlib>

#include "RenderFixture.h"

namespace velum {
namespace {

/// A driver that is taken for a GPU: texels as they are, gradients on demand. The
/// other context is current again whenever nobody draws with this one.
class AsGpu {
 public:
  explicit AsGpu(gpu::Context& home) : mHome(home) {
    ::setenv("VELUM_SOFTWARE_DRIVER", "0", 1);
    mContext = gpu::Context::create(gpu::ContextKind::Auto);
    ::unsetenv("VELUM_SOFTWARE_DRIVER");
    mRenderer.emplace(*mContext);
    mHome.makeCurrent();
  }
  ~AsGpu() {
    mContext->makeCurrent();
    mRenderer.reset();
    mContext.reset();
    mHome.makeCurrent();
  }
  const gpu::Context& context() const { return *mContext; }
  /// Calls `use(render::Renderer&)`.
  template <class Use>
  auto with(Use use) {
    mContext->makeCurrent();
    auto result = use(*mRenderer);
    mHome.makeCurrent();
    return result;
  }

 private:
  gpu::Context& mHome;
  std::unique_ptr<gpu::Context> mContext;
  std::optional<render::Renderer> mRenderer;
};

class GradientsGL : public RenderTest {
 protected:
  static constexpr glm::ivec3 kDims{36, 30, 32};
  static constexpr double kOpacity = 0.03;  ///< of a millimetre

  /// A ramp along one of the volume's axes, of `slope` a millimetre, as opaque everywhere; all of it is let through
  /// where the gradient is 0 and nothing is added from 100 a millimetre on.
  static scene::Scene rampScene(int axis, double slope, const glm::dmat4& frame, SampleType type) {
    double perVoxel = slope * glm::length(glm::dvec3(frame[axis]));
    scene::Scene scene = sceneOf(makeVolume(
        kDims, type, [&](glm::ivec3 p) { return perVoxel * p[axis]; }, frame, type == SampleType::UInt16 ? 0.2 : 1.0));
    scene.volume.transfer.colors = {{0, {1.0f, 0.5f, 0.25f}}};
    scene.volume.transfer.opacities = {{-1, kOpacity}, {10000, kOpacity}};
    scene.volume.transfer.gradientOpacities = {{0, 0.1}, {100, 0.9}};
    scene.camera.projection = scene::Projection::Orthographic;
    scene.camera.target = centreOf(*scene.volume.data);
    scene.camera.height = 20;
    return scene;
  }
  /// Along rays that stay two voxels off the ramp's ends, where the difference is of one voxel.
  static bool isInside(const Volume& v, const TestRay& ray, glm::dvec2 t, int axis) {
    glm::dmat4 m = glm::inverse(v.worldFromVoxel);
    for (double at : {t.x, t.y}) {
      double voxel = (m * glm::dvec4(ray.at(at), 1.0))[axis];
      if (voxel < 2.0 || voxel > v.dims[axis] - 3.0) return false;
    }
    return true;
  }
  static constexpr glm::ivec2 kSize{24, 24};

  static void expectBeersLaw(const Image& image, const scene::Scene& scene, int axis, double factor,
                             const std::string& what) {
    glm::ivec2 size = kSize;
    int inside = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        TestRay ray = rayThrough(scene.camera, size, {x + 0.5, y + 0.5});
        glm::dvec2 t = boxInterval(*scene.volume.data, ray);
        if (t.y - t.x < 1.0 || !isInside(*scene.volume.data, ray, t, axis)) continue;
        ++inside;
        double expected = 1.0 - std::pow(1.0 - kOpacity, factor * (t.y - t.x));
        // A gradient of 8 bits errs by a hundredth, which is 0.003 of the most that shows.
        ASSERT_NEAR(sampleOf(image, {x, y}, "A"), expected, 0.006)
            << what << ", pixel " << x << ", " << y << ", " << t.y - t.x << " mm, factor " << factor;
      }
    EXPECT_GT(inside, 60) << what;
  }
};

TEST_F(GradientsGL, OpacityByGradientAttenuatesARampByBeersLaw) {
  AsGpu gpu(context());
  for (auto type : {SampleType::Float32, SampleType::UInt16})
    for (int axis = 0; axis < 3; ++axis)
      for (const auto& frame : {centredFrame(kDims), centredFrame(kDims, {0.7, 1.3, 2.0}, 0.5, {30, -20, 5})})
        for (double slope : {5.0, 40.0, 75.0, 160.0}) {
          scene::Scene scene = rampScene(axis, slope, frame, type);
          glm::dvec3 across = glm::normalize(glm::dvec3(frame[(axis + 1) % 3]));
          lookAlong(scene, across, 200);
          double factor = std::min(0.1 + 0.8 * slope / 100.0, 0.9);
          std::string what = "axis " + std::to_string(axis) + ", slope " + std::to_string(slope);
          expectBeersLaw(draw(scene, kSize), scene, axis, factor, what);
          Image onDemand = gpu.with([&](auto& renderer) { return drawWith(renderer, scene, kSize); });
          expectBeersLaw(onDemand, scene, axis, factor, what + ", on demand");
        }
}

TEST_F(GradientsGL, OpacityByGradientScalesThatOfStructuresToo) {
  scene::Scene scene = rampScene(0, 50.0, centredFrame(kDims), SampleType::Float32);
  scene.labels.data = Shared<LabelVolume>(makeLabels(
      kDims, [](glm::ivec3) { return 7; }, scene.volume.data->worldFromVoxel));
  scene::completeStructures(scene.labels);
  scene.labels.structures[0].opacity = 0.4;
  lookAlong(scene, {0, -1, 0}, 200);
  expectBeersLaw(draw(scene, kSize), scene, 0, 0.4 * 0.5, "of a structure");
}

/// An uneven ball: steep everywhere but in its middle, where nothing shows, so that no gradient is noise.
double lumpAt(glm::ivec3 p) {
  glm::dvec3 off = (glm::dvec3(p) - glm::dvec3(17, 15, 16)) / glm::dvec3(36, 30, 32);
  return 200.0 - 400.0 * glm::length(off) + 6.0 * std::sin(p.x * 0.5) * std::cos(p.y * 0.6 + 1) * std::sin(p.z * 0.4);
}

class OnDemandGL : public GradientsGL {
 protected:
  /// Of so many voxels that the light grid's cells are as fine by either way. Floats, as bytes are interpolated in
  /// steps of a byte by some drivers where they are not packed.
  static scene::Scene lump() {
    scene::Scene scene =
        sceneOf(makeVolume(kDims, SampleType::Float32, lumpAt, centredFrame(kDims, {1.0, 1.1, 1.2}, 0.4, {3, -5, 2})));
    scene.volume.transfer.colors = {{0, {0.1f, 0.3f, 1}}, {200, {1, 0.8f, 0.2f}}};
    scene.volume.transfer.opacities = {{60, 0}, {80, 0.9}};
    scene.rayCast.isoValue = 70;
    scene.camera.target = centreOf(*scene.volume.data);
    lookAlong(scene, {0.3, -1, 0.4}, 100);
    scene.lighting.shaded = true;
    scene.lighting.shininess = 12.0;
    return scene;
  }
  /// What gradients look like by both ways differs by what 8 bits hold of a direction: a degree, hardly a grey level
  /// but in a highlight.
  void expectSameOnDemand(const scene::Scene& scene, const std::string& what) {
    if (!mGpu) mGpu.emplace(context());
    Image onDemand = mGpu->with([&](auto& renderer) { return drawWith(renderer, scene, {72, 72}, kAllLayers); });
    Image looked = draw(scene, {72, 72}, kAllLayers);
    EXPECT_GT(coverageOf(looked), 0.1) << what;
    Difference difference = differenceOf(onDemand, looked);
    EXPECT_LT(difference.mean, 0.25) << what;
    EXPECT_LT(difference.largest, 14.0) << what << ", pixel " << difference.where.x << ", " << difference.where.y;
    // On the rim normals are turned to the eye, from whichever side of it they are.
    glm::vec3 eye(glm::normalize(scene.camera.eye - scene.camera.target));
    double worst = 1.0;
    eachShown(looked, [&](glm::ivec2 pixel, glm::vec3) {
      glm::vec3 normal = vectorOf(looked, pixel, "normal");
      if (sampleOf(onDemand, pixel, "Z") != sampleOf(looked, pixel, "Z") || glm::dot(normal, eye) < 0.2f) return;
      worst = std::min(worst, double(glm::dot(vectorOf(onDemand, pixel, "normal"), normal)));
    });
    EXPECT_GT(worst, 0.99) << what << ": normals";
  }

 private:
  std::optional<AsGpu> mGpu;
};

TEST_F(OnDemandGL, IsWhatADriverThatIsNoSoftwareDoes) {
  EXPECT_TRUE(context().limits().isSoftware) << "the tests draw with the processor";
  AsGpu gpu(context());
  EXPECT_FALSE(gpu.context().limits().isSoftware);
}

TEST_F(OnDemandGL, ShadesAsFromTheTexture) {
  for (auto mode : {scene::RenderMode::Volume, scene::RenderMode::Iso}) {
    scene::Scene scene = lump();
    scene.rayCast.mode = mode;
    for (bool hasShadows : {false, true}) {
      scene.lighting.shadow = hasShadows ? 0.6 : 0.0;
      scene.lighting.occlusion = hasShadows ? 0.7 : 0.0;
      expectSameOnDemand(scene, std::string(enumName(mode)) + (hasShadows ? ", with shadows" : ""));
    }
  }
}

TEST_F(OnDemandGL, FadesByGradientAsFromTheTexture) {
  scene::Scene scene = lump();
  scene.lighting.shadow = scene.lighting.occlusion = 0;
  for (bool shaded : {false, true}) {
    scene.lighting.shaded = shaded;
    scene.volume.transfer.gradientOpacities = {{4, 0}, {20, 1}};
    expectSameOnDemand(scene, shaded ? "shaded" : "flat");
  }
}

TEST_F(OnDemandGL, CutsAndStructuresLookAsFromTheTexture) {
  scene::Scene scene = lump();
  const Volume& volume = *scene.volume.data;
  scene.labels.data = Shared<LabelVolume>(makeLabels(
      kDims, [](glm::ivec3 p) { return p.x < 18 ? 3 : 0; }, volume.worldFromVoxel));
  scene::completeStructures(scene.labels);
  scene.labels.tint = 0.5;
  scene::Cut cut;
  cut.centre = centreOf(volume);
  cut.axis = {0.2, -1, 0.1};
  cut.spares = {{3}};
  scene::addCut(scene, cut);
  expectSameOnDemand(scene, "shaded faces");
  scene.cuts[0].face = scene::CutFace::Section;
  expectSameOnDemand(scene, "sections on faces");
}

}  // namespace
}  // namespace velum
