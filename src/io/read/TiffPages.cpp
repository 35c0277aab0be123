#include "io/read/TiffPages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <istream>
#include <unordered_set>

#include "core/Error.h"

namespace velum::io {

namespace {

constexpr std::uint64_t kMostSubPages = 64;
constexpr std::uint64_t kMaxDescription = 64u << 20;

struct Entry {
  std::uint64_t tag = 0, type = 0, count = 0;
  std::uint64_t valueAt = 0;  ///< Where the values lie: in the entry itself when they fit, else elsewhere.
};

/// One pass over one file. Reads outside the file give zero and set `leftFile`.
class Scanner {
 public:
  Scanner(std::istream& file, const std::string& name) : mFile(file), mName(name) {
    mFile.clear();
    mFile.seekg(0, std::ios::end);
    mSize = std::uint64_t(std::max<std::streamoff>(0, mFile.tellg()));
  }

  TiffPages scan(std::size_t mostPages) {
    std::uint64_t next = readHeader();
    std::unordered_set<std::uint64_t> seen;
    while (next != 0 && mResult.pages.size() < mostPages) {
      if (!seen.insert(next).second) {  // a chain that bites its tail
        mResult.isTruncated = true;
        break;
      }
      TiffPage page;
      page.at = next;
      next = readPage(page);
      if (isUsable(page)) mResult.pages.push_back(page);
      if (mLeftFile) {
        mResult.isTruncated = true;
        break;
      }
    }
    return std::move(mResult);
  }

  std::vector<TiffPage> scanBelow(const TiffPage& above) {
    readHeader();
    std::vector<TiffPage> pages;
    for (std::uint64_t at : above.subPages) {
      TiffPage page;
      page.at = at;
      readPage(page);
      if (!isUsable(page)) break;
      pages.push_back(page);
    }
    return pages;
  }

 private:
  bool isUsable(const TiffPage& page) const { return page.width > 0 && (!mLeftFile || page.isDataInside); }

  std::uint64_t readPage(TiffPage& page) {
    mLeftFile = false;
    std::uint64_t next = readDirectory(page);
    if (page.width == 0 || page.height == 0) {
      mLeftFile = true;
      page.width = 0;
    }
    return next;
  }

  std::uint64_t number(std::uint64_t at, std::size_t bytes) {
    if (at > mSize || mSize - at < bytes) {
      mLeftFile = true;
      return 0;
    }
    if (at < mWindowAt || at + bytes > mWindowAt + mWindow.size()) loadWindow(at);
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) {
      auto byte = std::uint64_t(std::uint8_t(mWindow[std::size_t(at - mWindowAt) + i]));
      value |= byte << (8 * (mResult.isBigEndian ? bytes - 1 - i : i));
    }
    return value;
  }

  void loadWindow(std::uint64_t at) {
    mWindowAt = at;
    mWindow.assign(std::size_t(std::min<std::uint64_t>(1u << 14, mSize - at)), '\0');
    mFile.clear();
    mFile.seekg(std::streamoff(at));
    mFile.read(mWindow.data(), std::streamsize(mWindow.size()));
  }

  /// Directories and strip tables of an honest file do not overlap, so together they are no larger than the file.
  /// Without this a small hostile file could make us walk the same bytes for hours.
  bool spend(std::uint64_t bytes) {
    mSpent += bytes;
    if (mSpent > mSize + 4096) mLeftFile = true;
    return !mLeftFile;
  }

  std::uint64_t readHeader() {
    std::uint64_t order = number(0, 2);
    mResult.isBigEndian = order == 0x4d4d;
    std::uint64_t magic = number(2, 2);
    if ((order != 0x4d4d && order != 0x4949) || (magic != 42 && magic != 43))
      throw InputError(fmt::format("{}: is not a TIFF file", mName));
    mIsBig = magic == 43;
    return mIsBig ? number(8, 8) : number(4, 4);
  }

  static std::size_t typeSize(std::uint64_t type) {
    constexpr std::array<std::size_t, 19> kSizes = {0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4, 0, 0, 8, 8, 8};
    return type < kSizes.size() ? kSizes[type] : 0;
  }

  Entry entryAt(std::uint64_t at) {
    Entry e{number(at, 2), number(at + 2, 2), number(at + 4, mIsBig ? 8 : 4), at + (mIsBig ? 12 : 8)};
    std::size_t inlineBytes = mIsBig ? 8 : 4;
    std::size_t size = typeSize(e.type);
    bool fits = size == 0 || e.count <= inlineBytes / size;
    if (!fits) e.valueAt = number(e.valueAt, inlineBytes);
    return e;
  }

  std::uint64_t value(const Entry& e, std::uint64_t index = 0) {
    std::size_t size = typeSize(e.type);
    if (size == 0 || index >= e.count || e.valueAt > mSize) return 0;
    return number(e.valueAt + index * size, e.type == 5 || e.type == 10 ? 4 : size);
  }

