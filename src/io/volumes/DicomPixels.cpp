#include "io/volumes/DicomPixels.h"

#include <fmt/format.h>
#include <gdcmImage.h>
#include <gdcmImageChangePlanarConfiguration.h>
#include <gdcmPixmapReader.h>

#include <algorithm>
#include <cstring>
#include <fstream>

#include "io/read/FileBytes.h"
#include "io/read/StderrQuiet.h"
#include "io/volumes/DicomTags.h"

namespace velum::io {

namespace {

using gdcm::PhotometricInterpretation;
using gdcm::PixelFormat;
using gdcm::Tag;

/// Keeps the stored bits of each sample and extends the sign: high bits may hold overlays, and a JPEG 2000 stream may
/// disagree with the header about the sign.
template <class T>
void keepStoredBits(std::span<std::byte> bytes, int stored, int high, bool isSigned, bool invert) {
  using U = std::make_unsigned_t<T>;
  int width = int(sizeof(T)) * 8;
  int shift = std::max(0, high + 1 - stored);
  U mask = stored >= width ? U(~U(0)) : U((U(1) << stored) - 1), sign = U(U(1) << (stored - 1));
  for (std::size_t i = 0; i + sizeof(T) <= bytes.size(); i += sizeof(T)) {
    U value;
    std::memcpy(&value, bytes.data() + i, sizeof(T));
    value = U(U(value >> shift) & mask);
    // In two's complement, inverting the bits turns -2^n .. 2^n - 1 round; unsigned, 0 .. 2^n - 1.
    if (invert) value = U(~value & mask);
    if (isSigned && (value & sign)) value = U(value | U(~mask));
    std::memcpy(bytes.data() + i, &value, sizeof(T));
  }
}

/// Full-range YCbCr of JPEG to RGB, in place.
void rgbFromYbr(std::span<std::byte> bytes) {
  auto clamp = [](double v) { return std::byte(std::clamp(v + 0.5, 0.0, 255.0)); };
  for (std::size_t i = 0; i + 3 <= bytes.size(); i += 3) {
    double y = double(bytes[i]), b = double(bytes[i + 1]) - 128, r = double(bytes[i + 2]) - 128;
    bytes[i] = clamp(y + 1.402 * r);
    bytes[i + 1] = clamp(y - 0.344136 * b - 0.714136 * r);
    bytes[i + 2] = clamp(y + 1.772 * b);
  }
}

/// The colours of samples; as interleaved RGB of the palette's bits.
template <class Sample, class Channel>
void paint(const DicomPalette& palette, std::span<const std::byte> samples, std::span<std::byte> to) {
  int last = int(palette.entries[0].size()) - 1;
  for (std::size_t i = 0; i < samples.size() / sizeof(Sample); ++i) {
    Sample sample;
    std::memcpy(&sample, samples.data() + i * sizeof sample, sizeof sample);
    auto entry = std::size_t(std::clamp(int(sample) - palette.first, 0, last));
    for (std::size_t c = 0; c < 3; ++c) {
      auto channel = Channel(palette.entries[c][entry]);
      std::memcpy(to.data() + (i * 3 + c) * sizeof channel, &channel, sizeof channel);
    }
  }
}

template <class Sample>
void paint(const DicomPalette& palette, std::span<const std::byte> samples, std::span<std::byte> to) {
  if (palette.bits == 8)
    paint<Sample, std::uint8_t>(palette, samples, to);
  else
    paint<Sample, std::uint16_t>(palette, samples, to);
}

void paint(const DicomPalette& palette, SampleType type, std::span<const std::byte> samples, std::span<std::byte> to) {
  if (type == SampleType::UInt8) paint<std::uint8_t>(palette, samples, to);
  if (type == SampleType::Int8) paint<std::int8_t>(palette, samples, to);
  if (type == SampleType::UInt16) paint<std::uint16_t>(palette, samples, to);
  if (type == SampleType::Int16) paint<std::int16_t>(palette, samples, to);
}

/// GDCM's reader, which never sees a palette or an icon: damaged ones end the program.
class PixelReader : public gdcm::PixmapReader {
 protected:
  bool ReadImage(const gdcm::MediaStorage& storage) override {
    hide();
    return gdcm::PixmapReader::ReadImage(storage);
  }
  bool ReadACRNEMAImage() override {
    hide();
    return gdcm::PixmapReader::ReadACRNEMAImage();
  }

