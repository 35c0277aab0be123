#include "io/labels/LabelBricks.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "core/Parallel.h"
#include "io/labels/NumberReader.h"
#include "io/stores/HalvedSource.h"
#include "io/stores/ReadBox.h"
#include "io/stores/WideIds.h"

namespace velum::io {

namespace {

constexpr int kEdge = LabelVolume::kBrickSize;
constexpr double kBatchBytes = 256e6;  ///< of bricks that are unpacked side by side
constexpr std::size_t kMostOfBatch = 64;

std::size_t voxelsIn(glm::ivec3 size) { return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z); }

struct LevelPlace {
  const VoxelSource& source;
  int level;
  glm::dmat4 worldFromVoxel;
};

/// One level of a source.
class LevelReader {
 public:
  LevelReader(const LevelPlace& place, const LabelBrickOptions& how, Progress& progress)
      : mSource(place.source),
        mLevel(place.source.levels()[std::size_t(place.level)]),
        mWorldFromVoxel(place.worldFromVoxel),
        mNumber(place.level),
        mHow(how),
        mProgress(progress) {}

  /// Nothing where the labels take more than they may. @throw TooManyIds
  std::optional<LabelVolume> read(LabelNumbers& numbers);
  NumberCounts count();

 private:
  /// The ids of a brick; a single one where all of its voxels have it, none where nothing was read: they are 0.
  using Ids = std::vector<std::uint16_t>;

  template <class Work, class Take>
  void forBricks(const char* what, const Work& work, const Take& take);
  BrickAddress addressOf(std::size_t number) const;
  bool isEmpty(const BrickAddress& address) const { return mSource.range(address) == glm::dvec2(0.0); }
  Bytes samplesOf(const BrickAddress& address) const;
  Ids idsOf(const BrickAddress& address, LabelNumbers& numbers) const;
  void put(LabelVolume& labels, const BrickBox& box, Ids& ids);

