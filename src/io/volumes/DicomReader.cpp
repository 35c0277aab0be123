#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <mutex>

#include "DicomFile.h"
#include "DicomPixels.h"
#include "DicomSoundness.h"
#include "DicomStack.h"
#include "Readers.h"
#include "read/ByteSource.h"

namespace velum::io {

namespace {

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
  if (file->sopClass == "1.2.840.10008.1.3.10")
    refuse(path, "is only the index of a DICOM medium; open the folder that holds the images");
  if (file->isSegmentation()) refuse(path, "is a DICOM segmentation; open it as labels");
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
  for (DicomFile& file : scanDicomFolder(path.parent_path(), progress)) {
    bool isNamed = file.path.filename() == path.filename();
    // Files of the series that differ from the named one in kind (scouts, dose pictures) are not of its stack.
    if (file.seriesUid != named.seriesUid || file.frames.size() > 1 || file.isSegmentation()) continue;
    if (isNamed) series.preferred = int(series.files.size());
    series.files.push_back(std::move(file));
  }
  return series;
}

Series seriesOfFolder(const scene::Source& source, Progress& progress) {
  Path folder = source.path;
  std::map<std::string, std::vector<DicomFile>> all;
  for (DicomFile& file : scanDicomFolder(folder, progress))
    if (!file.isSegmentation()) all[file.seriesUid].push_back(std::move(file));
  if (all.empty()) refuse(folder, "the folder holds no DICOM images");
  auto count = [](const std::vector<DicomFile>& files) {
    std::size_t frames = 0;
    for (const DicomFile& file : files) frames += file.frames.size();
    return frames;
  };
  auto chosen = all.find(source.series);
  if (!source.series.empty() && chosen == all.end())
    refuse(folder, fmt::format("holds no DICOM series {}", inQuotes(source.series)));
  if (source.series.empty())
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
  if (others > 0) series.warnings.push_back(fmt::format("{} images of another orientation were left out", others));
  return *largest;
}

/// Decodes the frames of a series into their slots.
class Decoder {
 public:
  Decoder(const Series& series, const std::vector<DicomFrame>& frames, const DicomStack& stack)
      : mSeries(series), mFrames(frames), mStack(stack) {
    for (std::size_t i = 0; i < frames.size(); ++i)
      if (stack.slots[i] >= 0) mByFile[frames[i].file].push_back(i);
    mFirst = &frames[mByFile.begin()->second[0]];
    for (const auto& [file, members] : mByFile) mFileOrder.push_back(file);
  }

  /// Values become int16 where that is exact (CT as a rule); else raw samples are kept where one scale and type serve
  /// all slices; else values become floats.
  void run(Volume& v, Progress& progress) {
    DicomPixelType type = DicomPixels(mSeries.files[mFirst->file]).type();
    mResult = type.channels == 1 && fitsInt16() ? Result::Int16 : isUniform() ? Result::Raw : Result::Float;
    v.type = mResult == Result::Float ? SampleType::Float32 : mResult == Result::Int16 ? SampleType::Int16 : type.type;
    v.channels = type.channels;
    v.isColor = type.channels == 3;
    v.dims = {type.columns, type.rows, mStack.planes};
    v.timeSteps = mStack.timeSteps;
    if (mResult == Result::Raw && !v.isColor) {
      v.scale = mFirst->slope;
      v.offset = mFirst->intercept;
    }
    if (type.isInverted)
      v.warnings.push_back("the pictures are stored with white as zero (MONOCHROME1); they were turned round");
    mSliceBytes = std::size_t(type.columns) * std::size_t(type.rows) * std::size_t(type.channels) * sampleSize(v.type);
    v.voxels.resize(mSliceBytes * std::size_t(v.dims.z) * std::size_t(v.timeSteps));
    std::mutex mutex;
    std::size_t done = 0;
    tbb::parallel_for(std::size_t(0), mFileOrder.size(), [&](std::size_t i) {
      progress.throwIfCancelled();
      decodeFile(mFileOrder[i], type, v);
      std::lock_guard lock(mutex);
      progress.report(0.2 + 0.8 * double(++done) / double(mFileOrder.size()), "Decoding DICOM slices");
    });
  }

