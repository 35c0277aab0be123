// What new data looks like before anybody has touched anything: its look, and how near the camera comes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "makeVolume.h"
#include "scene/FirstLook.h"
#include "scene/Presets.h"
#include "scene/VisibleFrame.h"

namespace velum::scene {
namespace {

constexpr int kSize = 48;

double radius(glm::ivec3 v, int n) { return glm::length(glm::dvec3(v) - (n - 1) * 0.5) / (0.5 * n); }

/// Share of the voxels of the box's faces that are more than half opaque.
double opaqueFaces(const Scene& scene) {
  const Volume& v = *scene.volume.data;
  int count = 0, opaque = 0;
  for (int z = 0; z < v.dims.z; ++z)
    for (int y = 0; y < v.dims.y; ++y)
      for (int x = 0; x < v.dims.x; ++x) {
        glm::ivec3 p(x, y, z);
        bool isOnFace = false;
        for (int axis = 0; axis < 3; ++axis) isOnFace |= p[axis] == 0 || p[axis] == v.dims[axis] - 1;
        if (!isOnFace) continue;
        ++count;
        opaque += opacityAt(scene.volume.transfer.opacities, valueAt(v, p)) > 0.5;
      }
  return double(opaque) / count;
}

Scene firstLook(Volume volume) {
  Scene scene;
  scene.volume.data = Shared<Volume>(std::move(volume));
  applyFirstLook(scene);
  return scene;
}

/// A haze with noise all over the box, and fibres in it, as light sheets see cleared tissue.
Volume hazeWithFibres() {
  Volume v = makeVolume({kSize, kSize, kSize}, SampleType::UInt16, [](glm::ivec3 p) {
    bool isFibre = (p.x % 12 == 3 && p.y % 16 == 5) || (p.z % 14 == 6 && p.y % 12 == 2);
    return isFibre ? 20000.0 : 2500.0 + 900.0 * hashNoise(p);
  });
  v.isOrientationKnown = false;
  return v;
}

/// Tissue that fills the box, as in an MR of a small field of view.
Volume tissueEverywhere() {
  Volume v = makeVolume({kSize, kSize, kSize}, SampleType::Int16, [](glm::ivec3 p) {
    double r = radius(p, kSize);
    return (r < 0.4 ? 900.0 : r < 0.45 ? 150.0 : 420.0) + 60.0 * hashNoise(p);
  });
  v.modality = Modality::MR;
  return v;
}

TEST(FirstLook, IsNoSolidBoxWhereBackgroundFillsIt) {
  for (const Volume& volume : {hazeWithFibres(), tissueEverywhere()}) {
    Scene scene = firstLook(volume);
    EXPECT_LT(opaqueFaces(scene), 0.6) << enumName(volume.modality);
    // What stands out still shows.
    double most = 0;
    for (double value : {20000.0, 900.0})
      if (value <= volume.range.y) most = std::max(most, opacityAt(scene.volume.transfer.opacities, value));
    EXPECT_GT(most, 0.4) << enumName(volume.modality);
  }
  EXPECT_EQ(firstLook(hazeWithFibres()).volume.transfer.preset, "fluorescence");
}

/// Haze that hides little by itself, as where a light sheet's background is dim, is a box of veils all the same.
TEST(FirstLook, ShowsBrightStructuresWhereHazeIsThinToo) {
  Volume haze = makeVolume({kSize, kSize, kSize}, SampleType::UInt16, [](glm::ivec3 p) {
    bool isFibre = p.x % 6 < 2 && p.y % 8 < 3;
    return isFibre ? 24000.0 + 4000.0 * hashNoise(p) : 4000.0 + 3000.0 * hashNoise(p);
  });
  haze.isOrientationKnown = false;
  Scene scene = firstLook(haze);
  EXPECT_EQ(scene.volume.transfer.preset, "fluorescence");
}

/// Nuclei of a culture as a camera of 12 bits sees them, blurred and noisy, or a whole brain of the same brightness.
Volume opticalSections(bool isTissue) {
  Volume v = makeVolume({kSize, kSize, kSize}, SampleType::UInt16, [&](glm::ivec3 p) {
    double noise = 60.0 * hashNoise(p), r = isTissue ? radius(p, kSize) / 0.75 : 2.0;
    for (int i = 0; i < 60 && !isTissue; ++i) {
      glm::dvec3 middle((i * 37) % kSize, (i * 61 + 5) % kSize, (i * 23 + 11) % kSize);
      r = std::min(r, glm::length(glm::dvec3(p) - middle) / 3.5);
    }
    return std::max(0.0, 120.0 + 2600.0 / (1.0 + std::exp(12.0 * (r - 1.0))) + noise);
  });
  v.isOrientationKnown = false;
  v.modality = Modality::Microscopy;  // as the reader of TIFF says of 16 bits
  return v;
}

TEST(FirstLook, CellsAreFluorescenceAndTissueIsTissue) {
  EXPECT_EQ(firstLook(opticalSections(false)).volume.transfer.preset, "fluorescence");
  EXPECT_EQ(firstLook(opticalSections(true)).volume.transfer.preset, "microscopy");
  Scene cells = firstLook(opticalSections(false));
  EXPECT_GT(opacityAt(cells.volume.transfer.opacities, 2600.0), 0.4) << "nuclei";
  EXPECT_EQ(opacityAt(cells.volume.transfer.opacities, 150.0), 0.0) << "and not what is between them";
}

TEST(FirstLook, OfASinglePlaneIsThePictureThatItIs) {
  Volume line = makeVolume({1, 60, 80}, SampleType::Float32, [](glm::ivec3 p) { return std::sin(0.3 * p.z); });
  line.modality = Modality::Seismic;
  Scene scene = firstLook(line);
  EXPECT_FALSE(scene.lighting.shaded);
  for (double value : {-0.9, 0.0, 0.9}) EXPECT_GT(opacityAt(scene.volume.transfer.opacities, value), 0.9);
}

TEST(FirstLook, IsSmoothWhereSlicesAreOverTwiceAsThickAsVoxelsAreWide) {
  for (double thickness : {0.3, 1.0, 1.9, 2.1, 7.0}) {
    glm::dmat4 m(1.0);
    m[1][1] = thickness;
    Scene scene = firstLook(makeVolume(
        {20, 20, 20}, SampleType::Int16, [](glm::ivec3 p) { return p.x * 100.0; }, m));
    EXPECT_EQ(scene.volume.smooth, thickness > 2.0) << thickness;
  }
}

TEST(FirstLook, LeavesAloneWhatStandsInAir) {
  Volume v = makeVolume({kSize, kSize, kSize}, SampleType::UInt16, [](glm::ivec3 p) {
    return radius(p, kSize) < 0.7 ? 600.0 + 50.0 * hashNoise(p) : 20.0 * std::abs(hashNoise(p));
  });
  Scene first = firstLook(v), asChosen = first;
  applyPreset(asChosen, choosePreset(v));
  EXPECT_TRUE(first == asChosen);
}

TEST(FirstLook, AByteCtShowsBoneAndAPetIsProjected) {
  Volume ct = makeVolume({kSize, kSize, kSize}, SampleType::UInt8, [](glm::ivec3 p) {
    double r = radius(p, kSize);
    return std::max(0.0, r > 0.7 ? 0.0 : r > 0.35 ? 40.0 + 8.0 * hashNoise(p) : 210.0 + 20.0 * hashNoise(p));
  });
  Scene scene = firstLook(ct);
  EXPECT_EQ(scene.volume.transfer.preset, "ct8-bone");
  EXPECT_EQ(opacityAt(scene.volume.transfer.opacities, 45), 0.0) << "soft tissue";
  EXPECT_GT(opacityAt(scene.volume.transfer.opacities, 215), 0.8) << "bone";
  Volume pet = ct;
  pet.modality = Modality::PET;
  scene = firstLook(pet);
  EXPECT_EQ(scene.rayCast.mode, RenderMode::Mip);
  EXPECT_TRUE(isProjectionLook(scene.volume.transfer.preset));
  applyPreset(scene, "pet-inverse");
  EXPECT_EQ(scene.background.top, glm::vec3(1.0f));
  // Another look brings back the light and the ground.
  applyPreset(scene, "mr-head");
  EXPECT_EQ(scene.rayCast.mode, RenderMode::Volume);
  EXPECT_EQ(scene.background.top, Background{}.top);
}

/// Where a place stands in the picture: -1 to 1 from bottom to top and, times the aspect, from left to right.
glm::dvec2 inPicture(const Camera& camera, glm::dvec3 place) {
  glm::dvec3 forward = glm::normalize(camera.target - camera.eye),
             right = glm::normalize(glm::cross(forward, camera.up)), up = glm::cross(right, forward),
             off = place - camera.eye;
  double tall = camera.projection == Projection::Orthographic
                    ? 0.5 * camera.height
                    : std::tan(glm::radians(camera.fieldOfViewDeg) * 0.5) * glm::dot(off, forward);
  return glm::dvec2(glm::dot(off, right), glm::dot(off, up)) / tall;
}

/// A ball in much air, out of its middle, in an oblique box; a speck of noise in a corner.
Volume ballInAir() {
  glm::ivec3 dims(90, 70, 80);
  return makeVolume(
      dims, SampleType::UInt8,
      [](glm::ivec3 p) {
        if (p == glm::ivec3(2, 2, 2)) return 250.0;
        return glm::length(glm::dvec3(p) - glm::dvec3(30, 40, 50)) < 12.0 ? 200.0 : 0.0;
      },
      centredFrame(dims, {1.0, 1.0, 2.0}, 0.4, {100, -50, 20}));
}

TEST(VisibleFrame, WhatShowsFillsMostOfThePicture) {
  Scene scene = firstLook(ballInAir());
  glm::dmat4 m = scene.volume.data->worldFromVoxel;
  for (auto projection : {Projection::Perspective, Projection::Orthographic})
    for (double aspect : {0.6, 1.0, 1.8})
      for (auto view : {StandardView::Anterior, StandardView::Left, StandardView::Superior, StandardView::Oblique}) {
        scene.camera.projection = projection;
        Camera camera = frameVisible(scene, view, aspect);
        glm::dvec2 most(0.0);
        for (int i = 0; i < 2000; ++i) {
          double z = 1.0 - 2.0 * (i + 0.5) / 2000, turn = 2.39996 * i, flat = std::sqrt(1.0 - z * z);
          glm::dvec3 voxel =
              glm::dvec3(30, 40, 50) + 12.0 * glm::dvec3(flat * std::cos(turn), flat * std::sin(turn), z);
          most = glm::max(most, glm::abs(inPicture(camera, glm::dvec3(m * glm::dvec4(voxel, 1.0)))));
        }
        double fill = std::max(most.y, most.x / aspect);
        EXPECT_GT(fill, 0.7) << enumName(view) << ", " << aspect;
        EXPECT_LT(fill, 1.0) << enumName(view) << ", " << aspect;
      }
}

/// A tree in a pot: a wide flat base, a trunk, a crown of twigs. @param axis, sign  which way is up
Volume potPlant(int axis, int sign) {
  glm::ivec3 dims(64);
  Volume v = makeVolume(dims, SampleType::UInt8, [&](glm::ivec3 p) {
    double height = sign > 0 ? p[axis] : 63 - p[axis];
    glm::dvec2 off(p[(axis + 1) % 3] - 32.0, p[(axis + 2) % 3] - 32.0);
    bool isPot = height > 4 && height < 16 && glm::length(off) < 12.0 + 0.4 * height;
    bool isTrunk = height >= 16 && height < 40 && glm::length(off) < 3.0;
    double crown = glm::length(glm::dvec3(off, height - 44.0));
    bool isTwig = crown < 18.0 && (p.x + 2 * p.y + 3 * p.z) % 5 == 0;
    return isPot || isTrunk || isTwig ? 200.0 : 0.0;
  });
  v.isOrientationKnown = false;
  return v;
}

TEST(FirstCamera, WhatStandsOnAFlatBaseStandsUprightHoweverItLiesInTheFile) {
  for (int axis = 0; axis < 3; ++axis)
    for (int sign : {1, -1}) {
      Scene scene = firstLook(potPlant(axis, sign));
      Camera camera = firstCamera(scene, 4.0 / 3.0);
      glm::dvec3 up(0.0);
      up[axis] = sign;
      EXPECT_EQ(camera.up, up) << axis << ", " << sign;
      glm::dvec3 toEye = glm::normalize(camera.eye - camera.target);
      EXPECT_GT(glm::dot(toEye, up), 0.1) << "and is not seen from below";
      EXPECT_LT(glm::dot(toEye, up), 0.6);
      // A patient's scan says itself which side is up.
      Volume patient = potPlant(axis, sign);
      patient.isOrientationKnown = true;
      camera = firstCamera(firstLook(patient), 4.0 / 3.0);
      EXPECT_EQ(camera.up, glm::dvec3(0, 0, 1));
      EXPECT_LT(glm::normalize(camera.eye - camera.target).y, -0.99);
    }
}

/// The edges of a box: no end of it is flat.
Volume boxOfWires(glm::ivec3 dims) {
  Volume v = makeVolume(dims, SampleType::UInt8, [dims](glm::ivec3 p) {
    int outer = 0;
    for (int axis = 0; axis < 3; ++axis) outer += p[axis] < 2 || p[axis] >= dims[axis] - 2;
    return outer >= 2 ? 200.0 : 0.0;
  });
  v.isOrientationKnown = false;
  return v;
}

TEST(FirstCamera, WhatIsNoPatientIsSeenAcrossItsLongestWays) {
  int sides[] = {20, 40, 60};
  do {
    glm::ivec3 dims(sides[0], sides[1], sides[2]);
    Scene scene = firstLook(boxOfWires(dims));
    Camera camera = firstCamera(scene, 4.0 / 3.0);
    glm::dvec3 toEye = glm::abs(glm::normalize(camera.eye - camera.target));
    EXPECT_EQ(camera.up, glm::dvec3(0, 0, 1));
    for (int axis = 0; axis < 3; ++axis) {
      SCOPED_TRACE(testing::Message() << dims.x << ", " << dims.y << ", " << dims.z << ": " << axis);
      EXPECT_LT(toEye[axis], dims[axis] == 60 ? 0.5 : dims[axis] == 40 ? 0.75 : 1.0);
      EXPECT_GT(toEye[axis], dims[axis] == 20 ? 0.5 : 0.0);
    }
  } while (std::next_permutation(sides, sides + 3));
}

TEST(VisibleFrame, IsThatOfTheBoxWhereNothingShows) {
  Scene scene;
  scene.volume.data =
      Shared<Volume>(makeVolume({20, 20, 20}, SampleType::UInt8, [](glm::ivec3 p) { return double(p.x == 3); }));
  scene.volume.transfer.opacities = {{100, 0}, {200, 1}};
  EXPECT_TRUE(frameVisible(scene, StandardView::Left, 1.0) == frameCamera(scene, StandardView::Left, 1.0));
}

TEST(VisibleFrame, HiddenStructuresTakeNoRoom) {
  glm::ivec3 dims(40);
  Scene scene;
  scene.labels.data = Shared<LabelVolume>(makeLabels(
      dims, [](glm::ivec3 p) { return glm::length(glm::dvec3(p) - 20.0) < 6.0 ? 2
                                      : p.x < 38                              ? 1
                                                                              : 0; },
      centredFrame(dims)));
  completeStructures(scene.labels);
  double whole = frameVisible(scene, StandardView::Anterior, 1.0).height;
  scene.labels.structures[0].visible = false;  // the block
  EXPECT_LT(frameVisible(scene, StandardView::Anterior, 1.0).height, 0.5 * whole);
}

}  // namespace
}  // namespace velum::scene