 private:
  void hide() {
    gdcm::DataSet& set = F->GetDataSet();
    const Tag photometric(0x0028, 0x0004), icon(0x0088, 0x0200);
    set.Remove(icon);
    if (textOf(set, photometric).find("PALETTE") == std::string::npos) return;
    gdcm::DataElement grey(photometric);
    grey.SetVR(gdcm::VR::CS);
    grey.SetByteValue("MONOCHROME2 ", 12);
    set.Replace(grey);
  }
};

SampleType sampleTypeOf(const PixelFormat& format, bool isSigned, const Path& path) {
  if (format == PixelFormat::FLOAT32) return SampleType::Float32;
  if (format == PixelFormat::FLOAT64) return SampleType::Float64;
  switch (format.GetBitsAllocated()) {
    case 8:
      return isSigned ? SampleType::Int8 : SampleType::UInt8;
    case 16:
      return isSigned ? SampleType::Int16 : SampleType::UInt16;
    case 32:
      return isSigned ? SampleType::Int32 : SampleType::UInt32;
    default:
      refuse(path, fmt::format("DICOM pixels of {} bits are not supported", format.GetBitsAllocated()));
  }
}

}  // namespace

struct DicomPixels::State {
  Path path;
  std::unique_ptr<PixelReader> reader = std::make_unique<PixelReader>();
  gdcm::SmartPointer<gdcm::Image> image;
  DicomPixelType type;
  SampleType sample = SampleType::UInt8;  ///< As stored: `type` is of colours where there is a palette.
  DicomPalette palette;
  std::size_t storedBytes = 0;
  int stored = 0, high = 0;
  bool isSigned = false, isYbr = false, isFloat = false;

