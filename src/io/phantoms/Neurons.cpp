#include <algorithm>

#include "io/phantoms/Phantom.h"

namespace velum::io {

using namespace phantom;

namespace {

constexpr float kExtentUm = 128.0f;

/// How one kind of process grows.
struct Habit {
  float startRadius, endRadius;  ///< um
  float length;                  ///< um, from the cell's body to the tips.
  float branching;               ///< Chance to fork per um.
  float wander;                  ///< Turn per step, as a part of a right angle.
  float spines;                  ///< Spines per um.
  Vec pull{0.0f};                ///< Direction that the process leans to.
};

class Cell {
 public:
  Cell(Vec soma, float radius, float leastRadius, std::uint64_t seed)
      : mRandom(seed), mSoma(soma), mRadius(radius), mLeast(leastRadius) {}

  std::vector<Segment> grow() {
    // The body: a pear that runs out into the apical dendrite.
    mSegments.push_back(
        {mSoma - Vec(0, 0, 0.25f * mRadius), mSoma + Vec(0, 0, 1.3f * mRadius), mRadius, 0.42f * mRadius});
    Vec up = glm::normalize(Vec(0.25f * mRandom.normal(), 0.25f * mRandom.normal(), 1.0f));
    extend(mSoma + Vec(0, 0, 1.2f * mRadius), up, {2.3f, 0.6f, 105.0f, 0.028f, 0.10f, 0.75f, Vec(0, 0, 0.05f)}, 0.0f,
           0);
    int basal = 5;
    float turn = mRandom.uniform(0.0f, 6.28f);
    for (int i = 0; i < basal; ++i) {
      float angle = turn + 6.2832f * float(i) / float(basal);
      Vec out = glm::normalize(Vec(std::cos(angle), std::sin(angle), mRandom.uniform(-0.75f, 0.15f)));
      extend(mSoma + out * (0.8f * mRadius), out, {1.6f, 0.55f, 62.0f, 0.03f, 0.14f, 0.65f, Vec(0)}, 0.0f, 0);
    }
    extend(mSoma - Vec(0, 0, mRadius), Vec(0.2f, 0.1f, -1.0f),
           {0.75f, 0.5f, 150.0f, 0.006f, 0.2f, 0.0f, Vec(0, 0, -0.03f)}, 0.0f, 0);
    return std::move(mSegments);
  }

 private:
  void extend(Vec at, Vec heading, const Habit& habit, float grown, int forks) {
    constexpr float kStep = 2.0f;
    auto radiusAt = [&](float length) {
      float t = std::min(length / habit.length, 1.0f);
      float thin = std::pow(0.82f, float(forks));
      return std::max(glm::mix(habit.startRadius, habit.endRadius, std::sqrt(t)) * thin, mLeast);
    };
    while (grown < habit.length) {
      heading = glm::normalize(heading + habit.wander * mRandom.direction() + habit.pull);
      Vec next = at + kStep * heading;
      mSegments.push_back({at, next, radiusAt(grown), radiusAt(grown + kStep)});
      // Boutons on the axon, spines on the dendrites.
      if (habit.spines == 0.0f && mRandom.uniform() < 0.12f)
        mSegments.push_back({next, next, 1.9f * radiusAt(grown), 1.9f * radiusAt(grown)});
      if (grown > 8.0f) addSpines(at, next, radiusAt(grown), habit.spines * kStep);
      at = next, grown += kStep;
      if (grown > 6.0f && forks < 4 && mRandom.uniform() < habit.branching * kStep) {
        Vec side = glm::normalize(glm::cross(heading, mRandom.direction()));
        extend(at, glm::normalize(heading + 0.75f * side), habit, grown + mRandom.uniform(0.0f, 12.0f), forks + 1);
        heading = glm::normalize(heading - 0.4f * side);
        ++forks;
      }
    }
  }

