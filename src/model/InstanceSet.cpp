#include "model/InstanceSet.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <span>

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

}  // namespace

template <class T>
InstanceSet::Rows InstanceSet::rowsOf(const char* label, gpu::Format format, const std::vector<T>& values) {
  T none{};
  gpu::Buffer buffer(label, values.empty() ? std::span<const T>(&none, 1) : std::span<const T>(values));
  gpu::Texture texels = gpu::Texture::makeOfBuffer(label, format, buffer);
  return {std::move(buffer), std::move(texels)};
}

InstanceSet::InstanceSet(const Model& model, const LevelSet& levels, const Placement& placement)
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
  mMolecules = rowsOf("molecules", gpu::Format::Rgba32f, molecules);
  std::vector<shared::LevelRow> rows;
  for (const Level& level : levels.levels)
    rows.push_back({level.first, level.count, level.error * scale, meanRadius(levels, level) * scale});
  mLevels = rowsOf("levels of detail", gpu::Format::Rgba32ui, rows);
  std::vector<glm::vec4> balls;
  std::vector<glm::u8vec2> kinds;
  balls.reserve(levels.balls.size());
  kinds.reserve(levels.balls.size());
  for (const Ball& ball : levels.balls) {
    balls.push_back(glm::vec4(ball.centre, ball.radius) * scale);
    kinds.emplace_back(ball.element, ball.chain);
  }
  mBalls = rowsOf("balls", gpu::Format::Rgba32f, balls);
  mKinds = rowsOf("elements and chains", gpu::Format::Rg8ui, kinds);
}

void InstanceSet::bind() const {
  mInstances.texels.bindSampler(shared::kInstanceUnit);
  mMolecules.texels.bindSampler(shared::kMoleculeUnit);
  mLevels.texels.bindSampler(shared::kLevelUnit);
  mBalls.texels.bindSampler(shared::kBallUnit);
  mKinds.texels.bindSampler(shared::kBallKindUnit);
}

std::uint64_t InstanceSet::bytes() const {
  return mInstances.buffer.bytes() + mMolecules.buffer.bytes() + mLevels.buffer.bytes() + mBalls.buffer.bytes() +
         mKinds.buffer.bytes();
}

}  // namespace velum::model
