#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "core/Parallel.h"
#include "core/SayCount.h"
#include "io/Plugins.h"
#include "io/read/ByteSource.h"
#include "io/volumes/DicomDecoder.h"
#include "io/volumes/DicomFile.h"
#include "io/volumes/DicomSoundness.h"
#include "io/volumes/DicomStack.h"
#include "io/volumes/ReadVolume.h"
#include "io/volumes/Readers.h"

namespace velum::io {

namespace {

constexpr double kMostSpreadBytes = 2e9;  ///< That are mostly nothing.

/// The files of one series, and which of them the user named.
struct Series {
  std::vector<DicomFile> files;
  int preferred = -1;
  std::vector<std::string> warnings;
};

Modality modalityOf(const std::string& code) {
  constexpr std::pair<std::string_view, Modality> kCodes[] = {
      {"CT", Modality::CT},          {"MR", Modality::MR},          {"PT", Modality::PET},
      {"US", Modality::Ultrasound},  {"XA", Modality::Angiography}, {"SM", Modality::Microscopy},
      {"IVUS", Modality::Ultrasound}};
  for (auto [known, modality] : kCodes)
    if (code == known) return modality;
  return Modality::Unknown;
}

/// The file that the user named, with words for each way in which it is no image.
DicomFile namedFile(const Path& path) {
  if (isGzip(path)) refuse(path, "is DICOM compressed by gzip; unpack it first");
  if (!isSoundDicom(path)) refuse(path, "is no DICOM file, or cut off or damaged: its elements do not fit together");
  auto file = readDicomHeader(path);
  if (!file) refuse(path, "is damaged, or no DICOM file");
  if (file->isSegmentation()) refuse(path, "is a DICOM segmentation; open it as labels");
  if (file->isRtStruct()) refuse(path, "is a DICOM structure set; open it as labels");
  if (!file->hasImage()) refuse(path, fmt::format("holds no image (DICOM modality {})", inQuotes(file->modality)));
  if (file->frames.empty()) refuse(path, "its number of frames is not possible");
  return *file;
}

/// The other images of the series lie in the file's folder. A multi-frame file is a volume of its own.
Series seriesOfFile(const Path& path, Progress& progress) {
  Series series;
  DicomFile named = namedFile(path);
  if (named.frames.size() > 1 || named.seriesUid.empty()) {
    series.files = {std::move(named)};
    return series;
  }
  for (DicomFile& file : scanDicomFolder(path.parent_path(), Depth::Folder, progress)) {
    bool isNamed = file.path.filename() == path.filename();
    // Files of the series that differ from the named one in kind (scouts, dose pictures) are not of its stack.
    if (file.seriesUid != named.seriesUid || file.frames.size() > 1 || file.holdsLabels()) continue;
    if (isNamed) series.preferred = int(series.files.size());
    series.files.push_back(std::move(file));
  }
  return series;
}

/// Of a folder with all that lies below it.
Series seriesOfFolder(const Path& folder, const std::string& wanted, Progress& progress) {
  std::map<std::string, std::vector<DicomFile>> all;
  for (DicomFile& file : scanDicomFolder(folder, Depth::AllBelow, progress))
    if (!file.holdsLabels()) all[file.seriesUid].push_back(std::move(file));
  if (all.empty()) refuse(folder, "the folder holds no DICOM images");
  auto count = [](const std::vector<DicomFile>& files) {
    std::size_t frames = 0;
    for (const DicomFile& file : files) frames += file.frames.size();
    return frames;
  };
  auto chosen = all.find(wanted);
  if (!wanted.empty() && chosen == all.end()) refuse(folder, fmt::format("holds no DICOM series {}", inQuotes(wanted)));
  if (wanted.empty())
    chosen =
        std::max_element(all.begin(), all.end(), [&](auto& a, auto& b) { return count(a.second) < count(b.second); });
  Series series{std::move(chosen->second), -1, {}};
  if (all.size() > 1)
    series.warnings.push_back(
        fmt::format("the folder holds {} DICOM series; {} was taken", all.size(),
                    series.files[0].description.empty() ? "the largest" : inQuotes(series.files[0].description)));
  return series;
}

/// All slices must have the size that most have; the one that has not is named.
void checkSizes(const Series& series) {
  std::map<std::pair<int, int>, int> votes;
  for (const DicomFile& file : series.files) ++votes[{file.columns, file.rows}];
  auto usual =
      std::max_element(votes.begin(), votes.end(), [](auto& a, auto& b) { return a.second < b.second; })->first;
  for (const DicomFile& file : series.files)
    if (std::pair(file.columns, file.rows) != usual)
      refuse(file.path, fmt::format("the slice has {} x {} pixels, the others of its series {} x {}", file.columns,
                                    file.rows, usual.first, usual.second));
}

bool sameOrientation(const DicomFrame& a, const DicomFrame& b) {
  if (!a.hasPlace || !b.hasPlace) return true;
  // 0.2 degrees: what rounding and head holders do, far less than the turn to a scout view.
  return glm::dot(a.rowDirection, b.rowDirection) > 0.99999 && glm::dot(a.columnDirection, b.columnDirection) > 0.99999;
}

/// Frames of the orientation that most have: scouts across the stack are often in its series.
std::vector<DicomFrame> framesOf(Series& series) {
  std::vector<std::vector<DicomFrame>> stacks;
  for (std::size_t i = 0; i < series.files.size(); ++i)
    for (DicomFrame frame : series.files[i].frames) {
      frame.file = i;
      auto at = std::find_if(stacks.begin(), stacks.end(), [&](auto& s) { return sameOrientation(s[0], frame); });
      (at == stacks.end() ? stacks.emplace_back() : *at).push_back(std::move(frame));
    }
  auto has = [&](const std::vector<DicomFrame>& stack) {
    return std::any_of(stack.begin(), stack.end(),
                       [&](const DicomFrame& f) { return int(f.file) == series.preferred; });
  };
  auto largest = std::max_element(stacks.begin(), stacks.end(), [&](auto& a, auto& b) {
    return std::pair(has(a), a.size()) < std::pair(has(b), b.size());
  });
  std::size_t others = 0;
  for (const auto& stack : stacks) others += &stack == &*largest ? 0 : stack.size();
  if (others > 0)
    series.warnings.push_back(sayCount(others, "1 image of another orientation was left out",
                                       "{} images of another orientation were left out"));
  return *largest;
}

template <class T>
void mixPlanes(const std::byte* a, const std::byte* b, double share, std::byte* to, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    T low, high;
    std::memcpy(&low, a + i * sizeof(T), sizeof(T));
    std::memcpy(&high, b + i * sizeof(T), sizeof(T));
    double value = double(low) + (double(high) - double(low)) * share;
    T result = std::is_integral_v<T> ? T(std::lround(value)) : T(value);
    std::memcpy(to + i * sizeof(T), &result, sizeof(T));
  }
}

/// The raw value that shows least: air, or black.
template <class T>
T leastOf(const Volume& v, const T* samples) {
  std::size_t count = v.voxels.size() / sizeof(T);
  auto [low, high] = std::minmax_element(samples, samples + count);
  return v.scale < 0 ? *high : *low;
}

/// Planes at uneven places onto the even grid, linearly between neighbours; nothing is made up between those that are
/// far apart, which are as thick as a step.
void resample(Volume& v, const DicomStack& stack) {
  if (stack.isEven) return;
  std::size_t slice = timeStepBytes(v) / std::size_t(v.dims.z), planes = std::size_t(v.dims.z),
              grid = std::size_t(stack.gridPlanes);
  Bytes result(slice * grid * std::size_t(v.timeSteps));
  visitSamples(v, [&](auto* samples) {
    using T = std::remove_cvref_t<decltype(*samples)>;
    T least = leastOf(v, samples);
    for (std::size_t t = 0; t < std::size_t(v.timeSteps); ++t)
      parallelFor(std::size_t(0), grid, [&](std::size_t z) {
        auto after = std::upper_bound(stack.positions.begin(), stack.positions.end(), double(z));
        std::size_t high = std::clamp<std::size_t>(std::size_t(after - stack.positions.begin()), 1, planes - 1),
                    low = high - 1;
        double apart = stack.positions[high] - stack.positions[low], past = double(z) - stack.positions[low],
               share = std::clamp(past / apart, 0.0, 1.0);
        std::byte* to = result.data() + slice * (grid * t + z);
        if (apart > stack.farthest) {
          if (std::min(past, apart - past) >= 0.5)
            return void(std::fill_n(reinterpret_cast<T*>(to), slice / sizeof(T), least));
          share = std::round(share);
        }
        const std::byte* from = v.voxels.data() + slice * planes * t;
        mixPlanes<T>(from + slice * low, from + slice * high, share, to, slice / sizeof(T));
      });
  });
  v.voxels = std::move(result);
  v.dims.z = stack.gridPlanes;
}

/// Unit of the values, and what the files that are in the volume have to say.
void describeValues(Volume& v, const Series& series, const DicomStack& stack, const std::vector<DicomFrame>& frames) {
  std::set<std::size_t> used;
  std::set<std::string> units;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (stack.slots[i] < 0) continue;
    used.insert(frames[i].file);
    units.insert(frames[i].unit.empty() ? "none" : frames[i].unit);
  }
  if (units.size() == 1 && !v.isColor && *units.begin() != "none") v.unit = *units.begin();
  if (units.size() > 1)
    v.warnings.push_back(fmt::format("slices differ in unit ({}); the volume has none", fmt::join(units, ", ")));
  std::vector<const DicomPet*> pets;
  for (std::size_t index : used) {
    const DicomFile& file = series.files[index];
    pets.push_back(&file.pet);
    for (const std::string& warning : file.warnings)
      if (std::find(v.warnings.begin(), v.warnings.end(), warning) == v.warnings.end()) v.warnings.push_back(warning);
  }
  Uptake uptake = uptakeOf(pets);
  if (!uptake.note.empty()) v.warnings.push_back(uptake.note);
  if (uptake.perActivity <= 0 || v.unit != "Bq/ml") return;
  v.scale *= uptake.perActivity;
  v.offset *= uptake.perActivity;
  v.unit = "SUVbw";
}

