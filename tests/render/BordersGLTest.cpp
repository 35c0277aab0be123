// What structures look like that are pulled out, shown as surfaces or alone: round things are as round as they are.
#include <fmt/format.h>

#include "RenderFixture.h"

namespace velum {
namespace {

enum class Form { Ball, Tube };
enum class Way { Labelled, Grown, Solid, Alone };
constexpr const char* kForms[] = {"ball", "tube"};
constexpr const char* kWays[] = {"labelled", "grown", "solid", "alone"};

struct Case {
  Form form;
  Way way;
  double radius;
};

/// A round thing whose surface is known. It lies off the lattice and slanting to it.
class Thing {
 public:
  Thing(Form form, double radius) : mForm(form), mRadius(radius) {}
  glm::ivec3 dims() const { return glm::ivec3(int(2.0 * mRadius + 13.0)); }
  glm::dvec3 centre() const { return 0.5 * glm::dvec3(dims() - 1) + glm::dvec3(0.31, -0.17, 0.23); }
  glm::dvec3 axis() const { return glm::normalize(glm::dvec3(0.35, 0.2, 0.91)); }
  glm::dvec3 away(glm::dvec3 p) const {
    glm::dvec3 off = p - centre();
    return mForm == Form::Ball ? off : off - axis() * glm::dot(off, axis());
  }
  double inside(glm::dvec3 p) const { return mRadius - glm::length(away(p)); }

