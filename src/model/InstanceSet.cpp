#include "model/InstanceSet.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
#include <span>

#include "model/WholeModel.h"
#include "shared/bindings.h"
#include "shared/instance.h"

namespace velum::model {

namespace {

/// A coarser ball may reach a little beyond the sphere around the atoms.
float reachOf(const Molecule& molecule, std::size_t number, const LevelSet& levels) {
  float reach = 0.0f;
  for (const Level& level : levels.of(number))
    for (std::uint32_t i = level.first; i < level.first + level.count; ++i)
      reach = std::max(reach, glm::length(levels.balls[i].centre - molecule.centre) + levels.balls[i].radius);
  return reach;
}

/// A level of few balls, and how far these must grow to hold all balls of it and of the finer ones.
struct Outline {
  std::uint32_t level = 0;
  float grow = 0.0f;
};

Outline outlineOf(std::size_t molecule, const LevelSet& levels) {
  Outline outline{levels.firstLevel[molecule]};
  while (outline.level + 1 < levels.firstLevel[molecule + 1] &&
         levels.levels[outline.level].count > std::uint32_t(shared::kOutlineBalls))
    ++outline.level;
  auto ballsOf = [&](const Level& level) { return std::span(levels.balls).subspan(level.first, level.count); };
  auto around = ballsOf(levels.levels[outline.level]);
  for (std::uint32_t l = levels.firstLevel[molecule]; l <= outline.level; ++l)
    for (const Ball& ball : ballsOf(levels.levels[l])) {
      float least = std::numeric_limits<float>::max();
      for (const Ball& large : around)
        least = std::min(least, glm::length(ball.centre - large.centre) + ball.radius - large.radius);
      outline.grow = std::max(outline.grow, least);
    }
  return outline;
}

float meanRadius(const LevelSet& levels, const Level& level) {
  double sum = 0.0;
  for (std::uint32_t i = level.first; i < level.first + level.count; ++i) sum += double(levels.balls[i].radius);
  return float(sum / std::max(1u, level.count));
}

/// The bits of a number of 21 bits, each followed by two that are 0.
std::uint64_t spread(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffffull;
  x = (x | x << 16) & 0x1f0000ff0000ffull;
  x = (x | x << 8) & 0x100f00f00f00f00full;
  x = (x | x << 4) & 0x10c30c30c30c30c3ull;
  return (x | x << 2) & 0x1249249249249249ull;
}

/// Numbers of spheres in an order in which neighbours mostly stand beside each other: along Morton's curve.
std::vector<std::uint32_t> neighbourOrder(const std::vector<glm::vec4>& spheres) {
  glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
  for (const glm::vec4& sphere : spheres)
    low = glm::min(low, glm::vec3(sphere)), high = glm::max(high, glm::vec3(sphere));
  float scale = 2097151.0f / std::max({high.x - low.x, high.y - low.y, high.z - low.z, 1e-30f});
  std::vector<std::uint64_t> codes;
  codes.reserve(spheres.size());
  for (const glm::vec4& sphere : spheres) {
    glm::uvec3 at((glm::vec3(sphere) - low) * scale);
    codes.push_back(spread(at.x) | spread(at.y) << 1 | spread(at.z) << 2);
  }
  std::vector<std::uint32_t> order(spheres.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](auto a, auto b) { return codes[a] != codes[b] ? codes[a] < codes[b] : a < b; });
  return order;
}

/// A sphere around each bundle of instances, a little larger than it has to be: shaders compute in floats.
std::vector<glm::vec4> bundleSpheres(const std::vector<glm::vec4>& spheres, const std::vector<std::uint32_t>& order) {
  std::vector<glm::vec4> bundles;
  for (std::size_t first = 0; first < order.size(); first += std::size_t(shared::kBundle)) {
    auto numbers = std::span(order).subspan(first, std::min(std::size_t(shared::kBundle), order.size() - first));
    glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
    for (std::uint32_t i : numbers) {
      low = glm::min(low, glm::vec3(spheres[i]) - spheres[i].w);
      high = glm::max(high, glm::vec3(spheres[i]) + spheres[i].w);
    }
    glm::vec3 middle = 0.5f * (low + high);
    float radius = 0.0f;
    for (std::uint32_t i : numbers)
      radius = std::max(radius, glm::length(glm::vec3(spheres[i]) - middle) + spheres[i].w);
    bundles.emplace_back(middle, 1.0001f * radius + 1e-5f * glm::length(middle));
  }
  return bundles;
}

}  // namespace

template <class T>
InstanceSet::Rows InstanceSet::rowsOf(const char* label, gpu::Format format, const std::vector<T>& values) {
  T none{};
  gpu::Buffer buffer(label, values.empty() ? std::span<const T>(&none, 1) : std::span<const T>(values));
  gpu::Texture texels = gpu::Texture::makeOfBuffer(label, format, buffer);
  return {std::move(buffer), std::move(texels)};
}

