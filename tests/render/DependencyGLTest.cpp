// What a renderer keeps from frame to frame it may keep only as long as nothing that it was made from changes.
#include "ChangeFields.h"
#include "RenderFixture.h"
#include "core/ModelBuilder.h"

namespace velum {
namespace {

/// Few cells of the light grid, which has as many along the longest axis whatever the size.
constexpr glm::ivec3 kDependencyDims(26, 6, 10);
constexpr glm::ivec2 kDependencySize(44, 36);
constexpr int kShares = 8;

/// The fields of a scene are shared out, so that no test takes long.
class DependencyGL : public RenderTest, public testing::WithParamInterface<int> {
 protected:
  /// A scene in which all that is kept shows: light, empty space, labels, cuts, a sheet, spared structures, a mesh.
  static scene::Scene richScene() {
    scene::Scene scene = sceneOf(makeVolume(
        kDependencyDims, SampleType::Int16,
        [](glm::ivec3 p) {
          double r = glm::length(glm::dvec3(p) - glm::dvec3(13, 3, 5));
          return 900.0 - 70 * r + 150 * hashNoise(p);
        },
        centredFrame(kDependencyDims)));
    scene.lighting.shaded = true;
    scene.lighting.shadow = scene.lighting.occlusion = 0.7;
    scene.background.transparent = false;
    scene.volume.transfer.colors = {{0, {0.5f, 0.2f, 0.1f}}, {900, {1, 0.9f, 0.8f}}};
    scene.volume.transfer.opacities = {{150, 0}, {300, 0.2}, {700, 0.9}};
    scene.volume.transfer.gradientOpacities = {{0, 0.5}, {200, 1}};
    scene.rayCast.isoValue = 400;
    scene.labels.data = Shared<LabelVolume>(makeLabels(
        kDependencyDims, [](glm::ivec3 p) { return p.x > 15  ? 2
                                                   : p.z > 5 ? 3
                                                             : 0; },
        scene.volume.data->worldFromVoxel));
    scene::completeStructures(scene.labels);
    addCuts(scene);
    scene.labels.structures[0].litSphere = "bone";
    scene.finish.contours = scene.finish.litSphere = scene.finish.hatching = 0.6;
    scene.finish.contourWidth = 40;  // of such small pictures
    scene.finish.paper = scene::Paper::Rough;
    scene.surfaces = {triangle({-12, 4, -6}, {12, 4, -6}, {0, 5, 6})};
    addModel(scene);
    lookAlong(scene, {0.3, -1, 0.25}, 40);
    return scene;
  }

  /// Of everything that may be kept, there is something else here, and another number of it.
  static scene::Scene otherScene() {
    constexpr glm::ivec3 kOtherDims(5, 7, 4);
    scene::Scene scene = sceneOf(makeVolume(kOtherDims, SampleType::UInt8, [](glm::ivec3 p) { return 20 * p.x; }));
    scene.labels.data = Shared<LabelVolume>(makeLabels(
        kOtherDims, [](glm::ivec3 p) { return p.y > 3 ? 5 : 0; }, scene.volume.data->worldFromVoxel));
    scene::completeStructures(scene.labels);
    scene::Cut box;
    box.id = 4;
    box.shape = scene::CutShape::Box;
    box.size = {2, 3, 2};
    box.spares = {{5}, {6}};
    scene.cuts = {box};
    scene.surfaces = {triangle({0, 0, 0}, {3, 0, 0}, {0, 3, 2}), triangle({4, 6, 0}, {1, 6, 3}, {4, 2, 3})};
    return scene;
  }

  /// The scene with its n-th field changed, and the field's path; nothing when there are not so many.
  static std::string change(scene::Scene& scene, int n) {
    std::string path;
    scene::changeNthField(scene, n, "", path);
    return path;
  }

  /// The reference has drawn other data in between: nothing but its programs, which take long to make, can be left of
  /// the scene before.
  void expectAsFresh(const scene::Scene& before, const scene::Scene& after, const std::string& what) {
    drawWith(renderer(), before, kDependencySize);
    Image kept = drawWith(renderer(), after, kDependencySize, kAllLayers);
    drawWith(reference(), mOther, kDependencySize);
    expectIdentical(kept, drawWith(reference(), after, kDependencySize, kAllLayers), what);
  }

