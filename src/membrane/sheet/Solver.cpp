#include "membrane/sheet/Solver.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "core/Assert.h"
#include "gpu/Program.h"
#include "gpu/Scope.h"
#include "membrane/sheet/BendStencil.h"
#include "shared/cloth.h"

namespace velum::membrane {

namespace {

constexpr double kReferenceMeshes = 49.0;  ///< stiffness is meant for a sheet of 50 particles along its mean edge
constexpr double kUnitsPerEdge = 128.0;
constexpr double kBelow = 0.05;  ///< of its half-width a placed kernel stands below its place

glm::dvec2 meshSize(const SheetSetup& setup) { return 2.0 * glm::dvec2(setup.half) / glm::dvec2(setup.particles - 1); }

/// Stiffness of one pass of several ([PBD] section 3.3).
double perIteration(double stiffness, int iterations) {
  return 1.0 - std::pow(1.0 - std::clamp(stiffness, 0.0, 1.0), 1.0 / iterations);
}

/// The share of its way that a particle goes in a step, of a sheet that nobody has touched for some steps.
float paceAt(int age) {
  double over = std::max(0, age - 200) / 40.0;
  return float(1.0 / (1.0 + over * over));
}

/// The three stages of a step, for particles that move along the normal only or freely.
struct Stages {
  explicit Stages(const char* along)
      : predict({"membrane/predict.comp"}, {{"ALONG", along}}),
        constrain({"membrane/constrain.comp"}, {{"ALONG", along}}),
        finish({"membrane/finish.comp"}, {{"ALONG", along}}) {}
  gpu::Program predict, constrain, finish;
};

}  // namespace

struct Solver::Programs {
  std::optional<Stages> along, free;
  Stages& stages(bool isAlongNormal) {
    auto& chosen = isAlongNormal ? along : free;
    if (!chosen) chosen.emplace(isAlongNormal ? "1" : "0");
    return *chosen;
  }
  gpu::UniformBuffer<shared::ClothParams> params{"cloth"};
  shared::ClothParams values{};
};

Solver::Solver() : mPrograms(std::make_unique<Programs>()), mRest("fastest particle", 16) {
  mSetup.particles = glm::ivec2(0);
  setField({});
}
Solver::~Solver() = default;

bool Solver::isBorder(int particle) const {
  glm::ivec2 at(particle % mSetup.particles.x, particle / mSetup.particles.x);
  return at.x == 0 || at.y == 0 || at.x == mSetup.particles.x - 1 || at.y == mSetup.particles.y - 1;
}

void Solver::setSheet(const SheetSetup& setup) {
  VELUM_ASSERT(setup.particles.x >= 2 && setup.particles.y >= 2, "a sheet has meshes");
  VELUM_ASSERT(setup.half.x > 0 && setup.half.y > 0, "its frame has a size");
  if (setup == mSetup) return;
  mSetup = setup;
  std::size_t bytes = std::size_t(count()) * sizeof(glm::vec4);
  mPlaces = gpu::Buffer("places", bytes);
  mVelocities = gpu::Buffer("velocities", bytes);
  mPing = gpu::Buffer("predicted", bytes);
  mPong = gpu::Buffer("corrected", bytes);
  std::vector<float> bend = bendStencils(meshSize(setup));
  mBend = gpu::Buffer("bend stencils", std::span<const float>(bend));
  std::vector<glm::vec3> flat;
  for (int i = 0; i < count(); ++i) {
    glm::dvec2 at(i % setup.particles.x, i / setup.particles.x);
    flat.emplace_back(glm::dvec2(setup.half) * (2.0 * at / glm::dvec2(setup.particles - 1) - 1.0), 0.0);
  }
  setPlaces(flat);
  setRoom({});
}

void Solver::setPlaces(std::span<const glm::vec3> places) {
  VELUM_ASSERT(places.size() == std::size_t(count()), "each particle has its place");
  mAge = 0;
  std::vector<glm::vec4> all;
  for (int i = 0; i < count(); ++i) all.emplace_back(places[std::size_t(i)], isBorder(i) ? 0.0f : 1.0f);
  mPlaces.write(0, all.size() * sizeof(glm::vec4), all.data());
  mVelocities.clear();
}

void Solver::hold(std::span<const HeldParticle> held) {
  mAge = 0;
  std::vector<glm::vec4> places(mPlaces.bytes() / sizeof(glm::vec4));
  mPlaces.read(0, places.size() * sizeof(glm::vec4), places.data());
  for (int i = 0; i < count(); ++i) places[std::size_t(i)].w = isBorder(i) ? 0.0f : 1.0f;
  for (const HeldParticle& one : held)
    if (one.particle >= 0 && one.particle < count() && !isBorder(one.particle)) {
      glm::vec3 half(mSetup.half);
      glm::vec4& place = places[std::size_t(one.particle)];
      glm::vec3 to = glm::clamp(one.place, -half, half);
      place = mSetup.isAlongNormal ? glm::vec4(place.x, place.y, to.z, 0.0f) : glm::vec4(to, 0.0f);
    }
  mPlaces.write(0, places.size() * sizeof(glm::vec4), places.data());
}

void Solver::setRoom(std::span<const glm::vec2> room) {
  VELUM_ASSERT(room.empty() || room.size() == std::size_t(count()), "each particle has its room");
  mAge = 0;
  float reach = float(mSetup.half.z);
  std::vector<glm::vec2> all(std::size_t(count()), glm::vec2(-reach, reach));
  if (!room.empty()) std::copy(room.begin(), room.end(), all.begin());
  mRoom = gpu::Buffer("room", std::span<const glm::vec2>(all));
}

void Solver::setField(const PushField& field) {
  VELUM_ASSERT(
      field.strengths.size() == std::size_t(field.dims.x) * std::size_t(field.dims.y) * std::size_t(field.dims.z),
      "each kernel has its strengths");
  mAge = 0;
  mField = field;
  mField.strengths.clear();
  std::vector<glm::vec2> strengths = field.strengths;
  if (strengths.empty()) strengths.emplace_back(0.0f);
  mKernels = gpu::Buffer("kernels", std::span<const glm::vec2>(strengths));
  std::vector<shared::ClothKernel> placed;
  for (const auto& kernel : field.placed) {
    // People put them on the rest plane, where a flat sheet would hang between both sides: a little lower, and it
    // moves.
    bool repels = kernel.push != 0.0 || kernel.pull > 0.0;
    glm::dvec3 centre = kernel.centre - glm::dvec3(0, 0, repels ? kBelow * kernel.halfWidth : 0.0);
    placed.push_back(
        {glm::vec4(centre, kernel.halfWidth), {float(kernel.push), float(kernel.pull), float(kernel.lift), 0}});
  }
  if (placed.empty()) placed.emplace_back();
  mPlacedKernels = gpu::Buffer("placed kernels", std::span<const shared::ClothKernel>(placed));
}

/// Of an iteration at each stride. For one shape of the sheet the corrections of a stretch constraint grow with the
/// square of its length, those of a bending constraint with the fourth power: the sum over the strides is made equal to
/// that of the reference sheet.
void Solver::fillStiffness() {
  auto& p = mPrograms->values;
  glm::dvec2 mesh = meshSize(mSetup);
  double finer = meanEdge(mSetup.half) / kReferenceMeshes / std::sqrt(mesh.x * mesh.y);
  int strides = 1, shortest = std::min(mSetup.particles.x, mSetup.particles.y);
  while (strides < shared::kMostStrides && (2 << (strides - 1)) <= 1.2 * finer && (2 << strides) < shortest) ++strides;
  double sum2 = 0, sum4 = 0;
  for (int i = 0; i < strides; ++i) sum2 += std::pow(4.0, i), sum4 += std::pow(16.0, i);
  double stretch = perIteration(mSetup.cloth.stretch, mSetup.cloth.iterations) * finer * finer / sum2;
  double bend = perIteration(mSetup.cloth.bend, mSetup.cloth.iterations) * std::pow(finer, 4.0) / sum4;
  bend *= std::min(shared::kBendEvery, mSetup.cloth.iterations);
  p.grid.w = strides;
  for (int i = 0; i < strides; ++i)
    p.stretch[i] = {float(std::min(stretch, 1.0 / strides)), float(std::min(bend, 1.0 / strides)), 0, 0};
}

void Solver::writeParams() {
  auto& p = mPrograms->values;
  p = {};
  glm::dmat4 localFromKernel = glm::inverse(mField.kernelFromLocal);
  glm::dmat3 axes(localFromKernel);
  glm::dvec3 spacing(glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]));
  double unit = meanEdge(mSetup.half) / kUnitsPerEdge;
  p.grid = {mSetup.particles, int(mField.placed.size()), 1};
  // Half a kernel is the most that a particle may pass in a step; without kernels a hundredth of the rest plane.
  double smallest = std::min(spacing.x, std::min(spacing.y, spacing.z));
  double longest = mField.dims.x > 0 ? 0.5 * smallest : unit;
  p.halfSize = glm::vec4(glm::vec3(mSetup.half), float(longest));
  const auto& cloth = mSetup.cloth;
  p.step = {float(cloth.timeStepS), float(std::exp(-cloth.damping * cloth.timeStepS)), float(cloth.restoring),
            float(unit)};
  p.kernelFromLocal = glm::mat4(mField.kernelFromLocal);
  p.spacing = glm::vec4(glm::vec3(spacing), float(std::cbrt(spacing.x * spacing.y * spacing.z)));
  p.lattice = {mField.dims, int(std::ceil(2.0 * mField.areaOfEffect))};
  p.axisX = glm::vec4(glm::vec3(axes[0] / spacing.x), float(mField.areaOfEffect));
  p.axisY = glm::vec4(glm::vec3(axes[1] / spacing.y), 0.0f);
  p.axisZ = glm::vec4(glm::vec3(axes[2] / spacing.z), 0.0f);
  fillStiffness();
  mPrograms->params.set(p);
}

