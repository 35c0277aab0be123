#include "membrane/sheet/Simulation.h"

#include <algorithm>
#include <cmath>

#include "membrane/forces/Pins.h"
#include "membrane/sheet/Fairing.h"

#include "core/Assert.h"
#include "core/Vectors.h"
#include "scene/Scene.h"

namespace velum::membrane {

namespace {

/// Even a sheet that trembles rests after so many steps without a change, see Solver.
constexpr int kLongestCoarse = 400;
/// What hands have raised is drawn tight already: there the sheet falls back sooner.
constexpr double kRaisedShare = 0.15;
/// How far beside an obstacle the refined sheet has fallen back to a third, by the cloth's defaults: in mean edges of
/// the rest plane. A stiffer cloth spans more, one that is pulled back more strongly less.
constexpr double kPullLength = 1.0 / 48.0, kUsualStretch = 0.3, kUsualRestoring = 400.0;
/// So often it is asked whether the sheet rests: asking waits for the GPU. At ages of the sheet rather than at calls,
/// so that where it rests does not depend on how many steps at a time somebody has time for. Divides the above.
constexpr int kLookEvery = 8;

/// Where stakes stand between the middles of columns the sheet has so many rows and columns for each.
constexpr int kFinerAtStakes = 2;

glm::dvec3 halfOf(const scene::Cut& cut) { return solidEdges(cut.size) * 0.5; }

bool isSided(const scene::Cut& cut) { return cut.membrane->field.rule == scene::KernelRule::Sided; }

/// Places along one axis of the rest plane for a sheet with a particle in the middle of each column, and those on the
/// frame.
std::vector<float> alignedPlaces(double half, double origin, double step, int columns, int most) {
  std::vector<float> places{float(-half)};
  for (int i = 0; i < columns; ++i) {
    double at = origin + i * step;
    if (std::abs(at) < half - 0.01 * step) places.push_back(float(at));
  }
  places.push_back(float(half));
  if (int(places.size()) <= most) return places;
  places.clear();
  for (int i = 0; i < most; ++i) places.push_back(float(half * (2.0 * i / (most - 1) - 1.0)));
  return places;
}

/// Between which two of ascending numbers a number lies, and where between them.
std::pair<std::size_t, double> placeBetween(const std::vector<float>& numbers, double x) {
  auto above = std::upper_bound(numbers.begin() + 1, numbers.end() - 1, float(x));
  auto i = std::size_t(above - numbers.begin() - 1);
  double width = double(numbers[i + 1]) - double(numbers[i]);
  return {i, width > 0 ? std::clamp((x - double(numbers[i])) / width, 0.0, 1.0) : 0.0};
}

/// How far an obstacle makes itself felt in the refined sheet.
double pullLengthOf(const scene::Cut& cut) {
  const scene::Cloth& cloth = cut.membrane->cloth;
  if (cloth.restoring <= 0.0) return 0.0;
  double ease = cloth.stretch / kUsualStretch * (kUsualRestoring / cloth.restoring);
  return kPullLength * meanEdge(halfOf(cut)) * std::sqrt(std::max(ease, 1e-3));
}

}  // namespace

Simulation::Simulation() = default;
Simulation::~Simulation() = default;

glm::ivec2 Simulation::particles() const { return mFine.places.empty() ? mSolver->sheet().particles : mFine.particles; }

scene::SheetShape flatShape(const scene::Cut& cut, glm::ivec2 particles) {
  scene::SheetShape shape;
  shape.particles = glm::max(particles, glm::ivec2(3));
  glm::dvec2 half(halfOf(cut));
  for (int y = 0; y < shape.particles.y; ++y)
    for (int x = 0; x < shape.particles.x; ++x)
      shape.places.emplace_back(half * (2.0 * glm::dvec2(x, y) / glm::dvec2(shape.particles - 1) - 1.0), 0.0);
  return shape;
}

HeightOver heightOf(const scene::SheetShape& shape) {
  VELUM_ASSERT(shape.places.size() == std::size_t(shape.particles.x) * std::size_t(shape.particles.y),
               "each particle has its place");
  std::vector<float> xs, ys;
  // Of the rows and columns inside: those on the frame may be evenly spaced where a refined sheet is not.
  glm::ivec2 inner = glm::min(glm::ivec2(1), shape.particles - 1);
  auto placeOf = [&](int x, int y) { return shape.places[std::size_t(y * shape.particles.x + x)]; };
  for (int x = 0; x < shape.particles.x; ++x) xs.push_back(placeOf(x, inner.y).x);
  for (int y = 0; y < shape.particles.y; ++y) ys.push_back(placeOf(inner.x, y).y);
  return [shape, xs, ys](glm::dvec2 local) {
    auto [x, fx] = placeBetween(xs, local.x);
    auto [y, fy] = placeBetween(ys, local.y);
    auto at = [&](std::size_t i, std::size_t j) {
      return double(shape.places[j * std::size_t(shape.particles.x) + i].z);
    };
    return std::lerp(std::lerp(at(x, y), at(x + 1, y), fx), std::lerp(at(x, y + 1), at(x + 1, y + 1), fx), fy);
  };
}

scene::SheetShape carryOver(const scene::SheetShape& shape, const scene::Cut& from, const scene::Cut& to) {
  glm::dmat4 toFromFrom = glm::inverse(scene::worldFromCut(to)) * scene::worldFromCut(from);
  scene::SheetShape out = flatShape(to, shape.particles);
  glm::vec3 half(halfOf(to));
  if (isSided(to)) {
    // Rows and columns stay where they were across the rest plane, as a refined sheet has one for each voxel: they take
    // the height of the old sheet there.
    HeightOver old = heightOf(shape);
    glm::dmat4 back = glm::inverse(toFromFrom);
    glm::vec2 stretch(glm::dvec2(half) / glm::dvec2(halfOf(from)));
    for (std::size_t i = 0; i < out.places.size(); ++i) {
      glm::vec3& place = out.places[i];
      if (shape.places.size() == out.places.size()) place = glm::vec3(glm::vec2(shape.places[i]) * stretch, 0.0f);
      glm::dvec2 there(back * glm::dvec4(place, 1.0));
      place.z = std::clamp(float((toFromFrom * glm::dvec4(there, old(there), 1.0)).z), -half.z, half.z);
    }
  } else {
    for (std::size_t i = 0; i < out.places.size(); ++i)
      out.places[i] = glm::clamp(glm::vec3(toFromFrom * glm::dvec4(shape.places[i], 1.0)), -half, half);
  }
  return out;
}

scene::SheetShape carryOver(const scene::SheetShape& shape, const scene::Cut& to) {
  scene::Cut from = to;
  if (glm::length(shape.axis) > 0.0) {
    from.centre = shape.centre;
    from.axis = shape.axis;
    from.spinDeg = shape.spinDeg;
  }
  return carryOver(shape, from, to);
}

void anchor(scene::SheetShape& shape, const scene::Cut& cut, int timeStep) {
  shape.centre = cut.centre;
  shape.axis = cut.axis;
  shape.spinDeg = cut.spinDeg;
  shape.timeStep = timeStep;
}

void Simulation::begin(const scene::Cut& cut, Forces forces, const scene::SheetShape& start) {
  mCut = cut;
  mForces = std::move(forces);
  mSteps = 0;
  mPhase = Phase::Coarse;
  mFairing.reset();
  mFine = {};
  hang(glm::max(cut.membrane->cloth.particles, glm::ivec2(3)), start);
}

void Simulation::change(const scene::Cut& cut, Forces forces) { begin(cut, std::move(forces), shape()); }

/// A sheet of so many particles with the heights of another one.
void Simulation::hang(glm::ivec2 particles, const scene::SheetShape& start) {
  if (!mSolver) mSolver.emplace();
  mSolver->setSheet({particles, halfOf(mCut), mCut.membrane->cloth, isSided(mCut)});
  scene::SheetShape shape = flatShape(mCut, particles);
  if (start.particles == particles && !isSided(mCut)) {
    shape.places = start.places;
  } else if (start.particles.x > 1 && start.particles.y > 1) {
    HeightOver height = heightOf(start);
    for (auto& place : shape.places) place.z = float(height(glm::dvec2(place)));
  }
  mSolver->setPlaces(shape.places);
  applyForces();
}

void Simulation::applyForces() {
  PushField field = mForces.field;
  for (const auto& lift : liftsByPins(mCut)) field.placed.push_back(lift);
  mSolver->setField(field);
  std::vector<glm::vec3> places = mSolver->readPlaces();
  glm::dvec2 pitch = 2.0 * glm::dvec2(halfOf(mCut)) / glm::dvec2(mSolver->sheet().particles - 1);
  mSolver->setRoom(roomOf(mForces.corridor, places, pitch));
  mSolver->hold(heldByPins(mCut, mSolver->sheet().particles, places));
}

bool Simulation::isRaised() const {
  const auto& placed = mForces.field.placed;
  return !mCut.membrane->pins.empty() ||
         std::any_of(placed.begin(), placed.end(), [](const PlacedKernel& kernel) { return kernel.lift != 0.0; });
}

/// A particle in each column of the corridor, or as many as are allowed.
void Simulation::refine() {
  const Corridor& corridor = mForces.corridor;
  int most = std::max(mCut.membrane->cloth.finest, 3);
  glm::dvec3 half = halfOf(mCut);
  // Where voxels lie between the middles of columns the sheet has to bend there too.
  int finer = corridor.stakes.empty() ? 1 : kFinerAtStakes;
  auto along = [&](int axis) {
    return alignedPlaces(half[axis], corridor.origin[axis], corridor.step[axis] / finer, corridor.dims[axis] * finer,
                         most);
  };
  std::vector<float> xs = along(0), ys = along(1);
  glm::ivec2 particles(int(xs.size()), int(ys.size()));
  scene::SheetShape coarse = shape();
  // Where there is room for all columns it has one for each, even if those are fewer than it has now.
  bool hasAll = corridor.dims.x + 2 <= most && corridor.dims.y + 2 <= most;
  if (!hasAll && particles.x <= coarse.particles.x && particles.y <= coarse.particles.y)
    return void(mPhase = Phase::Rest);
  Fairing::Input input{xs, ys, heightOf(coarse), {}, corridor, half.z, pullLengthOf(mCut), {}};
  if (corridor.isDrawn) input.rest = heightOf(corridor);
  if (isRaised()) input.rest = input.start, input.pullLength *= kRaisedShare;
  input.holds = [this](glm::ivec2 count, const std::vector<glm::vec3>& places) {
    return heldByPins(mCut, count, places);
  };
  mFairing = std::make_unique<Fairing>(std::move(input));
  mPhase = Phase::Fine;
}

/// Hands the refined sheet over.
void Simulation::finish() {
  scene::SheetShape fine = mFairing->shape();
  std::vector<glm::vec4> places;
  for (glm::vec3 place : fine.places) places.emplace_back(place, 1.0f);
  mFinePlaces = gpu::Buffer("refined sheet", places.size() * sizeof(places[0]));
  mFinePlaces.write(0, places.size() * sizeof(places[0]), places.data());
  mFine = std::move(fine);
  mFairing.reset();
  mSpeed = 0.0;
  mPhase = Phase::Rest;
}

bool Simulation::advance(int steps) {
  if (mPhase == Phase::Rest || !mSolver) return false;
  while (steps > 0 && mPhase != Phase::Rest) {
    if (mPhase == Phase::Fine) {
      if (!mFairing->sweep()) finish();
      ++mSteps;
      --steps;
      continue;
    }
    int count = std::min(steps, kLookEvery - mSolver->age() % kLookEvery);
    mSolver->step(count);
    mSteps += count;
    steps -= count;
    if (mSolver->age() % kLookEvery == 0) look();
  }
  return true;
}

/// Goes on to the next phase where this one has come to its end.
void Simulation::look() {
  mSpeed = mSolver->speed();
  if (mSpeed > mSolver->restSpeed() && mSolver->age() < kLongestCoarse) return;
  if (mForces.corridor.dims.x > 0)
    refine();
  else
    mPhase = Phase::Rest;
}

scene::SheetShape Simulation::shape() const {
  if (!mFine.places.empty()) return mFine;
  scene::SheetShape shape;
  if (!mSolver) return shape;
  shape.particles = mSolver->sheet().particles;
  shape.places = mSolver->readPlaces();
  return shape;
}

}  // namespace velum::membrane