  const VoxelSource& mSource;
  const VoxelLevel& mLevel;
  glm::dmat4 mWorldFromVoxel;
  int mNumber;
  const LabelBrickOptions& mHow;
  Progress& mProgress;
  double mBytes = 0;
};

BrickAddress LevelReader::addressOf(std::size_t number) const {
  glm::ivec3 grid = bricksOf(mLevel);
  auto x = std::size_t(grid.x), y = std::size_t(grid.y);
  return {mNumber, {int(number % x), int(number / x % y), int(number / (x * y))}, 0, 0};
}

/// Does work(address) on all cores, then hands what it gave to take(address, result), in order, until that is false.
template <class Work, class Take>
void LevelReader::forBricks(const char* what, const Work& work, const Take& take) {
  std::size_t count = voxelsIn(bricksOf(mLevel));
  double bytes = double(voxelsIn(mLevel.brickSize)) * double(sampleSize(mSource.head().type) + sizeof(std::uint16_t)) *
                 mLevel.brickChannels * mLevel.brickTimeSteps;
  std::size_t batch = std::clamp(std::size_t(kBatchBytes / bytes), std::size_t(1), kMostOfBatch);
  std::vector<decltype(work(BrickAddress{}))> results(batch);
  for (std::size_t first = 0; first < count; first += batch) {
    mProgress.report(double(first) / double(count), what);
    std::size_t end = std::min(first + batch, count);
    parallelFor(first, end, [&](std::size_t i) {
      mProgress.throwIfCancelled();
      results[i - first] = work(addressOf(i));
    });
    for (std::size_t i = first; i < end; ++i)
      if (!take(addressOf(i), results[i - first])) return;
  }
}

Bytes LevelReader::samplesOf(const BrickAddress& address) const {
  BrickBox box = boxOf(mSource, address);
  Bytes samples(bytesOf(box, mSource.head().type));
  mSource.read(address, targetIn(samples.data(), box, mSource.head().type));
  return samples;
}

LevelReader::Ids LevelReader::idsOf(const BrickAddress& address, LabelNumbers& numbers) const {
  if (isEmpty(address)) return {};
  // Those of the first channel and time step come first.
  std::size_t count = voxelsIn(boxOf(mSource, address).size);
  bool isNarrow = hasNarrowIds(mSource.head());
  std::unordered_map<std::uint64_t, std::uint16_t> here;
  auto idOf = [&](std::uint64_t number) {
    if (number == 0 || isNarrow) return std::uint16_t(number);
    auto [found, isNew] = here.try_emplace(number, std::uint16_t(0));
    if (isNew) found->second = numbers.take(number);
    return found->second;
  };
  Ids ids;
  NumberReader{mSource.head(), mHow}.forRuns(samplesOf(address), count, [&](std::uint64_t number, std::size_t run) {
    std::uint16_t id = idOf(number);
    ids.reserve(run == count ? 1 : count);
    ids.insert(ids.end(), run == count ? 1 : run, id);
  });
  return ids;
}

/// Writes the ids of a brick, and counts what they take.
void LevelReader::put(LabelVolume& labels, const BrickBox& box, Ids& ids) {
  if (ids.empty() || (ids.size() == 1 && ids[0] == 0)) return;
  glm::ivec3 end = box.origin + box.size, first = box.origin / kEdge, last = (end - 1) / kEdge, at;
  auto forEach = [&](const auto& body) {
    for (at.z = first.z; at.z <= last.z; ++at.z)
      for (at.y = first.y; at.y <= last.y; ++at.y)
        for (at.x = first.x; at.x <= last.x; ++at.x) body();
  };
  auto bytesAt = [&] {
    std::size_t size = labels.brick(at).size();
    return size > 1 ? double(size * sizeof(std::uint16_t)) : 0.0;
  };
  forEach([&] { mBytes -= bytesAt(); });
  if (ids.size() > 1 || voxelsIn(box.size) == 1) {
    labels.write(box.origin, box.size, ids);
  } else {
    Ids part;
    forEach([&] {
      glm::ivec3 corner = at * kEdge, low = glm::max(corner, box.origin),
                 high = glm::min(glm::min(corner + kEdge, labels.dims()), end);
      bool isWhole = low == corner && high == glm::min(corner + kEdge, labels.dims());
      if (isWhole) return labels.fillBrick(at, ids[0]);
      part.assign(voxelsIn(high - low), ids[0]);
      labels.write(low, high - low, part);
    });
  }
  forEach([&] { mBytes += bytesAt(); });
}

std::optional<LabelVolume> LevelReader::read(LabelNumbers& numbers) {
  LabelVolume labels(mLevel.dims, mWorldFromVoxel, mHow.unit);
  auto take = [&](const BrickAddress& address, Ids& ids) {
    put(labels, boxOf(mSource, address), ids);
    return mBytes <= mHow.mostBytes;
  };
  forBricks(
      "Reading labels", [&](const BrickAddress& address) { return idsOf(address, numbers); }, take);
  if (mBytes > mHow.mostBytes) return std::nullopt;
  return labels;
}

NumberCounts LevelReader::count() {
  NumberCounts all;
  auto work = [&](const BrickAddress& address) {
    NumberCounts counts;
    if (isEmpty(address)) return counts;
    NumberReader{mSource.head(), mHow}.forRuns(samplesOf(address), voxelsIn(boxOf(mSource, address).size),
                                               [&](std::uint64_t number, std::size_t run) { counts[number] += run; });
    return counts;
  };
  forBricks("Counting ids", work, [&](const BrickAddress&, NumberCounts& counts) {
    for (auto [number, voxels] : counts) all[number] += voxels;
    return true;
  });
  all.erase(0);
  return all;
}

/// Gives all voxels the ids that are theirs for good.
void renumber(LabelVolume& labels, const std::vector<std::uint16_t>& ids) {
  bool isSame = true;
  for (std::size_t i = 0; i < ids.size(); ++i) isSame = isSame && ids[i] == i;
  if (isSame) return;
  glm::ivec3 grid = labels.brickGrid(), at;
  std::vector<std::uint16_t> voxels;
  for (at.z = 0; at.z < grid.z; ++at.z)
    for (at.y = 0; at.y < grid.y; ++at.y)
      for (at.x = 0; at.x < grid.x; ++at.x) {
        const LabelVolume::Brick& brick = labels.brick(at);
        if (brick.size() == 1) {
          labels.fillBrick(at, ids[brick[0]]);
          continue;
        }
        glm::ivec3 corner = at * kEdge, size = glm::min(labels.dims() - corner, glm::ivec3(kEdge));
        voxels.resize(voxelsIn(size));
        labels.read(corner, size, voxels);
        for (std::uint16_t& id : voxels) id = ids[id];
        labels.write(corner, size, voxels);
      }
}

std::string sayChosen(const NumberCounts& counts, const std::vector<std::uint64_t>& chosen) {
  double all = 0, taken = 0;
  for (auto [number, voxels] : counts) all += double(voxels);
  for (std::uint64_t number : chosen) taken += double(counts.at(number));
  return fmt::format(
      "it has {} ids, and {} are the most that are read; the largest were taken, which have {:.3g} % of "
      "what is labelled",
      counts.size(), chosen.size(), 100.0 * taken / all);
}

/// A level as it is to be, or nothing where it does not fit.
std::optional<LabelVolume> readLevelWhole(const LevelPlace& place, const LabelBrickOptions& how, Progress& progress) {
  bool isNarrow = hasNarrowIds(place.source.head());
  auto finish = [&](std::optional<LabelVolume> labels, const LabelNumbers& numbers) {
    if (!labels || isNarrow) return labels;
    renumber(*labels, numbers.settle());
    labels->table = numbers.table();
    return labels;
  };
  try {
    LabelNumbers numbers(how.known);
    return finish(LevelReader(place, how, progress).read(numbers), numbers);
  } catch (const TooManyIds&) {
    NumberCounts counts = LevelReader(place, how, progress).count();
    auto chosen = mostFrequent(counts, how.known);
    LabelNumbers numbers(how.known, chosen);
    auto labels = finish(LevelReader(place, how, progress).read(numbers), numbers);
    if (labels) labels->warnings.push_back(sayChosen(counts, chosen));
    return labels;
  }
}

std::string dimsText(glm::ivec3 dims) { return fmt::format("{} x {} x {} voxels", dims.x, dims.y, dims.z); }

}  // namespace