 private:
  static scene::Surface triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    Mesh mesh;
    mesh.positions = {a, b, c};
    mesh.indices = {0, 1, 2};
    scene::Surface surface;
    surface.data = Shared<Mesh>(std::move(mesh));
    return surface;
  }
  /// Balls of some millimetres before and in the data; a cut leaves half of them.
  static void addModel(scene::Scene& scene) {
    ModelBuilder builder("balls");
    MoleculeType type;
    type.name = "ball";
    type.compartment = builder.compartment(std::vector<std::string>{"a"});
    constexpr float kMm = 1e7f;  // angstrom
    std::uint32_t molecule = builder.addMolecule(
        builder.addType(type), {}, {{{0, 0, 0, 1.2f * kMm}, {kMm, 0, 0, kMm}, {0, kMm, 0.4f * kMm, 0.7f * kMm}}});
    for (int i = 0; i < 24; ++i)
      builder.addInstance(molecule, kMm * glm::vec3(float(i % 6) * 4 - 10, -5.0f - float(i % 5), float(i / 6) * 3 - 5),
                          glm::quat(1, 0, 0, 0));
    scene.model.data = Shared<Model>(builder.build());
    scene.model.nearColors = 0.5;
    scene.model.types = {{.type = "root.a.ball", .litSphere = "wax", .ghosts = scene::Ghosts::Filled}};
    scene.lighting.fog = 0.4;
    scene.cuts[0].model.spares = {{}};
    scene.cuts[0].model.spares[0].type = "root.a";
    scene.cuts[0].model.spares[0].share = 0.5;
    scene.cuts[0].model.spares[0].falloff = 3;
    scene.cuts[0].model.focus.emplace().types = {{"root.b"}};
  }
  static void addCuts(scene::Scene& scene) {
    scene::Cut sphere;
    sphere.id = 1;
    sphere.shape = scene::CutShape::Sphere;
    sphere.centre = {-8, -2, -3};
    sphere.size = {11, 11, 11};
    sphere.spares = {{3}};
    scene::Cut membrane;
    membrane.id = 2;
    membrane.shape = scene::CutShape::Membrane;
    membrane.axis = {0, -1, 0};
    membrane.size = {20, 9, 6};
    membrane.membrane.emplace().look = scene::SheetLook::Grid;
    scene.cuts = {sphere, membrane};
  }

  static render::Renderer& reference() {
    static auto* one = new render::Renderer(context());
    return *one;
  }

  scene::Scene mOther = otherScene();
};

TEST_P(DependencyGL, AChangedFieldDrawsAsInAFreshRenderer) {
  scene::Scene scene = richScene();
  int fields = 0;
  for (int n = GetParam();; n += kShares) {
    scene::Scene other = scene;
    std::string path = change(other, n);
    if (path.empty()) break;
    SCOPED_TRACE(path);
    expectAsFresh(scene, other, path);
    ++fields;
  }
  EXPECT_GT(fields, 10);
}

TEST_P(DependencyGL, AChangedFieldOfAnIsosurfaceDrawsAsInAFreshRenderer) {
  scene::Scene scene = richScene();
  scene.rayCast.mode = scene::RenderMode::Iso;
  scene.labels = {};
  scene.volume.transfer.gradientOpacities.clear();
  // The sheet keeps nothing of an isosurface's, and software drivers take seconds to link each of these programs with
  // it.
  std::erase_if(scene.cuts, [](const scene::Cut& cut) { return cut.shape == scene::CutShape::Membrane; });
  int fields = 0;
  for (int n = GetParam();; n += kShares) {
    scene::Scene other = scene;
    std::string path = change(other, n);
    if (path.empty()) break;
    if (!path.starts_with("rayCast") && !path.starts_with("volume") && !path.starts_with("lighting")) continue;
    SCOPED_TRACE(path);
    expectAsFresh(scene, other, path);
    ++fields;
  }
  EXPECT_GT(fields, 1);
}

TEST_P(DependencyGL, EditedLabelsDrawAsInAFreshRenderer) {
  // A structure of the cut's, one that is there, none, and a new one; over the volume and alone.
  const std::uint16_t kIds[] = {3, 2, 0, 77};
  std::uint16_t id = kIds[GetParam() % 4];
  scene::Scene scene = richScene();
  if (GetParam() >= 4) scene.volume.data = {};
  LabelVolume labels = *scene.labels.data;
  glm::ivec3 low(4, 0, 2), size(9, 4, 6);
  labels.write(low, size, std::vector<std::uint16_t>(std::size_t(size.x * size.y * size.z), id));
  if (id == 77) labels.table.push_back({id, "new", defaultLabelColor(id), 1.0f});
  scene::Scene edited = scene;
  edited.labels.data = Shared<LabelVolume>(std::move(labels));
  scene::completeStructures(edited.labels);
  expectAsFresh(scene, edited, "a box of " + std::to_string(id));
}

INSTANTIATE_TEST_SUITE_P(Share, DependencyGL, testing::Range(0, kShares));

}  // namespace
}  // namespace velum