/// The whole model becomes a molecule: the last one, with all its levels and balls.
void InstanceSet::addWhole(const WholeModel& whole, const Model& model, const Placement& placement, Tables to) {
  float scale = float(placement.scale), reach = 0.0f;
  glm::vec3 middle(0.5 * (glm::dvec3(model.low) + glm::dvec3(model.high)) * placement.scale - placement.origin);
  auto firstBall = std::uint32_t(to.balls.size()), firstLevel = std::uint32_t(to.levels.size());
  for (const WholeBall& ball : whole.balls) {
    to.balls.emplace_back(glm::vec3(glm::dvec3(ball.centre) * placement.scale - placement.origin), ball.radius * scale);
    to.kinds.emplace_back(ball.type & 0xff, ball.type >> 8 & 0xff);
    reach = std::max(reach, glm::length(glm::vec3(to.balls.back()) - middle) + to.balls.back().w);
  }
  auto addRow = [&](const Level& level) {
    to.levels.push_back({firstBall + level.first, level.count, level.error * scale, level.largest * scale});
  };
  for (std::size_t i = 0; i < whole.levels.size(); ++i) {
    addRow(whole.levels[i]);
    std::for_each(whole.sides[i].begin(), whole.sides[i].end(), addRow);
  }
  mWhole = {int(to.molecules.size()), glm::vec4(middle, reach), whole.levels.front().error * scale};
  to.molecules.push_back(
      {mWhole.sphere, 0, firstLevel, std::uint32_t(whole.levels.size()), reach, firstLevel, 0.0f, 0.0f, 0.0f});
}

InstanceSet::InstanceSet(const Model& model, const LevelSet& levels, const Placement& placement, bool hasWhole)
    : mInstanceCount(int(model.instances.size())) {
  float scale = float(placement.scale);
  std::vector<shared::InstanceRow> instances;
  instances.reserve(model.instances.size());
  for (const Instance& instance : model.instances) {
    glm::vec3 at(glm::dvec3(instance.position) * placement.scale - placement.origin);
    const glm::quat& q = instance.rotation;
    instances.push_back({glm::vec4(at, std::bit_cast<float>(instance.molecule)), glm::vec4(q.x, q.y, q.z, q.w)});
  }
  mInstances = rowsOf("instances", gpu::Format::Rgba32f, instances);
  std::vector<shared::MoleculeRow> molecules;
  for (std::size_t m = 0; m < model.molecules.size(); ++m) {
    const Molecule& molecule = model.molecules[m];
    Outline outline = outlineOf(m, levels);
    molecules.push_back({glm::vec4(molecule.centre, molecule.radius) * scale, molecule.type, levels.firstLevel[m],
                         std::uint32_t(levels.of(m).size()), reachOf(molecule, m, levels) * scale, outline.level,
                         outline.grow * scale, 0.0f, 0.0f});
  }
  std::vector<glm::vec4> spheres;
  spheres.reserve(instances.size());
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const Instance& instance = model.instances[i];
    const shared::MoleculeRow& molecule = molecules[instance.molecule];
    glm::vec3 middle = glm::vec3(instances[i].position) + instance.rotation * glm::vec3(molecule.sphere);
    spheres.emplace_back(middle, molecule.reach);
  }
  auto order = neighbourOrder(spheres);
  mOrder = rowsOf("instances of bundles", gpu::Format::R32ui, order);
  mBundles = rowsOf("bundles", gpu::Format::Rgba32f, bundleSpheres(spheres, order));
  std::vector<shared::LevelRow> rows;
  for (const Level& level : levels.levels)
    rows.push_back({level.first, level.count, level.error * scale, meanRadius(levels, level) * scale});
  std::vector<glm::vec4> balls;
  std::vector<glm::u8vec2> kinds;
  for (const Ball& ball : levels.balls) {
    balls.push_back(glm::vec4(ball.centre, ball.radius) * scale);
    kinds.emplace_back(ball.element, ball.chain);
  }
  if (hasWhole) addWhole(makeWholeModel(model, levels), model, placement, {molecules, rows, balls, kinds});
  mMolecules = rowsOf("molecules", gpu::Format::Rgba32f, molecules);
  mLevels = rowsOf("levels of detail", gpu::Format::Rgba32ui, rows);
  mBalls = rowsOf("balls", gpu::Format::Rgba32f, balls);
  mKinds = rowsOf("elements and chains", gpu::Format::Rg8ui, kinds);
}

void InstanceSet::bind() const {
  mInstances.texels.bindSampler(shared::kInstanceUnit);
  mMolecules.texels.bindSampler(shared::kMoleculeUnit);
  mLevels.texels.bindSampler(shared::kLevelUnit);
  mBalls.texels.bindSampler(shared::kBallUnit);
  mKinds.texels.bindSampler(shared::kBallKindUnit);
  mOrder.texels.bindSampler(shared::kOrderUnit);
  mBundles.texels.bindSampler(shared::kBundleUnit);
}

std::uint64_t InstanceSet::bytes() const {
  return mInstances.buffer.bytes() + mMolecules.buffer.bytes() + mLevels.buffer.bytes() + mBalls.buffer.bytes() +
         mKinds.buffer.bytes() + mOrder.buffer.bytes() + mBundles.buffer.bytes();
}

}  // namespace velum::model