LabelVolume readLabelBricks(const VoxelSource& source, const LabelBrickOptions& how, Progress& progress) {
  std::vector<std::unique_ptr<VoxelSource>> halved;  // each of the one before
  const VoxelSource* from = &source;
  int levels = int(source.levels().size()), level = how.level;
  auto place = [&]() -> LevelPlace {
    const glm::dmat4 &finest = source.levels().front().worldFromVoxel,
                     &here = from->levels()[std::size_t(level)].worldFromVoxel;
    return {*from, level, here == finest ? how.worldFromFinest : how.worldFromFinest * glm::inverse(finest) * here};
  };
  std::optional<LabelVolume> labels;
  while (!(labels = readLevelWhole(place(), how, progress))) {
    if (halved.empty() && how.mayBeCoarser && level + 1 < levels) {
      ++level;
      continue;
    }
    halved.push_back(std::make_unique<HalvedSource>(*from, level));
    from = halved.back().get();
    level = 0;
  }
  const auto& of = source.levels();
  glm::ivec3 wanted = of[std::size_t(how.level)].dims, dims = labels->dims();
  std::string note;
  if (dims != wanted)
    note = fmt::format("labels of {} take more memory than bricks may ({:.1f} GB); they were {} {}", dimsText(wanted),
                       how.mostBytes / 1e9, halved.empty() ? "read at a coarser level," : "halved to", dimsText(dims));
  else if (level > 0)
    note = fmt::format("level {} of 0 to {}, {}, were read; the finest has {}", level, levels - 1, dimsText(dims),
                       dimsText(of.front().dims));
  if (!note.empty()) labels->warnings.push_back(note);
  return std::move(*labels);
}

}  // namespace velum::io
