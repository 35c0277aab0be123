#include "io/volumes/RawGuess.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <regex>
#include <set>

#include "io/read/FileBytes.h"
#include "io/read/FileNames.h"
#include "io/read/SampleBytes.h"
#include "io/volumes/FormatTable.h"

namespace velum::io {

namespace {

constexpr int kLeastPlanes = 4, kMostPlanes = 8192;
constexpr int kUsualSides[] = {64,  96,  100, 128, 150, 160, 180, 192,  200,  240,  250,  256, 300,
                               320, 350, 384, 400, 448, 450, 480, 500,  512,  600,  640,  700, 720,
                               750, 768, 800, 832, 896, 900, 960, 1000, 1024, 1280, 1536, 2048};
/// Of usual programs; others are typed.
constexpr int kUsualHeaders[] = {0, 6, 128, 256, 348, 352, 512, 1024, 2048, 4096};
constexpr SampleType kTypes[] = {SampleType::UInt8,   SampleType::Int8,   SampleType::UInt16, SampleType::Int16,
                                 SampleType::Float32, SampleType::UInt32, SampleType::Int32};
constexpr std::uint64_t kLooked = 96 * 1024;  ///< Bytes of the file that are looked at in one place.
constexpr std::uint64_t kStride = 7919;       ///< From a sample to one that is no neighbour; prime.
constexpr std::size_t kMostGuesses = 24;
constexpr double kTiny = 1e-30, kHuge = 1e30;    ///< Floats beyond are none that anybody has measured.
constexpr double kMostAbsurd = 1e-3;             ///< Share of them in samples that are floats.
constexpr double kFloatSteps = double(1 << 20);  ///< Of floats, that what they differ by is told in.
constexpr double kOblong = 1.02, kWithHeader = 1.04, kRareType = 1.3;

/// "256x256x109" in a name; nothing where there is none.
std::optional<glm::ivec3> dimsInName(const std::string& name) {
  static const std::regex kDims(R"((\d{1,5})[xX](\d{1,5})[xX](\d{1,5}))");
  std::smatch match;
  if (!std::regex_search(name, match, kDims)) return std::nullopt;
  glm::ivec3 dims(std::stoi(match[1]), std::stoi(match[2]), std::stoi(match[3]));
  bool isUsable = glm::all(glm::greaterThan(dims, glm::ivec3(0))) && glm::all(glm::lessThan(dims, glm::ivec3(65536)));
  return isUsable ? std::optional(dims) : std::nullopt;
}

/// Grids of so many voxels.
std::vector<glm::ivec3> gridsOf(std::uint64_t voxels) {
  std::vector<glm::ivec3> grids;
  auto cube = std::uint64_t(std::llround(std::cbrt(double(voxels))));
  if (cube < 65536 && cube * cube * cube == voxels) grids.emplace_back(int(cube));
  auto addStack = [&](int x, int y) {
    std::uint64_t plane = std::uint64_t(x) * std::uint64_t(y);
    if (voxels % plane != 0) return;
    std::uint64_t z = voxels / plane;
    if (z >= kLeastPlanes && z <= kMostPlanes) grids.emplace_back(x, y, int(z));
  };
  for (int x : kUsualSides)
    for (int y : kUsualSides)
      if (x <= 2 * y && y <= 2 * x) addStack(x, y);
  return grids;
}

/// Differences from the neighbours along one axis.
struct Steps {
  double sum = 0.0, logs = 0.0;
  std::size_t count = 0;
  void add(double difference) {
    sum += std::abs(difference);
    logs += std::log2(1.0 + std::abs(difference));
    ++count;
  }
  /// Bits that it takes to write one down: between what a two-sided exponential distribution of that mean needs, and
  /// what each needs by itself.
  double bits(double scale) const {
    if (count == 0) return 0.0;
    double mean = std::log2(1.0 + 2.0 * M_E * scale * sum / double(count));
    double own = scale == 1.0 ? logs / double(count) + 1.0 : mean;
    return 0.5 * (mean + own);
  }
};

/// What it would take to write the samples down by their differences. Wrong widths, types, byte orders and signs cost
/// bits.
class Cost {
 public:
  explicit Cost(const scene::RawLayout& layout) : mLayout(layout), mSize(sampleSize(layout.type)) {}

  /// Samples around a place of the file: the same bytes whatever the layout, so that layouts can be compared.
  void look(const FileBytes& file, double share) {
    auto header = std::uint64_t(mLayout.headerBytes);
    std::uint64_t all = (file.size() - header) / mSize, row = std::uint64_t(mLayout.dims.x),
                  plane = row * std::uint64_t(mLayout.dims.y);
    if (all <= plane + 1) return;
    auto first = std::uint64_t(share * double(all)), count = std::min(kLooked / mSize, all - plane - first);
    auto here = read(file, first, count + row), behind = read(file, first + plane, count);
    for (std::uint64_t i = 0; i < count; ++i) {
      std::uint64_t place = first + i;
      if ((place + 1) % row != 0) mSteps[0].add(here[i] - here[i + 1]);
      if (place % plane + row < plane) mSteps[1].add(here[i] - here[i + row]);
      mSteps[2].add(here[i] - behind[i]);
      mDeviation += std::abs(here[i] - here[(i * kStride) % count]);
    }
    mCount += count;
  }

