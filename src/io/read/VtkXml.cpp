#include "io/read/VtkXml.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "core/Text.h"
#include "io/read/ByteSource.h"
#include "io/read/Payload.h"
#include "io/read/SampleBytes.h"

namespace velum::io {

namespace {

constexpr std::size_t kPiece = 1 << 20;

/// The most bytes that one packed byte can become.
double expansionOf(VtkPacking packing) {
  constexpr double kRatios[] = {1, double(kDeflateRatio), 256, 20000};
  return kRatios[static_cast<int>(packing)];
}

/// -1: no digit; -2: padding; -3: to be passed over.
int base64Digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '/') return c == '+' ? 62 : 63;
  if (c == '=') return -2;
  return c == ' ' || c == '\n' || c == '\r' || c == '\t' ? -3 : -1;
}

void unpack(VtkPacking packing, std::span<const std::byte> from, std::span<std::byte> to, const Path& path) {
  auto* source = reinterpret_cast<const unsigned char*>(from.data());
  auto* target = reinterpret_cast<unsigned char*>(to.data());
  std::size_t got = 0;
  if (packing == VtkPacking::Deflate) {
    uLongf size = uLongf(to.size());
    got = ::uncompress(target, &size, source, uLong(from.size())) == Z_OK ? size : 0;
  } else {
    got = unpackByVtk(packing, from, to);
  }
  if (got != to.size()) refuse(path, "is damaged: a packed block of its values cannot be unpacked");
}

template <class From>
void toDoubles(std::span<std::byte> values) {
  for (std::size_t at = 0; at + 8 <= values.size(); at += 8) {
    From raw;
    std::memcpy(&raw, values.data() + at, 8);
    auto value = double(raw);
    std::memcpy(values.data() + at, &value, 8);
  }
}

}  // namespace

VtkXml::VtkXml(const FileBytes& file, std::string_view kind) : mFile(file) {
  if (file.size() == 0) refuse(file.path(), "is empty");
  mRoot = readXml(file, "AppendedData");
  if (mRoot.name != "VTKFile" || mRoot.attribute("type") != kind)
    refuse(file.path(), fmt::format("is not a VTK file of {}", kind));
  mData = mRoot.child(kind);
  if (!mData) refuse(file.path(), fmt::format("is cut short: it has no element {}", kind));
  mAppended = mRoot.child("AppendedData");
  mIsBigEndian = mRoot.attribute("byte_order") == "BigEndian";
  std::string_view word = mRoot.attribute("header_type"), codec = mRoot.attribute("compressor");
  if (!word.empty() && word != "UInt32" && word != "UInt64")
    refuse(file.path(), fmt::format("a header_type {} is not known", inQuotes(word)));
  mWordBytes = word == "UInt64" ? 8 : 4;
  constexpr std::pair<std::string_view, VtkPacking> kCodecs[] = {{"", VtkPacking::None},
                                                                 {"vtkZLibDataCompressor", VtkPacking::Deflate},
                                                                 {"vtkLZ4DataCompressor", VtkPacking::Lz4},
                                                                 {"vtkLZMADataCompressor", VtkPacking::Lzma}};
  auto known = std::find_if(std::begin(kCodecs), std::end(kCodecs), [&](auto& c) { return c.first == codec; });
  if (known == std::end(kCodecs)) refuse(file.path(), fmt::format("a compressor {} is not known", inQuotes(codec)));
  mPacking = known->second;
}

/// The stored bytes of an array, one after the other: as they stand, or out of base64.
class VtkArray::Source {
 public:
  Source(const VtkArray& array)
      : mFile(array.mXml.file()), mAt(array.mFrom), mEnd(array.mTo), mIsBase64(array.mIsBase64) {}

  /// More cannot come.
  std::uint64_t mostLeft() const { return mIsBase64 ? (mEnd - mAt + mText.size() - mPlace) / 4 * 3 + 3 : mEnd - mAt; }

