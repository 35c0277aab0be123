#include "FileTools.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "velum/core/Error.h"

namespace velum::io {

void refuse(const std::filesystem::path& path, std::string_view reason) {
  throw InputError(fmt::format("{}: {}", path.string(), reason));
}

FileBytes::FileBytes(const std::filesystem::path& path)
    : mPath(path), mFile(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  struct stat info {};
  if (mFile < 0) refuse(path, fmt::format("cannot be opened ({})", std::strerror(errno)));
  if (::fstat(mFile, &info) != 0 || !S_ISREG(info.st_mode)) {
    ::close(mFile);
    refuse(path, "is not a file");
  }
  mSize = std::uint64_t(info.st_size);
}

FileBytes::~FileBytes() { ::close(mFile); }

void FileBytes::read(std::uint64_t at, std::span<std::byte> to) const {
  while (!to.empty()) {
    ssize_t got = ::pread(mFile, to.data(), to.size(), off_t(at));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse(mPath, fmt::format("cannot be read ({})", std::strerror(errno)));
    if (got == 0) refuse(mPath, "the file is cut short");
    to = to.subspan(std::size_t(got));
    at += std::uint64_t(got);
  }
}

std::string FileBytes::head(std::size_t most) const {
  std::string text(std::size_t(std::min<std::uint64_t>(most, mSize)), '\0');
  read(0, std::as_writable_bytes(std::span(text)));
  return text;
}

GzipFile::GzipFile(const std::filesystem::path& path) : mPath(path) {
  FileBytes check(path);  // for its messages
  mFile = ::gzopen(path.c_str(), "rb");
  if (!mFile) refuse(path, "cannot be opened");
  ::gzbuffer(static_cast<gzFile>(mFile), 1u << 18);
}

GzipFile::~GzipFile() { ::gzclose(static_cast<gzFile>(mFile)); }

std::size_t GzipFile::readSome(std::span<std::byte> to) {
  std::size_t done = 0;
  while (done < to.size()) {
    auto wanted = unsigned(std::min<std::size_t>(to.size() - done, 1u << 24));
    int got = ::gzread(static_cast<gzFile>(mFile), to.data() + done, wanted);
    int error = Z_OK;
    const char* words = ::gzerror(static_cast<gzFile>(mFile), &error);
    // A stream that was cut short gives what it had and says so only here.
    if (got < 0 || (error != Z_OK && error != Z_STREAM_END))
      refuse(mPath, fmt::format("the compressed data is damaged ({})", words));
    if (got == 0) break;
    done += std::size_t(got);
  }
  return done;
}

void GzipFile::read(std::span<std::byte> to) {
  if (readSome(to) != to.size()) refuse(mPath, "the file is cut short");
}

std::uint64_t GzipFile::skip(std::uint64_t count) {
  std::array<std::byte, 65536> scratch;
  std::uint64_t done = 0;
  while (done < count) {
    std::size_t got =
        readSome(std::span(scratch).first(std::size_t(std::min<std::uint64_t>(count - done, scratch.size()))));
    if (got == 0) break;
    done += got;
  }
  return done;
}

std::uint64_t GzipFile::mostBytes() const { return std::filesystem::file_size(mPath) * 1032; }

std::size_t checkedBytes(const std::filesystem::path& path, glm::dvec3 dims, double channels, double frames,
                         SampleType type, double mostBytes) {
  constexpr double kMost = 1u << 30;
  for (double d : {dims.x, dims.y, dims.z, channels, frames})
    if (!(d >= 1 && d <= kMost))
      refuse(path, fmt::format(
                       "a volume of {:.0f} x {:.0f} x {:.0f} voxels, {:.0f} channels and {:.0f} frames makes no sense",
                       dims.x, dims.y, dims.z, channels, frames));
  // Five factors of 2^30 fit a double, and products of interest (below 2^53) are exact.
  double bytes = dims.x * dims.y * dims.z * channels * frames * double(sampleSize(type));
  if (bytes > mostBytes || bytes > 1e13)
    refuse(path, fmt::format("the header promises {:.0f} bytes of voxels, but the file can hold {:.0f} at most", bytes,
                             mostBytes));
  return std::size_t(bytes);
}

void swapBytes(std::span<std::byte> bytes, std::size_t sampleBytes) {
  auto swapAll = [&](auto one, auto swap) {
    for (std::size_t at = 0; at + sizeof(one) <= bytes.size(); at += sizeof(one)) {
      std::memcpy(&one, bytes.data() + at, sizeof(one));
      one = swap(one);
      std::memcpy(bytes.data() + at, &one, sizeof(one));
    }
  };
  if (sampleBytes == 2) swapAll(std::uint16_t{}, [](std::uint16_t v) { return __builtin_bswap16(v); });
  if (sampleBytes == 4) swapAll(std::uint32_t{}, [](std::uint32_t v) { return __builtin_bswap32(v); });
  if (sampleBytes == 8) swapAll(std::uint64_t{}, [](std::uint64_t v) { return __builtin_bswap64(v); });
}

glm::dmat4 gridMatrix(glm::dvec3 s, glm::dvec3 o) {
  return {{s.x, 0.0, 0.0, 0.0}, {0.0, s.y, 0.0, 0.0}, {0.0, 0.0, s.z, 0.0}, {o.x, o.y, o.z, 1.0}};
}

void applySpacing(Volume& volume, const scene::Source& source) {
  for (int axis = 0; axis < 3; ++axis) {
    double wanted = source.spacingMm[axis];
    auto& column = volume.worldFromVoxel[axis];
    double length = glm::length(glm::dvec3(column));
    if (wanted > 0 && std::isfinite(wanted) && length > 0) column *= wanted / length;
  }
  if (glm::all(glm::greaterThan(source.spacingMm, glm::dvec3(0.0)))) volume.isSpacingKnown = true;
  const std::string words = "the file has no voxel spacing, 1 mm is taken; give it as spacing in mm (x, y, z)";
  if (!volume.isSpacingKnown &&
      std::find(volume.warnings.begin(), volume.warnings.end(), words) == volume.warnings.end())
    volume.warnings.push_back(words);
}

bool naturalLess(std::string_view a, std::string_view b) {
  auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (!isDigit(a[i]) || !isDigit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
      continue;
    }
    // Numbers of any length: without leading zeros the longer is the larger.
    while (i < a.size() && a[i] == '0') ++i;
    while (j < b.size() && b[j] == '0') ++j;
    std::size_t ie = i, je = j;
    while (ie < a.size() && isDigit(a[ie])) ++ie;
    while (je < b.size() && isDigit(b[je])) ++je;
    if (ie - i != je - j) return ie - i < je - j;
    int order = a.substr(i, ie - i).compare(b.substr(j, je - j));
    if (order != 0) return order < 0;
    i = ie, j = je;
  }
  if (a.size() - i != b.size() - j) return a.size() - i < b.size() - j;
  return a < b;  // "1" and "01": some order that is always the same
}

std::vector<std::filesystem::path> filesInOrder(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.is_regular_file(error) && !entry.path().filename().string().starts_with('.'))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end(),
            [](const auto& a, const auto& b) { return naturalLess(a.filename().string(), b.filename().string()); });
  return files;
}

std::string titleOf(const std::filesystem::path& path) {
  auto name = path.has_filename() ? path.stem() : path.parent_path().stem();
  return name.string();
}

}  // namespace velum::io
