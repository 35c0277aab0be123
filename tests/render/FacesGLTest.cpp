// The layer that says of which cut each pixel shows the face.
#include <fmt/format.h>

#include <set>

#include "cutBall.h"
#include "shared/cut.h"

namespace velum {
namespace {

constexpr glm::ivec2 kFacesSize(72, 72);

shared::CutData faceCutData(const scene::Cut& cut, bool isInverted) {
  shared::CutData data{};
  data.localFromScene = glm::mat4(glm::inverse(scene::worldFromCut(cut)));
  data.halfSize = glm::vec4(glm::vec3(cut.size * 0.5), isInverted ? -1.0f : 1.0f);
  data.kind.x = static_cast<int>(cut.shape);
  return data;
}

scene::Cut facedCut(scene::CutShape shape, glm::dvec3 centre, glm::dvec3 size) {
  scene::Cut cut;
  cut.shape = shape;
  cut.centre = centre;
  cut.axis = {0.3, -1, 0.2};
  cut.size = size;
  return cut;
}

std::vector<scene::Cut> facedCuts() {
  return {facedCut(scene::CutShape::Plane, {2, 1, 3}, {10, 10, 10}),
          facedCut(scene::CutShape::Box, {3, -14, 2}, {22, 14, 26}),
          facedCut(scene::CutShape::Sphere, {-4, -12, 5}, {30, 30, 30})};
}

scene::Cut farAway() { return facedCut(scene::CutShape::Sphere, {500, 500, 500}, {1, 1, 1}); }

/// A picture that says faces.
Image drawFaces(render::Renderer& renderer, const scene::Scene& scene, glm::ivec2 size, const render::Layers& layers) {
  Progress progress;
  render::Frame frame;
  frame.scene = scene;
  frame.pictureSize = size;
  frame.saysFaces = true;
  renderer.render(frame, progress);
  return renderer.read(layers);
}

class FacesGL : public CutPictures {};

TEST_F(FacesGL, FacesAreThoseThatRaysMeetFirst) {
  render::Layers layers;
  layers.face = true;
  int allFaces = 0;
  for (int kind = 0; kind < 12; ++kind) {
    scene::Cut shape = facedCuts()[std::size_t(kind / 4)];
    bool invert = kind % 2 == 1, isShaded = kind % 4 > 1;
    scene::Scene scene = solidScene();
    lookAlong(scene, {0.35, -1, 0.3}, 100);
    scene.cuts = {farAway(), shape};
    scene.cuts[1].invert = invert;
    scene.lighting.shaded = isShaded;
    Image image = drawFaces(renderer(), scene, kFacesSize, layers);
    int faces = 0, decided = 0, wrong = 0;
    for (int y = 0; y < kFacesSize.y; ++y)
      for (int x = 0; x < kFacesSize.x; ++x) {
        TestRay ray = rayThrough(scene.camera, kFacesSize, {x + 0.5, y + 0.5});
        glm::dvec2 box = boxInterval(*scene.volume.data, ray);
        glm::vec2 inside =
            shared::cutInterval(faceCutData(shape, invert), glm::vec3(ray.origin), glm::vec3(ray.direction));
        bool isEmpty = inside.x >= inside.y;
        // The ends of what is kept: on a face where the cut's end is farther than the block's by some voxels.
        double begin = invert ? double(inside.x) : double(inside.y), surely = 3.0;
        bool startsRemoved = invert ? begin > box.x + surely : !isEmpty && double(inside.x) < box.x - surely;
        bool isFace = !isEmpty && startsRemoved && begin > box.x + surely && begin < box.y - surely &&
                      (!invert || begin < double(inside.y) - surely);
        // Where the block's own side is seen, far from the cut.
        glm::vec3 side(ray.origin + box.x * ray.direction);
        bool isNone = box.x >= box.y || shared::shapeDistance(faceCutData(shape, invert), side) > 2.0f;
        if (!isFace && !isNone) continue;
        ++decided;
        faces += isFace;
        wrong += sampleOf(image, {x, y}, "face") != (isFace ? 2.0f : 0.0f);
      }
    std::string what = fmt::format("{}{}{}", enumName(shape.shape), invert ? " inverted" : "", isShaded ? " lit" : "");
    EXPECT_LE(wrong, 4) << what;  // in the edges of boxes, which belong to two sides
    EXPECT_GT(decided, 100) << what;
    allFaces += faces;
    if (shape.shape == scene::CutShape::Plane && !invert) {
      EXPECT_GT(faces, 200) << what;
    }
  }
  EXPECT_GT(allFaces, 1000);
}

class ExactFacesGL : public CutPictures, public testing::WithParamInterface<int> {};

TEST_P(ExactFacesGL, FacesLieOnTheirCutsAndEndWithTheMaterial) {
  constexpr glm::ivec2 kPicture(96, 96);
  bool isIso = GetParam() == 2;
  render::Layers layers;
  layers.face = layers.position = true;
  scene::Cut plane = facedCut(scene::CutShape::Plane, {1, -3, 2}, {10, 10, 10}),
             box = facedCut(scene::CutShape::Box, {4, -9, 4}, {17, 13, 19}),
             ball = facedCut(scene::CutShape::Sphere, {-5, -10, -4}, {18, 18, 18}),
             dome = membraneOf(domeSheet({64, 64}, {40, 40, 20}), {0.3, -1, 0.2}, {40, 40, 20});
  dome.membrane->cloth.particles = {64, 64};
  dome.centre = {1, 2, -1};
  scene::Cut off = plane;
  off.enabled = false;
  for (const std::vector<scene::Cut>& cuts : {std::vector{off, plane}, std::vector{box}, std::vector{ball, off, box},
                                              std::vector{dome}, std::vector{box, dome}}) {
    scene::Scene scene = ballScene(isIso, GetParam() == 1);
    lookAlong(scene, {0.35, -1, 0.3}, 100);
    scene.cuts = cuts;
    Image image = drawFaces(renderer(), scene, kPicture, layers);
    std::vector<CutFormula> formulas;
    for (const scene::Cut& cut : cuts)
      formulas.push_back(cut.enabled ? formulaOf(cut) : [](glm::dvec3) { return 1e9; });
    int faces = 0, decided = 0, wrong = 0, far = 0;
    std::string said;
    for (int y = 0; y < kPicture.y; ++y)
      for (int x = 0; x < kPicture.x; ++x) {
        int face = int(sampleOf(image, {x, y}, "face"));
        if (face > 0) {
          glm::dvec3 place(vectorOf(image, {x, y}, "position"));
          double apart = std::abs(formulas[std::size_t(face) - 1](place));
          if (apart > 0.1 * kVoxelMm || glm::length(place) > kBallMm + 0.1 * kVoxelMm) {
            ++far;
            said += fmt::format("\n{}, {}: {:.3f} mm off, {:.3f} mm out", x, y, apart, glm::length(place) - kBallMm);
          }
        }
        // Half a pixel around an outline either answer is right.
        std::set<int> known;
        for (glm::dvec2 beside : {glm::dvec2(0.5), {0.0, 0.5}, {1.0, 0.5}, {0.5, 0.0}, {0.5, 1.0}})
          known.insert(
              std::max(faceByFormula(formulas, rayThrough(scene.camera, kPicture, glm::dvec2(x, y) + beside)), 0));
        if (known.size() > 1) continue;
        ++decided;
        faces += face > 0;
        if (face == *known.begin()) continue;
        ++wrong;
        said += fmt::format("\n{}, {}: {} for {}", x, y, face, *known.begin());
      }
    std::string what = fmt::format("{} cuts from {}", cuts.size(), enumName(cuts[0].shape));
    EXPECT_EQ(far, 0) << what << said.substr(0, 400);
    EXPECT_EQ(wrong, 0) << what << said.substr(0, 400);
    EXPECT_GT(decided, kPicture.x * kPicture.y * 9 / 10) << what;
    EXPECT_GT(faces, 300) << what;
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, ExactFacesGL, testing::Values(0, 1, 2), [](const auto& test) {
  return std::string(test.param == 0 ? "Volume" : test.param == 1 ? "Lit" : "Isosurface");
});

}  // namespace
}  // namespace velum