  double rational(const Entry& e) {
    if (e.type != 5 || e.count < 1) return 0;
    double below = double(number(e.valueAt + 4, 4));
    return below > 0 ? double(number(e.valueAt, 4)) / below : 0;
  }

  std::string text(const Entry& e) {
    if (e.valueAt > mSize) return {};
    std::string s(std::size_t(std::min({e.count, kMaxDescription, mSize - e.valueAt})), '\0');
    mFile.clear();
    mFile.seekg(std::streamoff(e.valueAt));
    mFile.read(s.data(), std::streamsize(s.size()));
    s.resize(std::size_t(std::max<std::streamsize>(0, mFile.gcount())));
    return s.substr(0, s.find('\0'));
  }

  void addStrips(TiffPage& page, const Entry& offsets, const Entry& counts) {
    page.firstStrip = value(offsets);
    std::uint64_t strips = std::min(offsets.count, counts.count);
    if (strips > mSize || !spend(strips * (typeSize(offsets.type) + typeSize(counts.type)))) {
      page.isDataInside = false;
      return;
    }
    // Two passes, so that each table is read in order.
    std::vector<std::uint64_t> bytes(std::size_t(strips), 0);
    for (std::uint64_t i = 0; i < strips; ++i)
      page.dataBytes += bytes[std::size_t(i)] = std::min(value(counts, i), mSize);
    std::uint64_t next = page.firstStrip;
    for (std::uint64_t i = 0; i < strips; ++i) {
      std::uint64_t at = value(offsets, i);
      if (at > mSize || bytes[std::size_t(i)] > mSize - at) page.isDataInside = false;
      page.isOneStretch = page.isOneStretch && at == next;
      next = at + bytes[std::size_t(i)];
    }
  }

  std::uint64_t readDirectory(TiffPage& page) {
    std::uint64_t count = number(page.at, mIsBig ? 8 : 2);
    std::uint64_t first = page.at + (mIsBig ? 8 : 2);
    std::uint64_t entrySize = mIsBig ? 20 : 12;
    if (mLeftFile || count == 0 || count > 4096 || !spend(count * entrySize)) {
      mLeftFile = true;
      return 0;
    }
    Entry offsets, counts;
    for (std::uint64_t i = 0; i < count; ++i) {
      Entry e = entryAt(first + i * entrySize);
      if (e.tag == 273 || e.tag == 324) offsets = e;
      if (e.tag == 279 || e.tag == 325) counts = e;
      takeEntry(e, page);
    }
    addStrips(page, offsets, counts);
    return number(first + count * entrySize, mIsBig ? 8 : 4);
  }

  void takeEntry(const Entry& e, TiffPage& page) {
    struct Field {
      std::uint64_t tag;
      std::uint64_t TiffPage::*value;
    };
    static constexpr Field kFields[] = {
        {256, &TiffPage::width},          {257, &TiffPage::height},      {258, &TiffPage::bits},
        {259, &TiffPage::compression},    {262, &TiffPage::photometric}, {266, &TiffPage::fillOrder},
        {277, &TiffPage::samples},        {278, &TiffPage::tileHeight},  {284, &TiffPage::planar},
        {296, &TiffPage::resolutionUnit}, {322, &TiffPage::tileWidth},   {323, &TiffPage::tileHeight},
        {339, &TiffPage::sampleFormat}};
    for (const Field& field : kFields)
      if (e.tag == field.tag) page.*field.value = value(e);
    if (e.tag == 254) page.isReduced = value(e) & 1;
    if (e.tag == 270 && mResult.pages.empty()) mResult.description = text(e);
    if (e.tag == 282) page.xResolution = rational(e);
    if (e.tag == 283) page.yResolution = rational(e);
    if (e.tag == 330)
      for (std::uint64_t i = 0; i < std::min(e.count, kMostSubPages); ++i) page.subPages.push_back(value(e, i));
  }

  std::istream& mFile;
  const std::string& mName;
  std::uint64_t mSize = 0;
  std::uint64_t mSpent = 0, mWindowAt = 0;
  std::string mWindow;
  bool mIsBig = false, mLeftFile = false;
  TiffPages mResult;
};

}  // namespace

std::vector<TiffPage> scanSubPages(std::istream& file, const std::string& name, const TiffPage& page) {
  return Scanner(file, name).scanBelow(page);
}

TiffPages scanTiff(std::istream& file, const std::string& name, std::size_t mostPages) {
  TiffPages result = Scanner(file, name).scan(mostPages);
  if (result.pages.empty()) throw InputError(fmt::format("{}: the TIFF file is damaged: no page can be read", name));
  return result;
}

}  // namespace velum::io