  void read(std::span<std::byte> to) {
    if (to.size() > mostLeft()) refuseEnd();
    if (!mIsBase64) {
      mFile.read(mAt, to);
      mAt += to.size();
      return;
    }
    for (std::byte& byte : to) {
      if (mHeld == 0) takeQuad();
      byte = std::byte(mBytes[3 - mHeld]);
      --mHeld;
    }
  }
  std::uint64_t word(std::size_t bytes, bool isBigEndian) {
    std::array<std::byte, 8> raw{};
    read(std::span(raw).first(bytes));
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) value = value << 8 | std::uint64_t(raw[isBigEndian ? i : bytes - 1 - i]);
    return value;
  }

 private:
  [[noreturn]] void refuseEnd() const {
    refuse(mFile.path(), "is cut short: its values lie behind the end of the file");
  }

  int takeDigit() {
    for (;;) {
      if (mPlace == mText.size()) {
        if (mAt >= mEnd) refuseEnd();
        mText.resize(std::size_t(std::min<std::uint64_t>(kPiece, mEnd - mAt)));
        mFile.read(mAt, std::as_writable_bytes(std::span(mText)));
        mAt += mText.size();
        mPlace = 0;
      }
      int digit = base64Digit(mText[mPlace++]);
      if (digit == -1) refuse(mFile.path(), "is damaged or cut short: its base64 has other letters");
      if (digit != -3) return digit;
    }
  }
  /// Four letters, one to three bytes. What is padded may be followed by more: sizes are coded by themselves.
  void takeQuad() {
    std::array<int, 4> d;
    for (int& digit : d) digit = takeDigit();
    if (d[0] < 0 || d[1] < 0 || (d[2] < 0 && d[3] >= 0))
      refuse(mFile.path(), "is damaged: its base64 is padded wrongly");
    mHeld = d[2] < 0 ? 1 : d[3] < 0 ? 2 : 3;
    unsigned bits =
        unsigned(d[0]) << 18 | unsigned(d[1]) << 12 | unsigned(std::max(d[2], 0)) << 6 | unsigned(std::max(d[3], 0));
    // They stand at the end of the three that are held.
    for (std::size_t i = 0; i < mHeld; ++i) mBytes[3 - mHeld + i] = std::uint8_t(bits >> (16 - 8 * i));
  }

  const FileBytes& mFile;
  std::uint64_t mAt, mEnd;
  bool mIsBase64;
  std::string mText;
  std::size_t mPlace = 0, mHeld = 0;
  std::array<std::uint8_t, 3> mBytes{};
};

VtkArray::VtkArray(const VtkXml& xml, const XmlElement& element) : mXml(xml), mElement(element) {
  const Path& path = xml.file().path();
  constexpr std::pair<std::string_view, SampleType> kTypes[] = {
      {"UInt8", SampleType::UInt8},     {"Int8", SampleType::Int8},       {"UInt16", SampleType::UInt16},
      {"Int16", SampleType::Int16},     {"UInt32", SampleType::UInt32},   {"Int32", SampleType::Int32},
      {"Float32", SampleType::Float32}, {"Float64", SampleType::Float64}, {"UInt64", SampleType::Float64},
      {"Int64", SampleType::Float64}};
  std::string_view type = element.attribute("type"), format = element.attribute("format");
  auto known = std::find_if(std::begin(kTypes), std::end(kTypes), [&](auto& t) { return t.first == type; });
  if (known == std::end(kTypes)) refuse(path, fmt::format("samples of type {} are not read", inQuotes(type)));
  mType = known->second;
  mIsWide = type.ends_with("Int64");
  mIsUnsigned = type == "UInt64";
  std::string_view text = element.attribute("NumberOfComponents");
  double components = text.empty() ? 1.0 : numberIn(text).value_or(0.0);
  if (!(components >= 1 && components <= 1024) || components != std::floor(components))
    refuse(path, fmt::format("{} components make no sense", inQuotes(text)));
  mComponents = int(components);

  mIsText = format == "ascii";
  mIsBase64 = format == "binary";
  mFrom = element.textAt, mTo = element.textEnd;
  if (format == "appended") {
    const XmlElement* all = xml.appended();
    if (!all) refuse(path, "is cut short: it has no AppendedData");
    std::string_view encoding = all->attribute("encoding");
    mIsBase64 = encoding == "base64";
    std::string start(std::size_t(std::min<std::uint64_t>(256, all->textEnd - all->textAt)), '\0');
    xml.file().read(all->textAt, std::as_writable_bytes(std::span(start)));
    std::size_t mark = start.find_first_not_of(" \t\r\n");
    double offset = numberIn(element.attribute("offset")).value_or(-1.0);
    double from = double(all->textAt) + double(mark) + 1 + offset;
    if (mark == start.npos || start[mark] != '_' || !(offset >= 0) || from > double(all->textEnd))
      refuse(path, "is damaged or cut short: the values of an array lie behind the end of the file");
    mFrom = std::uint64_t(from), mTo = all->textEnd;
  } else if (!mIsText && !mIsBase64) {
    refuse(path, fmt::format("an array's format {} is not known", inQuotes(format)));
  }
}

