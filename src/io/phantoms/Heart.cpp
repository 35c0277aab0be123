#include "io/phantoms/Heart.h"

namespace velum::io {

using namespace heart;

namespace {

enum Part : std::uint16_t {
  kMuscle = 1,
  kLeftVentricle,
  kRightVentricle,
  kLeftAtrium,
  kRightAtrium,
  kAorta,
  kPulmonaryArtery,
  kVenaCava,
  kCoronaries,
  kFat
};

constexpr float kWidthMm = 172.0f;
constexpr double kBeatSeconds = 0.84;
const Vec kRoots(-10.0f, 0.0f, 12.0f);  // where the great vessels leave the heart

std::vector<LabelInfo> table() {
  return {{kMuscle, "heart muscle", {0.72f, 0.30f, 0.26f}},
          {kLeftVentricle, "left ventricle", {0.88f, 0.35f, 0.33f}},
          {kRightVentricle, "right ventricle", {0.40f, 0.52f, 0.80f}},
          {kLeftAtrium, "left atrium", {0.93f, 0.52f, 0.45f}},
          {kRightAtrium, "right atrium", {0.52f, 0.62f, 0.86f}},
          {kAorta, "aorta", {0.86f, 0.22f, 0.22f}},
          {kPulmonaryArtery, "pulmonary artery", {0.30f, 0.45f, 0.80f}},
          {kVenaCava, "vena cava", {0.35f, 0.42f, 0.70f}},
          {kCoronaries, "coronary arteries", {0.95f, 0.45f, 0.25f}},
          {kFat, "fat", {0.95f, 0.85f, 0.55f}}};
}

/// Paths of great vessels, which move with the heart where they leave it, and rest away from it.
std::vector<Segment> vessel(std::initializer_list<std::vector<glm::vec4>> paths, const Beat& beat, float widen) {
  std::vector<Segment> all;
  for (const auto& path : paths) {
    std::vector<Segment> tubes = tube(path);
    auto moved = [&](Vec p) {
      constexpr float kNearMm = 34.0f, kFarMm = 72.0f;
      return glm::mix(beat.moved(p), p, smoothStep(kNearMm, kFarMm, glm::length(p - kRoots)));
    };
    for (auto& s : tubes) {
      s.a = moved(s.a), s.b = moved(s.b);
      s.radiusA *= widen, s.radiusB *= widen;
    }
    append(all, tubes);
  }
  return all;
}

std::vector<Segment> aorta(const Beat& beat) {
  return vessel({{{-5, 2, 5, 13},
                  {-12, -1, 17, 15},
                  {-20, -4, 37, 14.5f},
                  {-21, -1, 55, 14},
                  {-14, 13, 66, 13.5f},
                  {-2, 34, 66, 13},
                  {8, 52, 54, 12.5f},
                  {11, 62, 30, 12},
                  {11, 66, 0, 12},
                  {10, 66, -50, 11.5f},
                  {9, 66, -100, 11}}},
                beat, 1.0f + 0.07f * beat.ejection);
}

std::vector<Segment> pulmonaryArtery(const Beat& beat) {
  return vessel({{{0, -27, 17, 12.5f}, {3, -18, 37, 13}, {4, -2, 46, 12}},
                 {{4, -4, 45, 11}, {-9, 14, 41, 10.5f}, {-29, 20, 35, 10}, {-60, 30, 29, 8}},
                 {{4, -4, 45, 11}, {16, 14, 45, 10.5f}, {40, 30, 40, 8.5f}, {62, 38, 34, 7}}},
                beat, 1.0f + 0.06f * beat.ejection);
}

std::vector<Segment> venaCava(const Beat& beat) {
  return vessel({{{-36, 0, 100, 9}, {-38, 0, 62, 9.5f}, {-43, 2, 36, 10}, {-45, 2, 8, 10}},
                 {{-44, 6, -22, 11}, {-40, 18, -42, 11.5f}, {-37, 34, -62, 11.5f}, {-35, 40, -100, 11.5f}}},
                beat, 1.0f);
}

/// A solid whose distance is told at rest and evaluated where it has moved.
Layer solid(std::uint16_t label, float value, const Grid& grid, const Beat& beat, Distance atRest) {
  Layer layer{label, value};
  Vec half = 0.5f * Vec(grid.dims) * grid.spacing;
  layer.solids.push_back({{-half, half}, [beat, d = std::move(atRest)](Vec p) { return d(beat.rest(p)); }});
  return layer;
}

std::vector<Layer> layersOf(const Grid& grid, const Beat& beat) {
  std::vector<Layer> layers;
  auto add = [&](std::uint16_t label, float value, Distance d) {
    layers.push_back(solid(label, value, grid, beat, std::move(d)));
  };
  auto addTubes = [&](std::uint16_t label, float value, std::vector<Segment> tubes, float wallMm) {
    Layer layer{label, value};
    layer.tubes = std::move(tubes);
    for (auto& s : layer.tubes) s.radiusA += wallMm, s.radiusB += wallMm;
    layers.push_back(std::move(layer));
  };
  std::vector<Segment> twigs = coronaries(beat), arteries = aorta(beat), lungs = pulmonaryArtery(beat);
  // From outside in; walls first, then what they hold.
  addTubes(kFat, -85.0f, twigs, 2.2f);
  addTubes(kMuscle, 70.0f, arteries, 1.6f);
  addTubes(kMuscle, 70.0f, lungs, 1.4f);
  add(kMuscle, 105.0f, [beat](Vec p) { return outerSurface(p, beat); });
  layers.back().texture = [](Vec p) { return 6.0f * noise(p / 5.0f, 73); };
  addTubes(kVenaCava, 220.0f, venaCava(beat), 0.0f);
  add(kRightAtrium, 250.0f, [beat](Vec p) { return rightAtrium(p, beat, 0.0f); });
  add(kRightVentricle, 270.0f, [beat](Vec p) { return rightVentricle(p, beat, 0.0f); });
  add(kLeftAtrium, 350.0f, [beat](Vec p) { return leftAtrium(p, beat, 0.0f); });
  addTubes(kPulmonaryArtery, 285.0f, lungs, 0.0f);
  addTubes(kAorta, 370.0f, arteries, 0.0f);
  add(kLeftVentricle, 350.0f, [beat](Vec p) { return leftVentricle(p, beat); });
  add(kMuscle, 105.0f, [beat](Vec p) { return mitralValve(p, beat); });
  layers.back().onto = {kLeftVentricle, kLeftAtrium};
  addTubes(kCoronaries, 360.0f, twigs, 0.0f);
  return layers;
}

Sample makeStep(const Grid& grid, int timeStep, int timeSteps, Progress& progress) {
  Description description{"heart", SampleType::Int16, Modality::CT, "HU", table()};
  std::vector<Layer> layers = layersOf(grid, Beat(float(timeStep) / float(timeSteps)));
  return fill(description, grid, progress, [&](const Slice& slice) {
    // The lung around it.
    for (float& value : slice.values) value = -860.0f;
    paint(slice, layers);
    std::uint64_t first = grid.index(0, 0, slice.z);
    for (std::size_t i = 0; i < slice.values.size(); ++i)
      slice.values[i] += 9.0f * gaussian(hash(0x8ea7 + std::uint64_t(timeStep), first + i));
  });
}

}  // namespace

/// A beat in contrast-enhanced CT, its time steps apart by equal times, so that the last goes over into the first.
/// Labels are of the first step, the end of the filling, as label volumes have no time.
Sample makeHeart(int size, int timeSteps, Progress& progress) {
  Grid grid{glm::ivec3(size), Vec(kWidthMm / float(size))};
  Sample sample;
  for (int timeStep = 0; timeStep < timeSteps; ++timeStep) {
    Progress part([&](double done, const std::string& what) { progress.report((timeStep + done) / timeSteps, what); });
    Sample step = makeStep(grid, timeStep, timeSteps, part);
    if (timeStep == 0) {
      sample = std::move(step);
      sample.volume.voxels.reserve(sample.volume.voxels.size() * std::size_t(timeSteps));
    } else {
      sample.volume.voxels.insert(sample.volume.voxels.end(), step.volume.voxels.begin(), step.volume.voxels.end());
    }
  }
  sample.volume.timeSteps = timeSteps;
  sample.volume.timeStepSeconds = timeSteps > 1 ? kBeatSeconds / timeSteps : 0.0;
  computeRange(sample.volume);
  return sample;
}

}  // namespace velum::io
