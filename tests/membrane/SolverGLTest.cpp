// Laws of the elastic sheet, and its GPU solver against a plain one.
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>

#include "GlFixture.h"
#include "ReferenceSolver.h"
#include "gpu/Program.h"
#include "makeVolume.h"

namespace velum::membrane {

namespace {

class SolverGL : public GlTest {
 protected:
  static SheetSetup sheetOf(int particles, bool alongNormal = true) {
    SheetSetup setup;
    setup.particles = {particles, particles};
    setup.half = {64, 64, 20};
    setup.isAlongNormal = alongNormal;
    // As stiff as the paper's rule wants it, so that domes are wide.
    setup.cloth.stretch = 0.8;
    setup.cloth.restoring = 20.0;
    setup.cloth.damping = 6.0;
    return setup;
  }
  /// A lattice of kernels over the frame's box.
  static PushField latticeOf(int n, const std::function<glm::vec2(glm::dvec3)>& strengthAt) {
    PushField field;
    field.dims = {n, n, n / 2};
    double pitch = 128.0 / n;
    glm::dmat4 localFromKernel(1.0);
    for (int i = 0; i < 3; ++i) {
      localFromKernel[i][i] = pitch;
      localFromKernel[3][i] = -0.5 * pitch * (field.dims[i] - 1);
    }
    field.kernelFromLocal = glm::inverse(localFromKernel);
    for (int z = 0; z < field.dims.z; ++z)
      for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
          field.strengths.push_back(strengthAt(glm::dvec3(localFromKernel * glm::dvec4(x, y, z, 1))));
    return field;
  }
  /// One kernel in the middle of the frame.
  static PushField oneKernel(double strength, bool alongNormal) {
    PushField field;
    // In the paper's rule the force jumps at the faces of a kernel's box: one that holds the whole frame has none here.
    if (alongNormal)
      field.placed.push_back({{0, 0, 1.5}, 30.0, strength, 0.0});  // its centre comes to lie on the rest plane
    else
      field.placed.push_back({{0, 0, -30}, 90.0, 0.0, 0.2 * strength});
    return field;
  }
  static float largest(const std::vector<glm::vec3>& v) {
    float most = 0;
    for (auto p : v) most = std::max(most, glm::length(p));
    return most;
  }
  static float heightOf(const std::vector<glm::vec3>& places, glm::ivec2 n) {
    return places[std::size_t(n.y / 2 * n.x + n.x / 2)].z;
  }
};

TEST_F(SolverGL, NoForceNoMotion) {
  for (bool along : {true, false}) {
    Solver solver;
    solver.setSheet(sheetOf(50, along));
    auto before = solver.readPlaces();
    solver.step(100);
    EXPECT_EQ(solver.speed(), 0.0);
    EXPECT_EQ(solver.readPlaces(), before);
  }
}

TEST_F(SolverGL, ARepulsiveKernelMakesASymmetricDomeAndAnAttractiveOneItsMirrorImage) {
  for (bool along : {true, false}) {
    Solver solver;
    solver.setSheet(sheetOf(51, along));
    // Pushed hard towards its border a free sheet buckles, and which way hangs on the last digit.
    solver.setField(oneKernel(along ? 400 : 100, along));
    solver.step(300);
    auto dome = solver.readPlaces();
    auto at = [&](const std::vector<glm::vec3>& v, int x, int y) { return v[std::size_t(y * 51 + x)]; };
    EXPECT_GT(heightOf(dome, {51, 51}), along ? 2.0f : 0.5f);
    for (int y = 0; y < 51; ++y)
      for (int x = 0; x < 51; ++x) {
        EXPECT_NEAR(at(dome, x, y).z, at(dome, 50 - x, y).z, 2e-3);
        EXPECT_NEAR(at(dome, x, y).z, at(dome, x, 50 - y).z, 2e-3);
        EXPECT_NEAR(at(dome, x, y).z, at(dome, y, x).z, 2e-3);
      }
    if (!along) continue;
    solver.setSheet(sheetOf(49));
    solver.setSheet(sheetOf(51));
    solver.setField(oneKernel(-400, along));
    solver.step(300);
    auto bowl = solver.readPlaces();
    for (std::size_t i = 0; i < dome.size(); ++i) EXPECT_NEAR(bowl[i].z, -dome[i].z, 1e-3);
  }
}

TEST_F(SolverGL, TheBorderNeverMovesAndPinsHold) {
  for (bool along : {true, false}) {
    Solver solver;
    solver.setSheet(sheetOf(40, along));
    solver.setField(oneKernel(1000, along));
    glm::vec3 pinned(10, 5, -7);
    auto flat = solver.readPlaces();
    HeldParticle pin{20 * 40 + 20, pinned};
    solver.hold({&pin, 1});
    solver.step(150);
    auto places = solver.readPlaces();
    for (int i = 0; i < 1600; ++i) {
      int x = i % 40, y = i / 40;
      bool border = x == 0 || y == 0 || x == 39 || y == 39;
      ASSERT_TRUE(!border || places[std::size_t(i)] == flat[std::size_t(i)]);
    }
    glm::vec3 held = places[20 * 40 + 20];
    EXPECT_EQ(held.z, pinned.z);
    EXPECT_TRUE(along || held == pinned);
  }
}

TEST_F(SolverGL, KineticEnergyDecaysToRest) {
  for (bool along : {true, false}) {
    Solver solver;
    solver.setSheet(sheetOf(50, along));
    solver.setField(latticeOf(32, [along](glm::dvec3 p) {
      bool inside = glm::length(p - glm::dvec3(-15, 0, -6)) < 14 || glm::length(p - glm::dvec3(20, 10, -9)) < 12;
      return !inside ? glm::vec2(0) : along ? glm::vec2(100, 0) : glm::vec2(0, 100);
    }));
    auto energy = [&] {
      double sum = 0;
      for (auto v : solver.readVelocities()) sum += 0.5 * double(glm::dot(v, v));
      return sum;
    };
    solver.step(20);
    double early = energy();
    solver.step(600);
    double late = energy();
    EXPECT_GT(early, 1.0);
    EXPECT_LT(late, 1e-4 * early);
    EXPECT_LT(solver.speed(), solver.restSpeed());
  }
}

TEST_F(SolverGL, TheStrongestForcesWithTheLongestStepStayBounded) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> any(-1000, 1000);
  for (bool along : {true, false}) {
    SheetSetup setup = sheetOf(50, along);
    setup.cloth.timeStepS = 0.05;
    setup.cloth.damping = 0.1;
    setup.cloth.iterations = 1;
    Solver solver;
    solver.setSheet(setup);
    solver.setField(latticeOf(64, [&](glm::dvec3) { return glm::vec2(any(random), any(random)); }));
    for (int i = 0; i < 10; ++i) {
      solver.step(50);
      for (auto p : solver.readPlaces()) {
        ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
        ASSERT_LE(std::abs(p.x), 64.0f);
        ASSERT_LE(std::abs(p.z), 20.0f);
      }
    }
  }
}

TEST_F(SolverGL, IsEquallyStiffAtEveryResolution) {
  for (bool along : {true, false}) {
    float heights[3];
    // The finest takes long: once, by the rule that membranes have by themselves.
    int sizes[] = {25, 51, along ? 201 : 101};
    for (int i = 0; i < 3; ++i) {
      Solver solver;
      solver.setSheet(sheetOf(sizes[i], along));
      solver.setField(oneKernel(300, along));
      solver.step(250);
      heights[i] = heightOf(solver.readPlaces(), {sizes[i], sizes[i]});
    }
    std::printf("dome %s: %.3f %.3f %.3f mm\n", along ? "along the normal" : "free", heights[0], heights[1],
                heights[2]);
    EXPECT_NEAR(heights[0], heights[1], 0.1f * heights[1]);
    EXPECT_NEAR(heights[2], heights[1], 0.1f * heights[1]);
  }
}

/// [IMC] eq. 2 and 3 over every kernel there is; the sign goes over from one side to the other within a quarter of the
/// half-width, as Solver.h says. In units of strength, frame-local.
glm::dvec3 sumOverAllKernels(const PushField& field, glm::dvec3 place, bool alongNormal) {
  glm::dmat4 localFromKernel = glm::inverse(field.kernelFromLocal);
  glm::dvec3 q(field.kernelFromLocal * glm::dvec4(place, 1.0)), sum(0.0);
  double width = field.areaOfEffect;
  for (std::size_t i = 0; i < field.strengths.size(); ++i) {
    auto x = int(i) % field.dims.x, y = int(i) / field.dims.x % field.dims.y,
         z = int(i) / (field.dims.x * field.dims.y);
    glm::dvec3 share = (q - glm::dvec3(x, y, z)) / width, left = 1.0 - glm::abs(share);
    if (std::min({left.x, left.y, left.z}) <= 0) continue;
    if (alongNormal)
      sum.z += field.strengths[i].x * left.x * left.y * left.z;
    else
      for (int j = 0; j < 3; ++j)
        sum += field.strengths[i].y * std::clamp(4.0 * share[j], -1.0, 1.0) * left[j] *
               glm::normalize(glm::dvec3(localFromKernel[j]));
  }
  return sum;
}

TEST_F(SolverGL, TheForceIsTheSumOverAllKernels) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (double area : {1.0, 1.5, 2.0, 3.2, 4.0})
    for (bool along : {true, false}) {
      // Turned against the frame, and longer along one axis than along the others.
      PushField field;
      field.dims = {23, 17, 9};
      field.areaOfEffect = area;
      glm::dvec3 spacing(5, 7, 4);
      field.kernelFromLocal = glm::inverse(centredFrame(field.dims, spacing, 0.7));
      for (int i = 0; i < field.dims.x * field.dims.y * field.dims.z; ++i) {
        auto c = float(0.1 * unit(random));
        field.strengths.emplace_back(along ? c : 0.0f, along ? 0.0f : c);
      }
      SheetSetup setup = sheetOf(40, along);
      setup.cloth.stretch = setup.cloth.bend = setup.cloth.restoring = 0.0;
      Solver solver;
      solver.setSheet(setup);
      auto places = solver.readPlaces();
      for (auto& place : places) place.z = float(12.0 * unit(random));
      solver.setPlaces(places);
      places = solver.readPlaces();
      std::vector<glm::dvec3> sums;
      double largest = 0;
      for (const auto& place : places) {
        sums.push_back(sumOverAllKernels(field, glm::dvec3(place), along));
        largest = std::max(largest, glm::length(sums.back()));
      }
      // From rest, without constraints: force x time step x damping. As far in a step as its bound allows, so that a
      // float's last digit is little.
      double perForce = setup.cloth.timeStepS * std::exp(-setup.cloth.damping * setup.cloth.timeStepS);
      double scale = 1.5 / (largest * perForce * setup.cloth.timeStepS);
      for (auto& strength : field.strengths) strength *= float(scale);
      solver.setField(field);
      solver.step(1);
      auto velocities = solver.readVelocities();
      double worst = 0;
      for (int y = 1; y + 1 < 40; ++y)
        for (int x = 1; x + 1 < 40; ++x) {
          auto i = std::size_t(y * 40 + x);
          worst = std::max(worst, glm::length(glm::dvec3(velocities[i]) / (perForce * scale) - sums[i]));
        }
      EXPECT_GT(largest, 0.05) << area;
      EXPECT_LT(worst, 1e-5 * largest) << "half-width " << area << (along ? ", along the normal" : ", free");
    }
}