 private:
  enum class Result { Raw, Int16, Float };

  /// Slope 1 and whole intercepts that keep all that the stored bits can hold within int16.
  bool fitsInt16() const {
    for (const auto& [index, members] : mByFile) {
      const DicomFile& file = mSeries.files[index];
      if (file.bitsAllocated != 16 || file.bitsStored < 1 || file.bitsStored > 16) return false;
      double low = file.isSigned ? -std::exp2(file.bitsStored - 1) : 0.0;
      double high = std::exp2(file.bitsStored - (file.isSigned ? 1 : 0)) - 1;
      for (std::size_t i : members) {
        double intercept = mFrames[i].intercept;
        if (mFrames[i].slope != 1.0 || intercept != std::round(intercept)) return false;
        if (low + intercept < -32768 || high + intercept > 32767) return false;
      }
    }
    return true;
  }

  bool isUniform() const {
    const DicomFile& reference = mSeries.files[mFirst->file];
    for (const auto& [index, members] : mByFile) {
      const DicomFile& file = mSeries.files[index];
      if (file.bitsAllocated != reference.bitsAllocated || file.isSigned != reference.isSigned) return false;
      for (std::size_t i : members)
        if (mFrames[i].slope != mFirst->slope || mFrames[i].intercept != mFirst->intercept) return false;
    }
    return true;
  }

  void decodeFile(std::size_t file, const DicomPixelType& reference, Volume& v) const {
    const std::vector<std::size_t>& members = mByFile.at(file);
    const Path& path = mSeries.files[file].path;
    DicomPixels pixels(mSeries.files[file]);
    DicomPixelType type = pixels.type();
    bool isSame =
        type.columns == reference.columns && type.rows == reference.rows && type.channels == reference.channels;
    if (!isSame || (mResult == Result::Raw && type.type != reference.type))
      refuse(path, "the slice differs from its series in size or pixel type");
    for (std::size_t i : members)
      if (mFrames[i].index >= type.frames)
        refuse(path, fmt::format("frame {} of {} is missing", mFrames[i].index + 1, type.frames));
    // Frames that lie in the volume as they lie in the file are decoded in place.
    bool inPlace = mResult != Result::Float && int(members.size()) == type.frames;
    for (std::size_t i : members) inPlace = inPlace && mStack.slots[i] - mStack.slots[members[0]] == mFrames[i].index;
    if (inPlace) {
      auto to = std::span(v.voxels).subspan(mSliceBytes * std::size_t(mStack.slots[members[0]]), pixels.byteCount());
      pixels.decode(to);
      if (mResult == Result::Int16)
        for (std::size_t i : members) addIntercept(mFrames[i], slotOf(v, i));
      return;
    }
    Bytes scratch(pixels.byteCount());
    pixels.decode(scratch);
    std::size_t each = scratch.size() / std::size_t(type.frames);
    for (std::size_t i : members) {
      auto from = std::span(scratch).subspan(each * std::size_t(mFrames[i].index), each);
      auto to = slotOf(v, i);
      if (mResult == Result::Float) {
        toFloat(from, type.type, mFrames[i], to);
      } else {
        std::memcpy(to.data(), from.data(), each);
        if (mResult == Result::Int16) addIntercept(mFrames[i], to);
      }
    }
  }

  std::span<std::byte> slotOf(Volume& v, std::size_t frame) const {
    return std::span(v.voxels).subspan(mSliceBytes * std::size_t(mStack.slots[frame]), mSliceBytes);
  }

  /// Modulo 2^16, which is exact whether the raw samples are signed or not, for the sums are known to fit.
  static void addIntercept(const DicomFrame& frame, std::span<std::byte> samples) {
    auto intercept = std::uint16_t(std::int32_t(frame.intercept));
    if (intercept == 0) return;
    auto* at = reinterpret_cast<std::uint16_t*>(samples.data());
    for (std::size_t i = 0; i < samples.size() / 2; ++i) at[i] = std::uint16_t(at[i] + intercept);
  }