  /// Bits a byte of the file; infinite for what nobody has measured.
  double perByte() const {
    if (mCount == 0 || double(mAbsurd) > kMostAbsurd * double(mCount)) return std::numeric_limits<double>::infinity();
    // Floats have no unit: their steps count as shares of how far samples are from each other.
    bool isFloat = mLayout.type == SampleType::Float32;
    double scale = isFloat ? kFloatSteps * double(mCount) / std::max(mDeviation, kTiny) : 1.0, bits = 0.0;
    for (const Steps& steps : mSteps) bits += std::min(steps.bits(scale), 8.0 * double(mSize));
    return bits / 3.0 / double(mSize);
  }

 private:
  std::vector<double> read(const FileBytes& file, std::uint64_t first, std::uint64_t count) {
    Volume part;
    part.dims = {int(count), 1, 1};
    part.type = mLayout.type;
    part.voxels.resize(count * mSize);
    file.read(std::uint64_t(mLayout.headerBytes) + first * mSize, part.voxels);
    toMachineOrder(part.voxels, mSize, mLayout.bigEndian);
    std::vector<double> values(count);
    visitSamples(part, [&](auto* samples) { std::copy_n(samples, count, values.begin()); });
    if (mLayout.type == SampleType::Float32)
      for (double& value : values) {
        bool isAbsurd = !std::isfinite(value) || std::abs(value) > kHuge || (value != 0.0 && std::abs(value) < kTiny);
        mAbsurd += isAbsurd;
        if (isAbsurd) value = 0.0;
      }
    return values;
  }

  const scene::RawLayout& mLayout;
  std::uint64_t mSize;
  Steps mSteps[3];  ///< Along x, y, z.
  double mDeviation = 0.0;
  std::size_t mCount = 0, mAbsurd = 0;
};

/// Something is added for what is unusual: of two layouts that are as smooth people mean the usual one.
double costOf(const FileBytes& file, const scene::RawLayout& layout) {
  Cost cost(layout);
  for (double share : {0.3, 0.5, 0.7}) cost.look(file, share);
  bool isRare = layout.type == SampleType::UInt32 || layout.type == SampleType::Int32;
  double unusual = (layout.dims.x == layout.dims.y ? 1.0 : kOblong) * (layout.headerBytes == 0 ? 1.0 : kWithHeader) *
                   (isRare ? kRareType : 1.0);
  return cost.perByte() * unusual;
}

bool isCompressed(const Path& path) { return lowerCase(path.extension().string()) == ".gz"; }

std::vector<scene::RawLayout> layoutsThatFit(const Path& path, std::uint64_t bytes) {
  std::vector<scene::RawLayout> found;
  auto named = dimsInName(path.filename().string());
  for (SampleType type : kTypes) {
    std::uint64_t size = sampleSize(type);
    auto add = [&](glm::ivec3 dims, int header) {
      for (bool bigEndian : {false, true})
        if (!bigEndian || size > 1) found.push_back({dims, type, 1, bigEndian, header});
    };
    if (named) {
      double header = double(bytes) - double(named->x) * named->y * named->z * double(size);
      if (header >= 0 && header <= kUsualHeaders[std::size(kUsualHeaders) - 1]) add(*named, int(header));
      continue;
    }
    for (int header : kUsualHeaders)
      if (bytes > std::uint64_t(header) && (bytes - std::uint64_t(header)) % size == 0)
        for (glm::ivec3 dims : gridsOf((bytes - std::uint64_t(header)) / size)) add(dims, header);
  }
  return found;
}

}  // namespace

bool needsLayout(const Path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error) || std::filesystem::file_size(path, error) == 0) return false;
  const FormatRow* row = chooseReader(readFileHead(path));
  return row && row->format.name == "Raw";
}

double bytesOf(const scene::RawLayout& layout) {
  return double(layout.dims.x) * layout.dims.y * layout.dims.z * layout.channels * double(sampleSize(layout.type)) +
         layout.headerBytes;
}

std::vector<scene::RawLayout> guessLayouts(const Path& path, Progress& progress) {
  if (isCompressed(path)) return {};
  FileBytes file(path);
  auto layouts = layoutsThatFit(path, file.size());
  std::vector<std::pair<double, scene::RawLayout>> rated;
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    progress.report(double(i) / double(layouts.size()), "Looking at the file");
    double cost = costOf(file, layouts[i]);
    if (std::isfinite(cost)) rated.emplace_back(cost, layouts[i]);
  }
  std::stable_sort(rated.begin(), rated.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<scene::RawLayout> best;
  for (std::size_t i = 0; i < std::min(rated.size(), kMostGuesses); ++i) best.push_back(rated[i].second);
  return best;
}

Volume readRawPlane(const scene::Source& source, int z) {
  if (isCompressed(source.path)) refuse(source.path, "is compressed; it has no preview");
  const scene::RawLayout& raw = source.raw;
  Volume plane;
  plane.dims = {raw.dims.x, raw.dims.y, 1};
  plane.type = raw.type;
  plane.channels = raw.channels;
  plane.isSpacingKnown = plane.isOrientationKnown = false;
  std::size_t bytes = voxelCount(plane) * std::size_t(raw.channels) * sampleSize(raw.type);
  FileBytes file(source.path);
  std::uint64_t at = std::uint64_t(raw.headerBytes) + std::uint64_t(z) * bytes;
  if (at + bytes > file.size()) refuse(source.path, "ends before this plane");
  plane.voxels.resize(bytes);
  file.read(at, plane.voxels);
  toMachineOrder(plane.voxels, sampleSize(raw.type), raw.bigEndian);
  computeRange(plane);
  return plane;
}

}  // namespace velum::io