void describe(Volume& v, const Series& series, const DicomStack& stack, const std::vector<DicomFrame>& frames) {
  const DicomFile& file = series.files[frames[0].file];
  v.worldFromVoxel = stack.worldFromVoxel;
  v.isOrientationKnown = stack.isOrientationKnown;
  v.isSpacingKnown = stack.isSpacingKnown;
  v.gaps = stack.gaps;
  v.modality = modalityOf(file.modality);
  v.name = file.description;
  if (v.timeSteps > 1) v.timeStepSeconds = file.timeStepSeconds;
  v.warnings.insert(v.warnings.end(), series.warnings.begin(), series.warnings.end());
  v.warnings.insert(v.warnings.end(), stack.warnings.begin(), stack.warnings.end());
  describeValues(v, series, stack, frames);
}

}  // namespace

Volume plugin::readDicom(const scene::Source& source, Progress& progress) {
  Path path = source.path;
  bool isFolder = std::filesystem::is_directory(path), isIndex = !isFolder && isDicomIndex(path);
  if (isIndex) checkDicomIndex(path);
  Series series = isFolder || isIndex ? seriesOfFolder(isIndex ? path.parent_path() : path, source.series, progress)
                                      : seriesOfFile(path, progress);
  checkSizes(series);
  std::vector<DicomFrame> frames = framesOf(series);
  DicomStack stack = stackFrames(frames, series.preferred, path);
  const DicomFile& file = series.files[frames[0].file];
  double plane = double(file.rows) * file.columns * file.samplesPerPixel * std::max(file.bitsAllocated, 8) / 8.0;
  if (stack.gridPlanes > 2 * stack.planes && plane * stack.gridPlanes * stack.timeSteps > kMostSpreadBytes)
    refuse(path, fmt::format("its {} slices lie too far apart for a volume of this size", stack.planes));
  Volume v;
  decodeDicom(series.files, frames, stack, v, progress);
  resample(v, stack);
  describe(v, series, stack, frames);
  return v;
}

Volume plugin::readSeriesImage(const SeriesInfo& info, Progress& progress) {
  Series series{{namedFile(info.middleFile)}, -1, {}};
  std::vector<DicomFrame> frames{series.files[0].frames[series.files[0].frames.size() / 2]};
  frames[0].file = 0;
  DicomStack stack = stackFrames(frames, series.preferred, info.middleFile);
  Volume v;
  decodeDicom(series.files, frames, stack, v, progress);
  describe(v, series, stack, frames);
  computeRange(v);
  return v;
}

}  // namespace velum::io
