#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/Error.h"
#include "core/Text.h"
#include "io/read/ByteSource.h"
#include "io/read/Placement.h"
#include "io/read/SampleBytes.h"
#include "io/volumes/Readers.h"

namespace velum::io {

namespace {

constexpr std::uint64_t kMaxPlist = 1u << 20;
constexpr int kMaxMembers = 10'000;

/// What main.plist says of the voxels.
struct Project {
  std::string matrixFile = "matrix.dat", dtype = "int16", modality, name;
  std::array<double, 3> shape{};    ///< z, y, x, as NumPy has it.
  std::array<double, 3> spacing{};  ///< x, y, z in mm.
  int orientation = 1;              ///< 1 axial, 2 coronal, 3 sagittal: of the slices that were imported.
};

/// Text between the first `<tag>` after `at` and its end; moves `at` behind it. Nothing when there is none before
/// `end`.
std::optional<std::string_view> element(std::string_view text, std::string_view tag, std::size_t& at, std::size_t end) {
  std::string open = fmt::format("<{}>", tag), close = fmt::format("</{}>", tag);
  std::size_t from = text.find(open, at);
  if (from == text.npos || from >= end) return {};
  from += open.size();
  std::size_t to = text.find(close, from);
  if (to == text.npos || to > end) return {};
  at = to + close.size();
  return text.substr(from, to - from);
}

/// Where the value of a key starts.
std::optional<std::size_t> valueOf(std::string_view text, std::string_view key) {
  std::string wanted = fmt::format("<key>{}</key>", key);
  std::size_t at = text.find(wanted);
  if (at == text.npos) return {};
  return at + wanted.size();
}

std::string stringOf(std::string_view text, std::string_view key, std::string_view otherwise) {
  auto at = valueOf(text, key);
  if (!at) return std::string(otherwise);
  // The value is the very next element; a later <string> belongs to another key.
  auto value = element(text, "string", *at, std::min(text.size(), text.find("<key>", *at)));
  return std::string(value.value_or(otherwise).substr(0, 4096));
}

double numberOf(std::string_view text) { return takeNumber(text).value_or(std::nan("")); }

std::array<double, 3> threeOf(std::string_view text, std::string_view key, const Path& path) {
  std::array<double, 3> out{};
  auto at = valueOf(text, key);
  auto inner = at ? element(text, "array", *at, std::min(text.size(), text.find("<key>", *at))) : std::nullopt;
  if (!inner) refuse(path, fmt::format("main.plist has no '{}'", key));
  std::size_t place = 0;
  for (double& number : out) {
    std::size_t asInteger = place, asReal = place;
    auto integer = element(*inner, "integer", asInteger, inner->size());
    auto real = element(*inner, "real", asReal, inner->size());
    bool isReal = real && (!integer || asReal < asInteger);
    if (!integer && !real) refuse(path, fmt::format("'{}' in main.plist has fewer than three numbers", key));
    number = numberOf(isReal ? *real : *integer);
    place = isReal ? asReal : asInteger;
  }
  return out;
}

Project parseProject(std::string_view text, const Path& path) {
  Project p;
  p.matrixFile = stringOf(text, "filename", p.matrixFile);
  p.dtype = stringOf(text, "dtype", p.dtype);
  p.modality = stringOf(text, "modality", "");
  p.name = stringOf(text, "name", "");
  p.shape = threeOf(text, "shape", path);
  p.spacing = threeOf(text, "spacing", path);
  if (auto at = valueOf(text, "orientation"))
    if (auto value = element(text, "integer", *at, text.size()))
      p.orientation = int(std::clamp(std::round(numberOf(*value)), 0.0, 9.0));
  return p;
}

/// A tar archive, plain or gzipped, walked member by member.
class TarWalker {
 public:
  explicit TarWalker(const Path& path) : mFile(path), mPath(path) {}

  /// Moves to the member whose base name this is; its size in bytes, or nothing at the end of the archive.
  std::optional<std::uint64_t> find(std::string_view wanted) {
    for (int member = 0; member < kMaxMembers; ++member) {
      std::array<char, 512> header{};
      if (mFile.readSome(std::as_writable_bytes(std::span(header))) != header.size() || header[0] == '\0') return {};
      if (!hasValidSum(header)) refuse(mPath, "is not an InVesalius project (no tar archive inside)");
      std::uint64_t size = octal(std::span(header).subspan(124, 12));
      std::string_view name(header.data(), 100);
      name = name.substr(0, name.find('\0'));
      name.remove_prefix(name.rfind('/') + 1);  // npos + 1 is 0
      if (name == wanted && (header[156] == '0' || header[156] == '\0')) return size;
      std::uint64_t padded = (size + 511) / 512 * 512;
      if (mFile.skip(padded) != padded) refuse(mPath, "the archive is cut short");
    }
    return {};
  }