void VtkArray::check(std::uint64_t values) const {
  const Path& path = mXml.file().path();
  double bytes = double(values) * double(sampleSize(mType));
  double most = mIsText ? double(mTo - mFrom + 1) / 2 * double(sampleSize(mType))
                        : double(Source(*this).mostLeft()) * expansionOf(mXml.packing());
  if (!(bytes <= most))
    refuse(path, fmt::format("the header promises {} values, more than a file of {} bytes can hold", values,
                             mXml.file().size()));
  if (mIsText || values == 0) return;
  Source source(*this);
  auto word = [&] { return source.word(mXml.wordBytes(), mXml.isBigEndian()); };
  if (mXml.packing() == VtkPacking::None) {
    if (std::uint64_t stored = word(); double(stored) < bytes)
      refuse(path, fmt::format("is damaged: an array has {} bytes where its values need {:.0f}", stored, bytes));
    return;
  }
  std::uint64_t blocks = word(), size = word(), last = word();
  double total = double(blocks) * double(size) - (last > 0 ? double(size) - double(last) : 0.0);
  if (blocks == 0 || double(blocks) > bytes || last > size || total != bytes)
    refuse(path,
           fmt::format("is damaged: its block table promises {:.0f} bytes where its values need {:.0f}", total, bytes));
  if (blocks > source.mostLeft() / mXml.wordBytes()) refuse(path, "is cut short within a block table");
}

void VtkArray::readBlocks(Source& source, std::span<std::byte> to, Progress& progress) const {
  auto word = [&] { return source.word(mXml.wordBytes(), mXml.isBigEndian()); };
  std::vector<std::uint64_t> sizes(static_cast<std::size_t>(word()));
  auto each = std::size_t(word());
  word();
  for (std::uint64_t& size : sizes) size = word();
  std::vector<std::byte> packed;
  for (std::size_t i = 0, at = 0; i < sizes.size(); ++i) {
    if (i % 64 == 0) progress.report(double(at) / double(to.size()), "reading VTK values");
    auto block = to.subspan(at, std::min(each, to.size() - at));
    if (sizes[i] > source.mostLeft())
      refuse(mXml.file().path(), "is cut short: a packed block of its values is not there");
    packed.resize(std::size_t(sizes[i]));
    source.read(packed);
    unpack(mXml.packing(), packed, block, mXml.file().path());
    at += block.size();
    if (i + 1 == sizes.size() && at != to.size())
      refuse(mXml.file().path(), "is damaged: its blocks do not fill its values");
  }
}

/// Numbers as text, in bites.
void VtkArray::readText(std::span<std::byte> to, Progress& progress) const {
  constexpr std::size_t kLongestNumber = 512;
  constexpr StoredType kStored[] = {StoredType::UInt8,  StoredType::Int8,  StoredType::UInt16,  StoredType::Int16,
                                    StoredType::UInt32, StoredType::Int32, StoredType::Float32, StoredType::Float64};
  const Path& path = mXml.file().path();
  std::string bite;
  std::string_view rest;
  std::uint64_t from = mFrom;
  std::size_t step = sampleSize(mType);
  auto passBlanks = [&] { rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n"), rest.size())); };
  for (std::size_t at = 0; at < to.size(); at += step) {
    // Refill when the next number may be cut in two.
    for (passBlanks(); rest.size() < kLongestNumber && from < mTo; passBlanks()) {
      std::string more(rest);
      more.resize(rest.size() + std::size_t(std::min<std::uint64_t>(kPiece, mTo - from)));
      mXml.file().read(from, std::as_writable_bytes(std::span(more).subspan(rest.size())));
      from += more.size() - rest.size();
      bite = std::move(more);
      rest = bite;
      progress.report(double(at) / double(to.size()), "reading VTK values");
    }
    auto value = takeNumber(rest);
    if (!value) refuse(path, fmt::format("has {} numbers where {} are needed", at / step, to.size() / step));
    storeNumber(*value, kStored[static_cast<int>(mType)], to.data() + at);
  }
}

void VtkArray::read(std::span<std::byte> to, Progress& progress) const {
  if (to.empty()) return;
  if (mIsText) return readText(to, progress);
  Source source(*this);
  if (mXml.packing() == VtkPacking::None) {
    source.word(mXml.wordBytes(), mXml.isBigEndian());
    for (std::size_t at = 0; at < to.size(); at += kPiece) {
      progress.report(double(at) / double(to.size()), "reading VTK values");
      source.read(to.subspan(at, std::min(kPiece, to.size() - at)));
    }
  } else {
    readBlocks(source, to, progress);
  }
  toMachineOrder(to, sampleSize(mType), mXml.isBigEndian());
  if (mIsWide) mIsUnsigned ? toDoubles<std::uint64_t>(to) : toDoubles<std::int64_t>(to);
}

}  // namespace velum::io