TEST_F(SolverGL, AgreesWithAPlainSolverAfter200Steps) {
  struct Case {
    const char* name;
    SheetSetup setup;
    PushField field;
  };
  std::vector<Case> cases;
  auto ball = [](double c) {
    return
        [c](glm::dvec3 p) { return glm::length(p - glm::dvec3(8, -12, -7)) < 15 ? glm::vec2(float(c)) : glm::vec2(0); };
  };
  cases.push_back({"one kernel, free", sheetOf(24, false), oneKernel(500, false)});
  cases.push_back({"ball, sided", sheetOf(30), latticeOf(16, ball(200))});
  cases.push_back({"ball, free", sheetOf(30, false), latticeOf(16, ball(4))});
  cases.push_back({"attracted", sheetOf(30),
                   latticeOf(16, [](glm::dvec3 p) { return glm::vec2(0, std::abs(p.z + 6) < 3 ? -80 : 0); })});
  SheetSetup oblong = sheetOf(20);
  oblong.particles = {36, 21};
  oblong.half = {90, 40, 15};
  oblong.cloth.stretch = 0.4;
  oblong.cloth.bend = 0.7;
  cases.push_back({"oblong and stiff", oblong, latticeOf(16, ball(150))});
  // By hand: what pushes, what draws, what lifts, all by the sided rule at once; and what draws a free sheet.
  PushField hands;
  hands.placed = {{{-30, 20, 4}, 25.0, -250.0, 0.0}, {{28, -20, 7}, 30.0, 0.0, -90.0}};
  hands.placed.push_back({{5, 38, 2}, 22.0, 120.0, 60.0});
  hands.placed.push_back({{-25, -30, 0}, 35.0, 0.0, 0.0, 6.0});
  hands.placed.push_back({{-10, -22, 0}, 20.0, 0.0, 0.0, -3.5});
  cases.push_back({"by hand, sided", sheetOf(34), hands});
  PushField drawn;
  // It holds the whole frame, as the force would jump at its faces, and is weak: a sheet that is drawn together
  // buckles.
  drawn.placed.push_back({{6, -4, 30}, 110.0, 0.0, -16.0});
  cases.push_back({"by hand, free", sheetOf(24, false), drawn});
  cases.push_back({"fine, with strides", sheetOf(110), latticeOf(12, ball(150))});
  for (auto& c : cases) {
    Solver solver;
    solver.setSheet(c.setup);
    solver.setField(c.field);
    ReferenceSolver reference(c.setup, c.field);
    solver.step(200);
    reference.step(200);
    auto places = solver.readPlaces();
    double worst = 0, height = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      worst = std::max(worst, glm::length(glm::dvec3(places[i]) - reference.places()[i]));
      height = std::max(height, std::abs(reference.places()[i].z));
    }
    std::printf("%s: %.2e of the frame, height %.2f mm\n", c.name, worst / (2 * c.setup.half.x), height);
    EXPECT_GT(height, 0.5) << c.name;
    EXPECT_LT(worst, 1e-4 * 2 * c.setup.half.x) << c.name;
  }
}

TEST_F(SolverGL, TheSameStepsGiveTheSameBytes) {
  std::vector<glm::vec3> first;
  for (int i = 0; i < 2; ++i) {
    Solver solver;
    solver.setSheet(sheetOf(50, false));
    solver.setField(latticeOf(32, [](glm::dvec3 p) { return glm::vec2(float(100 * std::sin(p.x * p.y + p.z))); }));
    if (i == 0)
      solver.step(60);
    else
      for (int j = 0; j < 12; ++j) solver.step(5);
    auto places = solver.readPlaces();
    if (i == 0)
      first = places;
    else
      EXPECT_EQ(places, first);
  }
}

}  // namespace
}  // namespace velum::membrane