  void addSpines(Vec a, Vec b, float radius, float expected) {
    for (; expected > 0.0f; expected -= 1.0f) {
      bool grows = mRandom.uniform() < expected;
      Vec foot = glm::mix(a, b, mRandom.uniform()), out = glm::normalize(glm::cross(b - a, mRandom.direction()));
      float length = radius + mRandom.uniform(0.7f, 1.7f);
      if (!grows) continue;
      mSegments.push_back({foot, foot + out * length, 0.28f, 0.30f});
      float head = mRandom.uniform(0.42f, 0.7f);
      mSegments.push_back({foot + out * length, foot + out * length, head, head});
    }
  }

  Random mRandom;
  Vec mSoma;
  float mRadius, mLeast;
  std::vector<Segment> mSegments;
};

std::vector<Layer> growCells(float voxelUm) {
  struct Place {
    Vec soma;
    float radius, brightness;
  };
  constexpr float kBright = 9000.0f;
  const Place places[] = {{{-34, -20, -30}, 7.5f, 1.0f},
                          {{22, 30, -38}, 8.2f, 1.2f},
                          {{38, -34, -14}, 6.8f, 0.85f},
                          {{-22, 38, -4}, 7.2f, 1.05f},
                          {{4, -6, -52}, 7.8f, 0.95f}};
  std::vector<Layer> layers;
  for (std::size_t i = 0; i < std::size(places); ++i) {
    Layer layer{std::uint16_t(i + 1), kBright * places[i].brightness};
    layer.tubes = Cell(places[i].soma, places[i].radius, 0.8f * voxelUm, 500 + i).grow();
    layer.edge = 2.2f;  // The objective's blur.
    layers.push_back(std::move(layer));
  }
  return layers;
}

/// A sheet of light from the left: focused in the middle, weaker on the far side and in the depth.
float illumination(Vec p) {
  float along = p.x / kExtentUm;
  return (0.85f - 0.35f * along) * (1.0f - 0.7f * along * along) * (0.8f + 0.4f * p.z / kExtentUm) *
         (1.0f + 0.05f * std::sin(p.z * 0.9f) * smoothStep(-0.5f, 0.5f, along));
}

}  // namespace

/// Pyramidal cells with spiny dendrites and axons with boutons, as ultramicroscopy shows a cleared brain.
Sample makeNeurons(int size, Progress& progress) {
  Grid grid{glm::ivec3(size), Vec(kExtentUm / float(size)), 0.001};
  std::vector<Layer> layers = growCells(grid.spacing.x);
  Description description{"neurons", SampleType::UInt16, Modality::Microscopy, "", {}};
  const glm::vec3 colors[] = {{0.95f, 0.75f, 0.20f},
                              {0.25f, 0.75f, 0.55f},
                              {0.85f, 0.35f, 0.55f},
                              {0.35f, 0.60f, 0.95f},
                              {0.75f, 0.55f, 0.95f}};
  for (std::uint16_t i = 0; i < 5; ++i)
    description.table.push_back({std::uint16_t(i + 1), "neuron " + std::to_string(i + 1), colors[i]});
  return fill(description, grid, progress, [&](const Slice& slice) {
    std::fill(slice.values.begin(), slice.values.end(), 650.0f);
    paint(slice, layers);
    std::size_t i = 0;
    for (int y = 0; y < grid.dims.y; ++y)
      for (int x = 0; x < grid.dims.x; ++x, ++i) {
        Vec p = grid.at(x, y, slice.z);
        float photons = (slice.values[i] + 160.0f * noise(p / 14.0f, 3)) * illumination(p);
        // Shot noise: the variance follows the number of photons; 12 counts each.
        float shot = std::sqrt(12.0f * std::max(photons, 0.0f));
        slice.values[i] = 200.0f + photons + shot * gaussian(hash(0x9e0, grid.index(x, y, slice.z)));
      }
  });
}

}  // namespace velum::io