  ByteSource& file() { return mFile; }

 private:
  static std::uint64_t octal(std::span<const char> field) {
    std::uint64_t value = 0;
    for (char c : field)
      if (c >= '0' && c <= '7') value = value * 8 + std::uint64_t(c - '0');
    return value;
  }

  static bool hasValidSum(const std::array<char, 512>& header) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < header.size(); ++i)
      sum += i >= 148 && i < 156 ? ' ' : static_cast<unsigned char>(header[i]);
    return sum == octal(std::span(header).subspan(148, 8));
  }

  ByteSource mFile;
  const Path& mPath;
};

Project readProject(const Path& path) {
  TarWalker archive(path);
  auto size = archive.find("main.plist");
  if (!size) refuse(path, "is not an InVesalius project (no main.plist inside)");
  if (*size > kMaxPlist)
    refuse(path, fmt::format("main.plist has {} bytes; more than {} are not read", *size, kMaxPlist));
  std::string text(std::size_t(*size), '\0');
  archive.file().read(std::as_writable_bytes(std::span(text)));
  return parseProject(text, path);
}

SampleType typeOf(const Project& project, const Path& path) {
  for (auto [name, type] : {std::pair{"int16", SampleType::Int16},
                            {"uint8", SampleType::UInt8},
                            {"uint16", SampleType::UInt16},
                            {"int8", SampleType::Int8},
                            {"int32", SampleType::Int32},
                            {"float32", SampleType::Float32}})
    if (project.dtype == name) return type;
  refuse(path, fmt::format("voxels of type '{}' are not read", project.dtype));
}

/// The place of the matrix in the patient. InVesalius flips every imported slice upside down (as VTK wants it), so that
/// the second axis runs to the Anterior; the first runs to the Left and the third to the Superior, as in DICOM. Seen on
/// the example project Cranium.inv3: nose at large y, vertex at large z.
glm::dmat4 patientFromVoxel(const Project& p) {
  glm::dmat4 m = gridMatrix({p.spacing[0], p.spacing[1], p.spacing[2]});
  m[1] = -m[1];
  m[3].y = p.spacing[1] * (p.shape[1] - 1);
  return m;
}

}  // namespace

Volume readInvesalius(const scene::Source& source, Progress& progress) {
  const Path path = source.path;
  progress.report(0, "reading InVesalius project");
  Project project = readProject(path);

  Volume volume;
  volume.type = typeOf(project, path);
  for (double s : project.spacing)
    if (!(s > 0 && s < 1e6)) refuse(path, fmt::format("a voxel spacing of {:.6g} mm makes no sense", s));
  glm::dvec3 dims(project.shape[2], project.shape[1], project.shape[0]);
  for (int i = 0; i < 3; ++i)
    if (dims[i] != std::floor(dims[i])) refuse(path, fmt::format("{} voxels along an axis make no sense", dims[i]));

  TarWalker archive(path);
  auto stored = archive.find(std::filesystem::path(project.matrixFile).filename().string());
  if (!stored) refuse(path, fmt::format("the project has no voxels ('{}' is missing)", project.matrixFile));
  double most = double(std::min(archive.file().mostBytes(), *stored));
  std::size_t bytes = checkedBytes(path, dims, 1, 1, sampleSize(volume.type), most);
  if (bytes != *stored)
    refuse(path, fmt::format("the voxels need {} bytes, but '{}' has {}", bytes, project.matrixFile, *stored));
  volume.dims = glm::ivec3(dims);
  volume.voxels.resize(bytes);
  for (std::size_t at = 0; at < bytes; at += std::size_t(1) << 22) {
    progress.report(double(at) / double(bytes), "reading InVesalius project");
    archive.file().read(
        std::span<std::byte>(volume.voxels).subspan(at, std::min<std::size_t>(bytes - at, std::size_t(1) << 22)));
  }
  toMachineOrder(volume.voxels, sampleSize(volume.type), false);

  volume.worldFromVoxel = patientFromVoxel(project);
  volume.name = project.name;
  if (project.modality == "CT") volume.modality = Modality::CT, volume.unit = "HU";
  if (project.modality == "MR" || project.modality == "MRI") volume.modality = Modality::MR;
  if (project.orientation != 1)
    volume.warnings.push_back("the project's slices were not axial; its axes are taken as axial ones");
  return volume;
}

}  // namespace velum::io
