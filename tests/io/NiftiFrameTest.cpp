#include <glm/gtc/quaternion.hpp>

#include <algorithm>

#include "TestFiles.h"

/// Where voxels of NIfTI files lie. Headers are made byte by byte; places are worked out without the reader's formulas.
namespace velum::io {
namespace {

/// A header of the first or the second version in either byte order, behind it 3 x 4 x 5 voxels of 16 bits.
struct Header {
  bool isVersion2 = false, isBig = false;
  double pixdim[4] = {1, 0.5, 0.75, 2};  ///< Handedness, then spacing.
  int units = 2, qformCode = 1, sformCode = 0;
  std::int16_t timeSteps = 1;
  double timeStep = 0;
  glm::dvec3 quaternion{0.0}, offset{0.0};
  double sform[3][4] = {};

  std::string bytes() const {
    std::string out(isVersion2 ? 544 : 352, '\0');
    auto put = [&](std::size_t at, auto value) {
      char raw[sizeof value];
      std::memcpy(raw, &value, sizeof value);
      if (isBig) std::reverse(raw, raw + sizeof value);
      std::memcpy(out.data() + at, raw, sizeof value);
    };
    const std::int16_t dims[] = {std::int16_t(timeSteps > 1 ? 4 : 3), 3, 4, 5, timeSteps, 1, 1, 1};
    if (isVersion2) {
      put(0, std::int32_t(540));
      std::memcpy(out.data() + 4, "n+2\0\r\n\032\n", 8);
      put(12, std::int16_t(4)), put(14, std::int16_t(16)), put(168, std::int64_t(544)), put(176, 1.0);
      for (std::size_t i = 0; i < 8; ++i) put(16 + 8 * i, std::int64_t(dims[i]));
      for (std::size_t i = 0; i < 4; ++i) put(104 + 8 * i, pixdim[i]);
      put(136, timeStep);
      put(344, std::int32_t(qformCode)), put(348, std::int32_t(sformCode)), put(500, std::int32_t(units));
      for (std::size_t i = 0; i < 3; ++i) {
        put(352 + 8 * i, quaternion[int(i)]), put(376 + 8 * i, offset[int(i)]);
        for (std::size_t k = 0; k < 4; ++k) put(400 + 32 * i + 8 * k, sform[i][k]);
      }
    } else {
      put(0, std::int32_t(348));
      std::memcpy(out.data() + 344, "n+1", 3);
      put(70, std::int16_t(4)), put(72, std::int16_t(16)), put(108, 352.0f), put(112, 1.0f);
      for (std::size_t i = 0; i < 8; ++i) put(40 + 2 * i, dims[i]);
      for (std::size_t i = 0; i < 4; ++i) put(76 + 4 * i, float(pixdim[i]));
      put(92, float(timeStep));
      put(123, std::uint8_t(units)), put(252, std::int16_t(qformCode)), put(254, std::int16_t(sformCode));
      for (std::size_t i = 0; i < 3; ++i) {
        put(256 + 4 * i, float(quaternion[int(i)])), put(268 + 4 * i, float(offset[int(i)]));
        for (std::size_t k = 0; k < 4; ++k) put(280 + 16 * i + 4 * k, float(sform[i][k]));
      }
    }
    for (std::int16_t i = 0; i < 60 * timeSteps; ++i) {
      out += char(isBig ? i >> 8 : i & 0xff);
      out += char(isBig ? i & 0xff : i >> 8);
    }
    return out;
  }
};

Volume readHeader(const Header& header) {
  TempFolder folder;
  writeText(folder / "a.nii", header.bytes());
  Volume v = read(folder / "a.nii");
  EXPECT_EQ(valueAt(v, {2, 3, 4}), 59);
  return v;
}

glm::dvec3 placeOf(const Volume& v, glm::dvec3 voxel) { return glm::dvec3(v.worldFromVoxel * glm::dvec4(voxel, 1)); }

void expectPlace(const Volume& v, glm::dvec3 voxel, glm::dvec3 ras, double tolerance) {
  glm::dvec3 lps(-ras.x, -ras.y, ras.z), got = placeOf(v, voxel);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(got[i], lps[i], tolerance) << "axis " << i;
}

/// About x, then y, then z; of a vector, by sines and cosines.
glm::dvec3 turned(glm::dvec3 v, glm::dvec3 angles) {
  auto turn = [](double& a, double& b, double angle) {
    double c = std::cos(angle), s = std::sin(angle), was = a;
    a = c * was - s * b;
    b = s * was + c * b;
  };
  turn(v.y, v.z, angles.x);
  turn(v.z, v.x, angles.y);
  turn(v.x, v.y, angles.z);
  return v;
}

/// The same turns as a quaternion of half angles, its real part not negative, as the standard wants it.
glm::dvec3 quaternionOf(glm::dvec3 angles) {
  auto about = [](double angle, glm::dvec3 axis) { return glm::angleAxis(angle, axis); };
  glm::dquat q = about(angles.z, {0, 0, 1}) * about(angles.y, {0, 1, 0}) * about(angles.x, {1, 0, 0});
  return glm::dvec3(q.x, q.y, q.z) * (q.w < 0 ? -1.0 : 1.0);
}

TEST(NiftiFrame, AQformTurnsAboutAllThreeAxes) {
  for (glm::dvec3 angles : {glm::dvec3(0.3, 0, 0), {0, -0.8, 0}, {0, 0, 1.1}, {0.4, -0.7, 1.9}, {-2.5, 0.9, 0.2}})
    for (double handed : {1.0, -1.0})
      for (bool isVersion2 : {false, true})
        for (bool isBig : {false, true}) {
          Header h;
          h.isVersion2 = isVersion2, h.isBig = isBig;
          h.pixdim[0] = handed;
          h.quaternion = quaternionOf(angles);
          h.offset = {10, -20, 30};
          Volume v = readHeader(h);
          EXPECT_TRUE(v.isOrientationKnown && v.isSpacingKnown);
          EXPECT_GT(glm::determinant(glm::dmat3(v.worldFromVoxel)) * handed, 0);
          for (glm::dvec3 voxel : {glm::dvec3(0), {2, 0, 0}, {0, 3, 0}, {0, 0, 4}, {2, 3, 4}}) {
            glm::dvec3 scaled = voxel * glm::dvec3(0.5, 0.75, 2 * handed);
            // Seven digits of a float, of at most 40 mm.
            expectPlace(v, voxel, turned(scaled, angles) + h.offset, isVersion2 ? 1e-12 : 1e-5);
          }
        }
}

TEST(NiftiFrame, AHandednessOfZeroIsOne) {
  Header h;
  h.pixdim[0] = 0;
  expectPlace(readHeader(h), {0, 0, 4}, {0, 0, 8}, 1e-6);
}

TEST(NiftiFrame, AHalfTurnIsOneThoughItsQuaternionIsRounded) {
  Header h;
  h.quaternion = {0, 0.7071069, 0.7071069};  // longer than one in the seventh digit
  expectPlace(readHeader(h), {0, 3, 0}, {0, 0, 0.75 * 3}, 1e-5);
  expectPlace(readHeader(h), {2, 0, 0}, {-1, 0, 0}, 1e-5);
}

TEST(NiftiFrame, AnAlmostHalfTurnIsATurn) {
  // What is left for the real part is rounding: it is none, and what the other three say is a half turn.
  Header h;
  h.isVersion2 = true;
  h.quaternion = {0, 0.6, std::sqrt(1.0 - 0.36 - 9e-8)};
  glm::dvec3 axis = glm::normalize(h.quaternion);
  for (glm::dvec3 voxel : {glm::dvec3(2, 0, 0), {0, 3, 0}, {0, 0, 4}}) {
    glm::dvec3 scaled = voxel * glm::dvec3(0.5, 0.75, 2.0);
    expectPlace(readHeader(h), voxel, 2.0 * glm::dot(axis, scaled) * axis - scaled, 1e-9);
  }
}

TEST(NiftiFrame, AnSformWinsOverTheQform) {
  Header h;
  h.quaternion = quaternionOf({0.3, 0.2, 0.1});
  h.sformCode = 2;
  const double rows[3][4] = {{0, -2, 0, 5}, {3, 0, 0.5, 6}, {0, 0, 4, 7}};
  std::copy(&rows[0][0], &rows[0][0] + 12, &h.sform[0][0]);
  expectPlace(readHeader(h), {1, 2, 3}, {-4 + 5, 3 + 1.5 + 6, 12 + 7}, 1e-6);
}

TEST(NiftiFrame, MetresMillimetresAndMicrometresAreMillimetresHere) {
  for (bool isVersion2 : {false, true})
    for (bool bySform : {false, true})
      for (auto [code, mm] : {std::pair(1, 1000.0), {2, 1.0}, {3, 0.001}, {0, 1.0}}) {
        Header h;
        h.isVersion2 = isVersion2;
        h.units = code | 8;
        h.offset = {1, 2, 3};
        if (bySform) {
          h.sformCode = 1;
          const double rows[3][4] = {{0.5, 0, 0, 1}, {0, 0.75, 0, 2}, {0, 0, 2, 3}};
          std::copy(&rows[0][0], &rows[0][0] + 12, &h.sform[0][0]);
        }
        Volume v = readHeader(h);
        EXPECT_EQ(v.lengthUnit, LengthUnit::Millimetre);
        expectPlace(v, {2, 3, 4}, glm::dvec3(1 + 1, 2.25 + 2, 8 + 3) * mm, 1e-6 * mm);
      }
}

TEST(NiftiFrame, SecondsMillisecondsAndMicrosecondsAreSecondsHere) {
  for (bool isVersion2 : {false, true})
    for (auto [code, seconds] : {std::pair(8, 1.0), {16, 1e-3}, {24, 1e-6}, {0, 0.0}}) {  // 0: not said
      Header h;
      h.isVersion2 = isVersion2;
      h.units = 2 | code;
      h.timeSteps = 3, h.timeStep = 2.5;
      Volume v = readHeader(h);
      EXPECT_EQ(v.timeSteps, 3);
      EXPECT_EQ(v.timeStepSeconds, 2.5 * seconds) << code;
      EXPECT_EQ(valueAt(v, {2, 3, 4}, 0, 2), 179);
    }
}

TEST(NiftiFrame, TheUnitMatrixSaysNothingOfAPatient) {
  for (double shift : {0.0, -90.0}) {
    Header h;
    h.sformCode = 2, h.qformCode = 0;
    for (int i = 0; i < 3; ++i) h.sform[i][i] = 1.0;
    h.sform[0][3] = shift;
    EXPECT_EQ(readHeader(h).isOrientationKnown, shift != 0.0);
  }
}

TEST(NiftiFrame, WithoutAFormSpacingIsKeptAndTheRestSaid) {
  Header h;
  h.qformCode = 0;
  Volume v = readHeader(h);
  EXPECT_FALSE(v.isOrientationKnown);
  EXPECT_EQ(spacingOf(v), glm::dvec3(0.5, 0.75, 2));
  EXPECT_NE(warningWith(v, "how the body lies"), "");
}

}  // namespace
}  // namespace velum::io