 private:
  Form mForm;
  double mRadius;
};

}  // namespace

class EndOfDataGL : public RenderTest {};

class BordersGL : public RenderTest, public testing::WithParamInterface<Case> {
 protected:
  /// The world is the voxels'. Seen from everywhere but along an axis of the grid.
  static scene::Scene sceneOfThing(const Thing& thing, Way way) {
    auto valueOf = [&](glm::ivec3 p) {
      return way == Way::Grown ? 500.0 + 150.0 * std::clamp(thing.inside(p), -2.0, 2.0) : 500.0;
    };
    scene::Scene scene = sceneOf(makeVolume(thing.dims(), SampleType::Float32, valueOf));
    makeSolid(scene);
    scene.labels.data =
        Shared<LabelVolume>(makeLabels(thing.dims(), [&](glm::ivec3 p) { return thing.inside(p) >= 0.0 ? 1 : 0; }));
    scene::completeStructures(scene.labels);
    if (way == Way::Grown) {
      scene::Growth step;
      step.structure = 1;
      step.low = 500.0, step.high = 1e9;
      step.seeds = {thing.centre()};
      scene.labels.growths = scene.labels.grown = {step};
    }
    if (way == Way::Alone) scene.volume.data = {};
    if (way == Way::Solid) {
      scene.labels.unlabelled = 0.0;
      scene.labels.structures[0].showAs = scene::ShowAs::Solid;
    }
    if (way == Way::Labelled || way == Way::Grown) {
      scene::Cut cut;
      cut.shape = scene::CutShape::Everywhere;
      cut.spares = {{1}};
      scene::addCut(scene, cut);
    }
    scene.lighting.shaded = true;
    scene.camera.projection = scene::Projection::Orthographic;
    scene.camera.target = thing.centre();
    lookAlong(scene, {0.43, -0.8, 0.37}, 4.0 * thing.dims().x);
    return scene;
  }
};

TEST_P(BordersGL, RoundThingsAreRound) {
  auto [form, way, radius] = GetParam();
  Thing thing(form, radius);
  scene::Scene scene = sceneOfThing(thing, way);
  scene.camera.height = 2.0 * radius + 4.0;
  int size = std::clamp(int(12.0 * scene.camera.height), 128, 512);
  Image image = draw(scene, glm::ivec2(size), kAllLayers);
  // Silhouette: where rays pass that just meet it. The nearest place of a ray to the middle or axis lies as deep
  // inside.
  double sum = 0.0;
  std::vector<double> angles;
  int edges = 0;
  auto depthOf = [&](int x, int y) {
    TestRay ray = rayThrough(scene.camera, glm::ivec2(size), {x + 0.5, y + 0.5});
    double deepest = -1e9;
    double middle = glm::dot(thing.centre() - ray.origin, ray.direction);
    for (double t = middle - 2.0 * radius; t < middle + 2.0 * radius; t += 0.05)
      deepest = std::max(deepest, thing.inside(ray.at(t)));
    return deepest;
  };
  auto isShown = [&](int x, int y) { return sampleOf(image, {x, y}, "A") > 0.5f; };
  int border = int(size * 1.5 / scene.camera.height);
  for (int y = border; y < size - border; ++y)
    for (int x = border; x + 1 < size - border; ++x) {
      if (isShown(x, y) != isShown(x + 1, y)) {
        double off = 0.5 * (depthOf(x, y) + depthOf(x + 1, y));
        sum += off * off;
        ++edges;
      }
      if (!isShown(x, y)) continue;
      glm::dvec3 truth = glm::normalize(thing.away(glm::dvec3(vectorOf(image, {x, y}, "position"))));
      glm::dvec3 normal = glm::normalize(glm::dvec3(vectorOf(image, {x, y}, "normal")));
      TestRay ray = rayThrough(scene.camera, glm::ivec2(size), {x + 0.5, y + 0.5});
      if (glm::dot(truth, ray.direction) > -0.3) continue;  // the rim is a few pixels
      angles.push_back(glm::degrees(std::acos(std::clamp(glm::dot(truth, normal), -1.0, 1.0))));
    }
  ASSERT_GT(edges, 40);
  ASSERT_GT(angles.size(), 500u);
  double rms = std::sqrt(sum / edges);
  std::nth_element(angles.begin(), angles.begin() + std::ptrdiff_t(angles.size() / 2), angles.end());
  double median = angles[angles.size() / 2];
  std::printf("%s of %g, %s: silhouette %.3f voxel, normals %.1f degrees\n", kForms[int(form)], radius, kWays[int(way)],
              rms, median);
  EXPECT_LE(rms, 0.15);
  EXPECT_LE(median, 4.5);
}

/// What is solid where the data ends shows the end's own face, whatever noise the data has there.
TEST_F(EndOfDataGL, SolidsEndInAPlane) {
  constexpr glm::ivec3 kDims(24, 20, 16);
  scene::Scene scene =
      sceneOf(makeVolume(kDims, SampleType::Int16, [](glm::ivec3 p) { return 100.0 + 200.0 * hashNoise(p); }));
  scene.labels.data = Shared<LabelVolume>(makeLabels(kDims, [](glm::ivec3) { return 1; }));
  scene::completeStructures(scene.labels);
  scene.labels.structures[0].showAs = scene::ShowAs::Solid;
  scene.labels.unlabelled = 0.0;
  scene.lighting.shaded = true;
  lookAlong(scene, {0.5, -0.7, 0.6}, 60.0);
  for (bool isAlone : {false, true}) {
    if (isAlone) scene.volume.data = {};
    int shown = 0, wrong = 0;
    Image image = draw(scene, {96, 96}, kAllLayers);
    eachShown(image, [&](glm::ivec2 pixel, glm::vec3 place) {
      // The face that is seen; near the box's edges two meet.
      glm::dvec3 low = glm::abs(glm::dvec3(place) + 0.5),
                 high = glm::abs(glm::dvec3(place) - (glm::dvec3(kDims) - 0.5));
      glm::dvec3 off = glm::min(low, high);
      int face = off.x < off.y ? (off.x < off.z ? 0 : 2) : (off.y < off.z ? 1 : 2);
      for (int axis = 0; axis < 3; ++axis)
        if (axis != face && off[axis] < 1.5) return;
      glm::dvec3 truth(0.0);
      truth[face] = face == 1 ? -1.0 : 1.0;
      ++shown;
      wrong +=
          glm::dot(glm::normalize(glm::dvec3(vectorOf(image, pixel, "normal"))), truth) < std::cos(glm::radians(8.0));
    });
    EXPECT_GT(shown, 1000);
    EXPECT_LE(wrong, shown / 100) << (isAlone ? "alone" : "in a scan");
  }
}

std::vector<Case> allCases() {
  std::vector<Case> cases;
  for (Form form : {Form::Ball, Form::Tube})
    for (Way way : {Way::Labelled, Way::Grown, Way::Solid, Way::Alone})
      for (double radius : {2.0, 4.0, 8.0, 20.0, 40.0}) cases.push_back({form, way, radius});
  return cases;
}
std::string nameOf(const testing::TestParamInfo<Case>& tested) {
  const Case& one = tested.param;
  return fmt::format("{}_{}_{}", kForms[int(one.form)], kWays[int(one.way)], int(one.radius));
}
INSTANTIATE_TEST_SUITE_P(Things, BordersGL, testing::ValuesIn(allCases()), nameOf);

}  // namespace velum
