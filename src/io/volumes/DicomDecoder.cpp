#include "io/volumes/DicomDecoder.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <map>
#include <mutex>

#include "core/Parallel.h"
#include "io/read/Refuse.h"
#include "io/volumes/DicomPixels.h"

namespace velum::io {

namespace {

/// Decodes the frames of a series into their slots.
class Decoder {
 public:
  Decoder(std::span<const DicomFile> files, const std::vector<DicomFrame>& frames, const DicomStack& stack)
      : mFiles(files), mFrames(frames), mStack(stack) {
    for (std::size_t i = 0; i < frames.size(); ++i)
      if (stack.slots[i] >= 0) mByFile[frames[i].file].push_back(i);
    mFirst = &frames[mByFile.begin()->second[0]];
    for (const auto& [file, members] : mByFile) mFileOrder.push_back(file);
  }

  void run(Volume& v, Progress& progress) {
    DicomPixelType type = DicomPixels(mFiles[mFirst->file]).type();
    mResult = type.channels == 1 && fitsInt16() ? Result::Int16 : isUniform() ? Result::Raw : Result::Values;
    v.type = mResult == Result::Values ? valueType() : mResult == Result::Int16 ? SampleType::Int16 : type.type;
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
    else if (mFiles[mFirst->file].photometric == "MONOCHROME1")
      v.warnings.push_back("the pictures are to be shown with white as zero (MONOCHROME1); values are the file's");
    mSliceBytes = std::size_t(type.columns) * std::size_t(type.rows) * std::size_t(type.channels) * sampleSize(v.type);
    v.voxels.resize(mSliceBytes * std::size_t(v.dims.z) * std::size_t(v.timeSteps));
    std::mutex mutex;
    std::size_t done = 0;
    parallelFor(std::size_t(0), mFileOrder.size(), [&](std::size_t i) {
      progress.throwIfCancelled();
      decodeFile(mFileOrder[i], type, v);
      std::lock_guard lock(mutex);
      progress.report(0.2 + 0.8 * double(++done) / double(mFileOrder.size()), "Decoding DICOM slices");
    });
  }

 private:
  enum class Result { Raw, Int16, Values };

  /// Slope 1 and whole intercepts that keep all that the stored bits can hold within int16.
  bool fitsInt16() const {
    for (const auto& [index, members] : mByFile) {
      const DicomFile& file = mFiles[index];
      bool isShort = file.bitsAllocated == 16 && file.bitsStored >= 1 && file.bitsStored <= 16;
      if (!isShort || !file.table.entries.empty()) return false;
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

  /// A float has 24 bits of its own; what has more needs a double.
  SampleType valueType() const {
    for (const auto& [index, members] : mByFile)
      if ((mFiles[index].isFloat ? mFiles[index].bitsAllocated > 32 : mFiles[index].bitsStored > 24))
        return SampleType::Float64;
    return SampleType::Float32;
  }

  bool isUniform() const {
    const DicomFile& reference = mFiles[mFirst->file];
    for (const auto& [index, members] : mByFile) {
      const DicomFile& file = mFiles[index];
      if (file.bitsAllocated != reference.bitsAllocated || file.isSigned != reference.isSigned) return false;
      if (!file.table.entries.empty()) return false;
      for (std::size_t i : members)
        if (mFrames[i].slope != mFirst->slope || mFrames[i].intercept != mFirst->intercept) return false;
    }
    return true;
  }

  void decodeFile(std::size_t file, const DicomPixelType& reference, Volume& v) const {
    const std::vector<std::size_t>& members = mByFile.at(file);
    const Path& path = mFiles[file].path;
    DicomPixels pixels(mFiles[file]);
    DicomPixelType type = pixels.type();
    bool isSame =
        type.columns == reference.columns && type.rows == reference.rows && type.channels == reference.channels;
    if (!isSame || (mResult == Result::Raw && type.type != reference.type))
      refuse(path, "the slice differs from its series in size or pixel type");
    for (std::size_t i : members)
      if (mFrames[i].index >= type.frames)
        refuse(path, fmt::format("frame {} of {} is missing", mFrames[i].index + 1, type.frames));
    // Frames that lie in the volume as they lie in the file are decoded in place.
    bool inPlace = mResult != Result::Values && int(members.size()) == type.frames;
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
      if (mResult == Result::Values) {
        if (v.type == SampleType::Float64)
          toValues<double>(from, type.type, mFrames[i], to);
        else
          toValues<float>(from, type.type, mFrames[i], to);
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

  template <class Value>
  void toValues(std::span<const std::byte> from, SampleType type, const DicomFrame& frame,
                std::span<std::byte> to) const {
    const DicomTable& table = mFiles[frame.file].table;
    Volume view;  // for the switch over types alone
    view.type = type;
    visitSamples(view, [&](auto* null) {
      using T = std::remove_cvref_t<decltype(*null)>;
      for (std::size_t i = 0; i < from.size() / sizeof(T); ++i) {
        T raw;
        std::memcpy(&raw, from.data() + i * sizeof(T), sizeof(T));
        auto value = Value(table.entries.empty() ? double(raw) * frame.slope + frame.intercept : table.at(double(raw)));
        std::memcpy(to.data() + i * sizeof(Value), &value, sizeof(Value));
      }
    });
  }

  std::span<const DicomFile> mFiles;
  const std::vector<DicomFrame>& mFrames;
  const DicomStack& mStack;
  std::map<std::size_t, std::vector<std::size_t>> mByFile;
  std::vector<std::size_t> mFileOrder;
  const DicomFrame* mFirst = nullptr;
  std::size_t mSliceBytes = 0;
  Result mResult = Result::Raw;
};

}  // namespace

void decodeDicom(std::span<const DicomFile> files, const std::vector<DicomFrame>& frames, const DicomStack& stack,
                 Volume& v, Progress& progress) {
  Decoder(files, frames, stack).run(v, progress);
}

}  // namespace velum::io