  /// The samples as they are stored. @param to  storedBytes
  void decode(std::span<std::byte> to);
};

namespace {

/// What a file of compressed pixels may unfold to beyond any ratio: a blank JPEG 2000 picture takes no bytes at all.
constexpr std::uint64_t kBlankBytes = 64 << 20;

/// Refuses sizes that the pixel data cannot fill, before anything of that size is allocated.
void checkLengths(const gdcm::Image& image, std::uint64_t wanted, const Path& path) {
  const gdcm::DataElement& element = image.GetDataElement();
  const gdcm::ByteValue* bytes = element.GetByteValue();
  bool isPacked = element.GetSequenceOfFragments() != nullptr;
  if (isPacked && wanted > sizeOfFile(path) * 1040 + kBlankBytes)
    refuse(path, fmt::format("its header asks for {} bytes of pixels", wanted));
  if (isPacked) return;
  std::uint64_t have = bytes ? std::uint64_t(bytes->GetLength()) : 0;
  // Two pixels of 4:2:2 colour share four bytes; the codec unfolds them.
  if (image.GetPhotometricInterpretation() == PhotometricInterpretation::YBR_FULL_422) have = have * 3 / 2;
  if (have < wanted) refuse(path, fmt::format("the pixel data is cut off: {} bytes of {}", have, wanted));
}

/// What GDCM's codecs assert instead of checking.
void checkDescription(const DicomFile& file) {
  bool allocated =
      file.bitsAllocated == 8 || file.bitsAllocated == 16 || file.bitsAllocated == 32 || file.bitsAllocated == 64;
  bool stored = file.bitsStored >= 1 && file.bitsStored <= file.bitsAllocated;
  bool isWide = file.bitsAllocated > 16 || file.bitsStored > 16;
  if (!file.hasImage() || !allocated || !stored || (isWide && file.isJpeg))
    refuse(file.path,
           fmt::format("pixels of {} bits, {} of them stored, are not supported", file.bitsAllocated, file.bitsStored));
  if (!file.flaw.empty()) refuse(file.path, file.flaw);
  if (file.hasPalette() && (file.samplesPerPixel != 1 || file.bitsAllocated > 16))
    refuse(file.path, fmt::format("a palette for {} samples of {} bits is not supported", file.samplesPerPixel,
                                  file.bitsAllocated));
  if (file.samplesPerPixel != 1 && file.samplesPerPixel != 3)
    refuse(file.path, fmt::format("{} samples per pixel are not supported", file.samplesPerPixel));
}

}  // namespace

DicomPixels::DicomPixels(const DicomFile& file) : mState(std::make_unique<State>()) {
  checkDescription(file);
  const Path& path = file.path;
  State& s = *mState;
  s.path = path;
  // The image as GDCM has it, colours interleaved.
  StderrQuiet quiet;
  try {
    std::ifstream stream(path, std::ios::binary);
    s.reader->SetStream(stream);
    if (!s.reader->Read()) refuse(path, "the DICOM pixels cannot be read: missing, damaged, or of an unsupported kind");
    // Only the pixels are GDCM's: its reader of images also wants places and scales, and ends the program over them.
    s.image = new gdcm::Image;
    static_cast<gdcm::Pixmap&>(*s.image) = s.reader->GetPixmap();
    if (s.image->GetPlanarConfiguration() == 1) {
      gdcm::ImageChangePlanarConfiguration filter;
      filter.SetPlanarConfiguration(0);
      filter.SetInput(*s.image);
      if (!filter.Change()) refuse(path, "its colour planes cannot be interleaved");
      s.image = const_cast<gdcm::Image*>(&filter.GetOutput());  // shared with the filter, which ends here
    }
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    refuse(path, fmt::format("the DICOM pixels cannot be read ({})", inQuotes(error.what())));
  }
  // What its samples mean.
  const PixelFormat& format = s.image->GetPixelFormat();
  const gdcm::DataSet& set = s.reader->GetFile().GetDataSet();
  // The header decides about the sign: GDCM takes over what a JPEG 2000 stream says, which may differ.
  s.isSigned = binaryOf<std::uint16_t>(set, Tag(0x0028, 0x0103), format.GetPixelRepresentation()) == 1;
  s.isFloat = format == PixelFormat::FLOAT32 || format == PixelFormat::FLOAT64;
  int channels = format.GetSamplesPerPixel();
  if (channels > 1) s.isSigned = false;
  s.stored = std::clamp<int>(format.GetBitsStored(), 1, format.GetBitsAllocated());
  s.high = std::clamp<int>(format.GetHighBit(), s.stored - 1, format.GetBitsAllocated() - 1);
  // GDCM's clean-up of other bits than the stored ones knows 16 bits only and else ends the program; ours does it.
  if (format.GetBitsAllocated() != 16 && !s.isFloat && !file.isJpeg) {
    PixelFormat whole = format;
    whole.SetBitsStored(format.GetBitsAllocated());
    whole.SetHighBit(std::uint16_t(format.GetBitsAllocated() - 1));
    s.image->SetPixelFormat(whole);
  }
  auto photometric = s.image->GetPhotometricInterpretation();
  s.isYbr =
      photometric == PhotometricInterpretation::YBR_FULL || photometric == PhotometricInterpretation::YBR_FULL_422;
  s.type = {sampleTypeOf(format, s.isSigned, path),
            channels,
            int(s.image->GetDimension(0)),
            int(s.image->GetDimension(1)),
            s.image->GetNumberOfDimensions() > 2 ? int(s.image->GetDimension(2)) : 1,
            file.isToBeInverted()};
  s.sample = s.type.type;
  s.storedBytes = byteCount();
  checkLengths(*s.image, s.storedBytes, path);
  if (!file.hasPalette()) return;
  if (channels != 1 || sampleSize(s.sample) > 2) refuse(path, "its header and its pixel data disagree about colours");
  s.palette = file.palette;
  s.isYbr = false;
  s.type.channels = 3;
  s.type.type = file.palette.bits == 8 ? SampleType::UInt8 : SampleType::UInt16;
}

DicomPixels::~DicomPixels() = default;

const DicomPixelType& DicomPixels::type() const { return mState->type; }

std::size_t DicomPixels::byteCount() const {
  const DicomPixelType& t = mState->type;
  return std::size_t(t.columns) * std::size_t(t.rows) * std::size_t(t.frames) * std::size_t(t.channels) *
         sampleSize(t.type);
}

void DicomPixels::decode(std::span<std::byte> to) {
  State& s = *mState;
  if (s.palette.entries[0].empty()) return s.decode(to);
  std::vector<std::byte> samples(s.storedBytes);
  s.decode(samples);
  paint(s.palette, s.sample, samples, to);
}

void DicomPixels::State::decode(std::span<std::byte> to) {
  bool ok = false;
  try {
    StderrQuiet quiet;
    ok = image->GetBufferLength() == to.size() && image->GetBuffer(reinterpret_cast<char*>(to.data()));
  } catch (const std::exception&) {
    ok = false;
  }
  if (!ok) refuse(path, "the DICOM pixels cannot be decoded: cut off, damaged, or of an unsupported kind");
  image = nullptr;
  reader.reset();
  std::size_t bytes = sampleSize(sample);
  bool whole = stored == int(bytes) * 8 && high == stored - 1;
  if (!isFloat && (!whole || type.isInverted)) {
    if (bytes == 1) keepStoredBits<std::int8_t>(to, stored, high, isSigned, type.isInverted);
    if (bytes == 2) keepStoredBits<std::int16_t>(to, stored, high, isSigned, type.isInverted);
    if (bytes == 4) keepStoredBits<std::int32_t>(to, stored, high, isSigned, type.isInverted);
  }
  if (isYbr && type.channels == 3 && bytes == 1) rgbFromYbr(to);
}

}  // namespace velum::io