  static void toFloat(std::span<const std::byte> from, SampleType type, const DicomFrame& frame,
                      std::span<std::byte> to) {
    Volume view;  // for the switch over types alone
    view.type = type;
    visitSamples(view, [&](auto* null) {
      using T = std::remove_cvref_t<decltype(*null)>;
      for (std::size_t i = 0; i < from.size() / sizeof(T); ++i) {
        T raw;
        std::memcpy(&raw, from.data() + i * sizeof(T), sizeof(T));
        float value = float(double(raw) * frame.slope + frame.intercept);
        std::memcpy(to.data() + i * sizeof(float), &value, sizeof(float));
      }
    });
  }

  const Series& mSeries;
  const std::vector<DicomFrame>& mFrames;
  const DicomStack& mStack;
  std::map<std::size_t, std::vector<std::size_t>> mByFile;
  std::vector<std::size_t> mFileOrder;
  const DicomFrame* mFirst = nullptr;
  std::size_t mSliceBytes = 0;
  Result mResult = Result::Raw;
};

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

/// Planes at uneven places onto the even grid, linearly between neighbours.
void resample(Volume& v, const DicomStack& stack) {
  if (stack.isEven) return;
  std::size_t slice = timeStepBytes(v) / std::size_t(v.dims.z), planes = std::size_t(v.dims.z),
              grid = std::size_t(stack.gridPlanes);
  Bytes result(slice * grid * std::size_t(v.timeSteps));
  for (std::size_t t = 0; t < std::size_t(v.timeSteps); ++t)
    tbb::parallel_for(std::size_t(0), grid, [&](std::size_t z) {
      auto after = std::upper_bound(stack.positions.begin(), stack.positions.end(), double(z));
      std::size_t high = std::clamp<std::size_t>(std::size_t(after - stack.positions.begin()), 1, planes - 1),
                  low = high - 1;
      double share =
          std::clamp((double(z) - stack.positions[low]) / (stack.positions[high] - stack.positions[low]), 0.0, 1.0);
      const std::byte* from = v.voxels.data() + slice * planes * t;
      visitSamples(v, [&](auto* null) {
        using T = std::remove_cvref_t<decltype(*null)>;
        mixPlanes<T>(from + slice * low, from + slice * high, share, result.data() + slice * (grid * t + z),
                     slice / sizeof(T));
      });
    });
  v.voxels = std::move(result);
  v.dims.z = stack.gridPlanes;
}

void describe(Volume& v, const Series& series, const DicomStack& stack, const std::vector<DicomFrame>& frames) {
  const DicomFile& file = series.files[frames[0].file];
  v.worldFromVoxel = stack.worldFromVoxel;
  v.isOrientationKnown = stack.isOrientationKnown;
  v.isSpacingKnown = stack.isSpacingKnown;
  v.modality = modalityOf(file.modality);
  v.unit = v.modality == Modality::CT ? "HU" : file.unit == "US" ? "" : file.unit;
  v.name = file.description;
  if (v.timeSteps > 1) v.timeStepSeconds = file.timeStepSeconds;
  v.warnings.insert(v.warnings.end(), series.warnings.begin(), series.warnings.end());
  v.warnings.insert(v.warnings.end(), stack.warnings.begin(), stack.warnings.end());
}

}  // namespace

Volume readDicom(const scene::Source& source, Progress& progress) {
  Path path = source.path;
  Series series = std::filesystem::is_directory(path) ? seriesOfFolder(source, progress) : seriesOfFile(path, progress);
  checkSizes(series);
  std::vector<DicomFrame> frames = framesOf(series);
  DicomStack stack = stackFrames(frames, series.preferred, path);
  Volume v;
  Decoder(series, frames, stack).run(v, progress);
  resample(v, stack);
  describe(v, series, stack, frames);
  return v;
}

}  // namespace velum::io