void Solver::step(int steps) {
  if (count() == 0 || steps <= 0) return;
  gpu::Scope scope(nullptr, "Membrane");
  writeParams();
  mPrograms->params.bind(shared::kClothBinding);
  mPlaces.bindStorage(shared::kPlaceBinding);
  mVelocities.bindStorage(shared::kVelocityBinding);
  mKernels.bindStorage(shared::kKernelBinding);
  mPlacedKernels.bindStorage(shared::kUserKernelBinding);
  mRoom.bindStorage(shared::kRoomBinding);
  mBend.bindStorage(shared::kBendBinding);
  mRest.clear();
  Stages& stages = mPrograms->stages(mSetup.isAlongNormal);
  glm::ivec3 groups((mSetup.particles + shared::kClothGroup - 1) / shared::kClothGroup, 1);
  bool canBend = mPrograms->values.stretch[0].y > 0.0f;
  for (int i = 0; i < steps; ++i, ++mAge) {
    mPing.bindStorage(shared::kToBinding);
    gpu::dispatch(stages.predict, groups);
    gpu::barrier();
    const gpu::Buffer *from = &mPing, *to = &mPong;
    for (int pass = 0; pass < mSetup.cloth.iterations; ++pass) {
      from->bindStorage(shared::kFromBinding);
      to->bindStorage(shared::kToBinding);
      stages.constrain.set(0, canBend && pass % shared::kBendEvery == 0 ? 1 : 0);
      gpu::dispatch(stages.constrain, groups);
      gpu::barrier();
      std::swap(from, to);
    }
    from->bindStorage(shared::kFromBinding);
    mRest.bindStorage(shared::kRestBinding);
    stages.finish.set(0, i == steps - 1 ? 1 : 0);
    stages.finish.set(1, glm::vec4(paceAt(mAge)));
    gpu::dispatch(stages.finish, groups);
    gpu::barrier();
  }
}

double Solver::speed() const {
  std::uint32_t bits = 0;
  mRest.read(0, sizeof bits, &bits);
  return double(std::bit_cast<float>(bits));
}

double Solver::restSpeed() const { return 1e-3 * meanEdge(mSetup.half); }

std::vector<glm::vec3> Solver::readPlaces() const {
  std::vector<glm::vec4> all(mPlaces.bytes() / sizeof(glm::vec4));
  mPlaces.read(0, all.size() * sizeof(glm::vec4), all.data());
  return {all.begin(), all.end()};
}

std::vector<glm::vec3> Solver::readVelocities() const {
  std::vector<glm::vec4> all(mPlaces.bytes() / sizeof(glm::vec4));
  mVelocities.read(0, all.size() * sizeof(glm::vec4), all.data());
  return {all.begin(), all.end()};
}

}  // namespace velum::membrane
